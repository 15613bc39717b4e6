#include "import/doom/lights.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <span>
#include <utility>

#include "math/box.h"

namespace hearth::doom {

namespace {

using Json = nlohmann::ordered_json;

/// Metres from a surface that shines to the light that stands for it.
constexpr double kBefore = 0.25;

/// Metres. A light lights no wall in whose plane it lies, and walls of maps lie at whole units: so
/// it is put about a centimetre beside, where there is room for that.
constexpr std::array<Vec2, 4> kBeside{
    {{0.011, 0.007}, {-0.011, -0.007}, {0.011, -0.007}, {-0.011, 0.007}}};

double rounded(double metres) { return std::round(metres * 1000) / 1000; }

/// intensity / (falloff * d + 1), less what that is at the reach and made as bright as before at
/// the beginning: intensity * (1 - d / reach) / (falloff * d + 1). Straight in between.
Json curveOf(const Glow& glow) {
  Json curve = Json::array();
  for (const double fraction : {0.0, 1.0 / 16, 1.0 / 8, 1.0 / 4, 1.0 / 2, 1.0}) {
    const double d = fraction * glow.reach;
    const double level = glow.intensity * (1 - fraction) / (glow.falloff * d + 1);
    curve.push_back({rounded(d), std::round(level * 10) / 10});
  }
  return curve;
}

/// The mean of an image, as bright as its hue can be; white without an image, and of a black one.
std::string hueOf(const Image* image) {
  std::array<std::uint64_t, 3> sums{};
  for (const Rgb pixel : image ? std::span(image->pixels()) : std::span<const Rgb>{}) {
    sums[0] += pixel.r;
    sums[1] += pixel.g;
    sums[2] += pixel.b;
  }
  const std::uint64_t most = std::ranges::max(sums);
  if (most == 0) return "#ffffff";
  for (std::uint64_t& sum : sums) sum = (255 * sum + most / 2) / most;
  return fmt::format("#{:02x}{:02x}{:02x}", sums[0], sums[1], sums[2]);
}

class Illuminator {
 public:
  Illuminator(const GroundPlan& plan, const LightTable& table, const Materials& materials,
              const LightSettings& settings, Findings& findings)
      : plan_(plan),
        table_(table),
        materials_(materials),
        settings_(settings),
        findings_(findings) {}

  Json file() {
    findLights();
    Json file{{"version", 1}, {"lights", std::move(lights_)}};
    if (settings_.from == LightFrom::Points) return file;
    if (isUnderSky_) lightFromSky(file);
    if (!emit_.empty()) file["emit"] = std::move(emit_);
    return file;
  }

 private:
  void findLights() {
    for (const Thing& thing : plan_.map().things) lightThing(thing);
    for (std::uint32_t region = 0; region < plan_.regions().size(); ++region) {
      if (isClosed(plan_.spaceOf(region))) continue;
      isUnderSky_ |= plan_.spaceOf(region).isUnderSky;
      for (const auto& loop : plan_.regions()[region].loops)
        for (const std::uint32_t h : loop) lightWall(region, h);
      lightFlats(region, plan_.lastingSpaceOf(region));
    }
  }

  void lightFromSky(Json& file) const {
    if (const auto& sun = table_.sun)
      file["suns"] = {{{"angle", sun->angle},
                       {"pitch", sun->pitch},
                       {"intensity", sun->intensity},
                       {"color", sun->color},
                       {"size", sun->size}}};
    if (table_.sky.intensity > 0)
      file["sky"] = {{"intensity", table_.sky.intensity},
                     {"color", table_.sky.color.value_or(hueOf(materials_.skyImage()))}};
  }

  /// Makes an image an emitter; false if lights are to stand before the surfaces that wear it.
  bool makeEmitter(const Glow& glow, const std::string& image) {
    if (settings_.from == LightFrom::Points || glow.emit == 0 || !materials_.find(image))
      return false;
    emit_[image] = {{"intensity", glow.emit}, {"color", glow.color}};
    return true;
  }

  static bool isClosed(const Space& space) { return space.floor == space.ceiling; }

  template <typename Key>
  static const Glow* find(const std::map<Key, Glow>& glows, const Key& key) {
    const auto found = glows.find(key);
    return found == glows.end() ? nullptr : &found->second;
  }

  void lightThing(const Thing& thing) {
    const Glow* glow = find(table_.things, thing.type);
    const Vec2 place = placeOf(thing.x, thing.y);
    const auto region = plan_.regionAt(place);
    if (!glow || !region || !isThere(thing, settings_.game)) return;
    if (isClosed(plan_.spaceOf(*region))) return;
    const Space space = plan_.lastingSpaceOf(*region);
    const double highest = std::max(space.ceiling - kBefore, (space.floor + space.ceiling) / 2);
    add(*glow, *region, place, std::min(space.floor + glow->height, highest));
  }

  /// A light before the middle of each part of a wall that shines.
  void lightWall(std::uint32_t region, std::uint32_t h) {
    const HalfEdge& edge = plan_.halfEdge(h);
    const double metres = length(edge.to - edge.from);
    const Vec2 inwards = (1 / metres) * turned90(edge.to - edge.from);
    for (const ShownPart& part : plan_.shownParts(h)) {
      const Glow* glow = find(table_.walls, part.texture);
      if (!glow || part.bottom == part.top) continue;
      if (part.part != WallPart::Middle && makeEmitter(*glow, wallImage(part.texture))) continue;
      const int across = partsOf(metres, glow->every);
      const int up = partsOf(part.top - part.bottom, glow->every);
      for (int i = 0; i < across; ++i) {
        const auto place = before(region, lerp(edge.from, edge.to, (i + 0.5) / across), inwards);
        for (int k = 0; place && k < up; ++k)
          add(*glow, region, *place,
              inLastingSpace(region, part.bottom + (part.top - part.bottom) * (k + 0.5) / up));
      }
    }
  }

  /// What shines on a wall may lie where a flat moves to.
  double inLastingSpace(std::uint32_t region, double z) const {
    if (plan_.moversOf(region).empty()) return z;
    const Space space = plan_.lastingSpaceOf(region);
    const double gap = std::min(kBefore, (space.ceiling - space.floor) / 2);
    return std::clamp(z, space.floor + gap, space.ceiling - gap);
  }

  static int partsOf(double metres, double every) {
    return std::max(1, static_cast<int>(std::lround(metres / every)));
  }

  /// As far before a wall as there is room.
  std::optional<Vec2> before(std::uint32_t region, Vec2 onWall, Vec2 inwards) const {
    for (const double distance : {kBefore, kBefore / 2, kBefore / 8})
      if (const Vec2 place = onWall + distance * inwards; plan_.contains(region, place))
        return place;
    return std::nullopt;
  }

  void lightFlats(std::uint32_t region, const Space& space) {
    const double gap = std::min(kBefore, (space.ceiling - space.floor) / 2);
    const Sector& sector = plan_.sectorOf(region);
    lightFlat(region, sector.ceilingFlat, space.ceiling - gap);
    lightFlat(region, sector.floorFlat, space.floor + gap);
  }

  void lightFlat(std::uint32_t region, const std::string& flat, double z) {
    const Glow* glow = find(table_.flats, flat);
    if (!glow || makeEmitter(*glow, flatImage(flat))) return;
    for (const Vec2 place : placesOn(region, glow->every)) add(*glow, region, place, z);
  }

  /// The middles of the squares of a region; its own where it is hardly more than one.
  std::vector<Vec2> placesOn(std::uint32_t region, double every) const {
    Box box;
    for (const std::uint32_t h : plan_.regions()[region].loops.front())
      box.add(plan_.halfEdge(h).from);
    const Vec2 middle = lerp(box.min, box.max, 0.5);
    if (box.longerSide() <= 1.5 * every)
      return plan_.contains(region, middle) ? std::vector<Vec2>{middle} : placeAtBorder(region);
    std::vector<Vec2> places;
    for (double row = std::floor(box.min.y / every); row * every < box.max.y; ++row)
      addPlacesInRow(region, every, (row + 0.5) * every, places);
    return places.empty() ? placeAtBorder(region) : places;
  }

  /// Between walls, not square by square: a huge region has few walls and millions of squares.
  void addPlacesInRow(std::uint32_t region, double every, double y,
                      std::vector<Vec2>& places) const {
    const std::vector<double> walls = wallsInRow(region, y);
    for (std::size_t i = 0; i + 1 < walls.size(); i += 2)
      for (double column = std::ceil(walls[i] / every - 0.5); (column + 0.5) * every < walls[i + 1];
           ++column) {
        if (places.size() > settings_.most) return;
        places.push_back({(column + 0.5) * every, y});
      }
  }

  /// Where they cross it, from left to right: the region lies between the first and the second, the
  /// third and the fourth, and so on.
  std::vector<double> wallsInRow(std::uint32_t region, double y) const {
    std::vector<double> walls;
    for (const auto& loop : plan_.regions()[region].loops)
      for (const std::uint32_t h : loop) {
        const auto& [from, to] = std::pair(plan_.halfEdge(h).from, plan_.halfEdge(h).to);
        if ((from.y <= y) != (to.y <= y))
          walls.push_back(from.x + (to.x - from.x) * ((y - from.y) / (to.y - from.y)));
      }
    std::ranges::sort(walls);
    return walls;
  }

  std::vector<Vec2> placeAtBorder(std::uint32_t region) const {
    for (const std::uint32_t h : plan_.regions()[region].loops.front()) {
      const HalfEdge& edge = plan_.halfEdge(h);
      const Vec2 along = edge.to - edge.from;
      if (const auto place =
              before(region, lerp(edge.from, edge.to, 0.5), (1 / length(along)) * turned90(along)))
        return {*place};
    }
    return {};
  }

  void add(const Glow& glow, std::uint32_t region, Vec2 place, double z) {
    if (isClosed(plan_.lastingSpaceOf(region))) return tellOfClosing(region);
    if (lights_.size() == settings_.most) return tellOfTooMany(region);
    for (const Vec2 beside : kBeside) {
      const Vec2 p{rounded(place.x + beside.x), rounded(place.y + beside.y)};
      if (!plan_.contains(region, p)) continue;
      lights_.push_back({{"x", p.x},
                         {"y", p.y},
                         {"z", rounded(z)},
                         {"sector", plan_.nameOf(region)},
                         {"color", glow.color},
                         {"curve", curveOf(glow)}});
      return;
    }
  }

  void tellOfClosing(std::uint32_t region) {
    const std::uint32_t sector = plan_.regions()[region].sector;
    if (closing_.insert(sector).second)
      findings_.push_back(
          {Outcome::Dropped, Part::Sector, sector, "its lights: what moves leaves them no air"});
  }

  void tellOfTooMany(std::uint32_t region) {
    if (!std::exchange(hasTooMany_, true))
      findings_.push_back(
          {Outcome::Dropped, Part::Sector, plan_.regions()[region].sector,
           fmt::format("its lights and those of what follows, after {} others", settings_.most)});
  }

  const GroundPlan& plan_;
  const LightTable& table_;
  const Materials& materials_;
  LightSettings settings_;
  Findings& findings_;
  bool isUnderSky_ = false;
  bool hasTooMany_ = false;
  std::set<std::uint32_t> closing_;  ///< sectors of the map
  Json lights_ = Json::array();
  Json emit_ = Json::object();
};

}  // namespace

Json lightsJson(const GroundPlan& plan, const LightTable& table, const Materials& materials,
                const LightSettings& settings, Findings& findings) {
  return Illuminator(plan, table, materials, settings, findings).file();
}

}  // namespace hearth::doom
