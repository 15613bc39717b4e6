#include "import/doom/convert.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

namespace hearth::doom {

namespace {

using Json = nlohmann::ordered_json;

/// Things where players start, by type, in the order in which they are tried: the first player, the
/// others, and all of them where they play against one another.
constexpr std::array<std::uint16_t, 5> kStarts{1, 2, 3, 4, 11};

// The player of Doom: 56 units high, 32 wide, eyes at 41, climbs 24.
constexpr double kEye = 41 * kUnit;
constexpr double kBodyHeight = 56 * kUnit;
constexpr double kRadius = 16 * kUnit;
constexpr double kStep = 24 * kUnit;

/// Where nothing says what is seen.
constexpr const char* kBare = "#606060";

class Converter {
 public:
  Converter(const GroundPlan& plan, double ambient, Materials& materials, Findings& findings)
      : plan_(plan),
        map_(plan.map()),
        ambient_(ambient),
        materials_(materials),
        findings_(findings) {}

  Json level() {
    Json level{{"version", 1}, {"name", map_.name}, {"textures", "textures"}};
    if (auto player = playerJson()) level["player"] = std::move(*player);
    if (!plan_.movers().movers.empty()) level["movers"] = moversJson();
    Json& sectors = level["sectors"] = Json::object();
    for (std::uint32_t i = 0; i < plan_.regions().size(); ++i)
      sectors[plan_.nameOf(i)] = sectorJson(i);
    tellOfMiddles();
    return level;
  }

 private:
  // --- Sectors -----------------------------------------------------------------------------------

  Json sectorJson(std::uint32_t region) {
    const Sector& sector = plan_.sectorOf(region);
    const Space space = plan_.spaceOf(region);
    Json loops = Json::object();
    for (const auto& loop : plan_.regions()[region].loops)
      loops[loops.empty() ? "border" : fmt::format("inner {}", loops.size())] = loopJson(loop);
    return {{"light", std::round(1000 * ambient_ * sector.light / 255) / 1000},
            {"floor", flatJson(space.floor, sector.floorFlat)},
            {"ceiling", flatJson(space.ceiling, sector.ceilingFlat)},
            {"loops", std::move(loops)}};
  }

  Json flatJson(double z, const std::string& flat) {
    if (flat != kSkyFlat) return {{"z", z}, {"texture", materials_.flat(flat)}};
    return {{"z", z}, {"texture", materials_.sky()}, {"parallax", true}};
  }

  Json loopJson(const std::vector<std::uint32_t>& loop) {
    Json v = Json::array();
    Json walls = Json::array();
    for (const std::uint32_t h : loop) {
      v.push_back(plan_.halfEdge(h).from.x);
      v.push_back(plan_.halfEdge(h).from.y);
      walls.push_back(wallJson(h));
    }
    return {{"v", std::move(v)}, {"walls", std::move(walls)}};
  }

  // --- Walls -------------------------------------------------------------------------------------

  Json wallJson(std::uint32_t h) {
    Json wall = Json::object();
    if (plan_.isPortal(h)) wall["next"] = plan_.nameOf(*plan_.behind(h).region);
    for (const ShownPart& part : plan_.partsAtAnyEnd(h)) {
      if (part.part != WallPart::Middle)
        wall[keyOf(part.part)] = textureJson(h, part);
      else if (auto middle = middleJson(h, part))
        wall["middle"] = *std::move(middle);
    }
    addStarts(h, wall);
    return wall;
  }

  /// Doom's lines are used from their front, and crossed from both sides.
  void addStarts(std::uint32_t h, Json& wall) {
    const bool hasFace = plan_.halfEdge(h).face.has_value();
    const Face& face = hasFace ? *plan_.halfEdge(h).face : *plan_.behind(h).face;
    const std::vector<std::size_t> started = plan_.startedBy(face.line);
    if (started.empty()) return;
    const Line& line = map_.lines[face.line];
    const bool isCrossed = findLineType(line.special)->activation == Activation::Walk;
    const bool isFront = hasFace && face.side == line.sides[0];
    if (!isCrossed && isFront) {
      wall["use"] = moverNames(started);
      addSwitchTextures(h, wall);
    }
    if (isCrossed && plan_.isPortal(h)) wall["cross"] = moverNames(started);
  }

  void addSwitchTextures(std::uint32_t h, Json& wall) {
    Json on = Json::object();
    for (const ShownPart& part : plan_.partsAtAnyEnd(h)) {
      if (part.part == WallPart::Middle) continue;
      const Json& texture = wall[keyOf(part.part)];
      if (!texture.is_object()) continue;
      if (const auto switched = materials_.switched(part.texture))
        on[texture["name"].get<std::string>()] = *switched;
    }
    if (!on.empty()) wall["on"] = std::move(on);
  }

  Json moverNames(const std::vector<std::size_t>& movers) const {
    Json names = Json::array();
    for (const std::size_t mover : movers) names.push_back(plan_.movers().movers[mover].name);
    return names.size() == 1 ? names.front() : names;
  }

  static const char* keyOf(WallPart part) {
    if (part == WallPart::Solid) return "texture";
    return part == WallPart::Upper ? "upper" : "lower";
  }

  Json textureJson(std::uint32_t h, const ShownPart& part) {
    if (part.texture == kNoTexture) return bareJson(h, part);
    const Side& side = map_.sides[part.face->side];
    return materials_.wall(part.texture,
                           {side.xOffset, side.yOffset, part.face->along, topOfImage(h, part)});
  }

  /// Once from its top to its bottom: so offsets move all of it.
  std::optional<Json> middleJson(std::uint32_t h, const ShownPart& part) {
    shownMiddles_.insert(part.face->side);
    const Side& side = map_.sides[part.face->side];
    const bool stands = map_.lines[part.face->line].isLowerUnpegged();
    Hanging hanging{side.xOffset, 0, part.face->along, {}};
    const double top = stands ? part.bottom + materials_.heightOf(part.texture) : part.top;
    if (stands || side.yOffset != 0 || !hasMovingCeiling(h))
      hanging.top = top + side.yOffset * kUnit;  // without it, it follows the opening's top
    return materials_.middle(part.texture, hanging);
  }

  bool hasMovingCeiling(std::uint32_t h) const {
    const auto isMoving = [this](std::uint32_t region) {
      return std::ranges::any_of(plan_.moversOf(region), [this](std::size_t mover) {
        return plan_.movers().movers[mover].part == FlatPart::Ceiling;
      });
    };
    return isMoving(*plan_.halfEdge(h).region) || isMoving(*plan_.behind(h).region);
  }

  /// Where Doom hangs an image otherwise than Hearth does by itself
  /// (https://doomwiki.org/wiki/Texture_alignment).
  std::optional<double> topOfImage(std::uint32_t h, const ShownPart& part) const {
    const Line& line = map_.lines[part.face->line];
    const Space own = plan_.spaceOf(*plan_.halfEdge(h).region);
    if (part.part == WallPart::Upper)
      return line.isUpperUnpegged() ? std::optional(own.ceiling) : std::nullopt;
    if (!line.isLowerUnpegged()) return std::nullopt;
    if (part.part == WallPart::Solid) return own.floor + materials_.heightOf(part.texture);
    // Between two skies Doom takes the ceiling behind for that before.
    const Space next = plan_.spaceOf(*plan_.behind(h).region);
    return own.isUnderSky && next.isUnderSky ? next.ceiling : own.ceiling;
  }

  /// What Doom shows where it has no texture is what was drawn before; most often that is the floor
  /// or ceiling behind.
  Json bareJson(std::uint32_t h, const ShownPart& part) {
    if (part.bottom == part.top) return kBare;
    if (toldOf_.emplace(part.face->line, part.part).second)
      findings_.push_back(
          {Outcome::Repaired, Part::Line, part.face->line,
           fmt::format("its {} shows and has no texture",
                       part.part == WallPart::Solid ? "middle" : keyOf(part.part))});
    if (part.part == WallPart::Solid) return kBare;
    const Sector& next = plan_.sectorOf(*plan_.behind(h).region);
    const std::string& flat = part.part == WallPart::Upper ? next.ceilingFlat : next.floorFlat;
    return flat == kSkyFlat ? Json(kBare) : materials_.flat(flat);
  }

  void tellOfMiddles() {
    for (std::size_t i = 0; i < map_.lines.size(); ++i) {
      const auto& [right, left] = map_.lines[i].sides;
      if (!right || !left) continue;
      for (const std::uint32_t side : {*right, *left}) {
        const std::string& name = map_.sides[side].middle;
        if (name == kNoTexture || shownMiddles_.contains(side)) continue;
        findings_.push_back(
            {Outcome::Dropped, Part::Line, i,
             fmt::format("its middle texture {}, which hangs in no opening", name)});
        break;
      }
    }
  }

  // --- Movers ------------------------------------------------------------------------------------

  Json moversJson() const {
    Json movers = Json::object();
    for (const MapMover& mover : plan_.movers().movers) movers[mover.name] = moverJson(mover);
    return movers;
  }

  Json moverJson(const MapMover& mover) const {
    Json json{{"sectors", Json::array()},
              {"part", name(mover.part)},
              {"to", mover.motion.to * kUnit},
              {"speed", mover.motion.speed}};
    for (const std::uint32_t sector : mover.sectors)
      for (const std::uint32_t region : plan_.regionsOf(sector))
        json["sectors"].push_back(plan_.nameOf(region));
    if (mover.motion.wait) json["wait"] = std::round(1000 * *mover.motion.wait) / 1000;
    if (mover.motion.isLoop) json["trigger"] = name(MoverTrigger::Loop);
    return json;
  }

  // --- Player ------------------------------------------------------------------------------------

  std::optional<Json> playerJson() {
    bool isFirst = true;
    for (const std::uint16_t type : kStarts)
      for (std::size_t i = 0; i < map_.things.size(); ++i) {
        if (map_.things[i].type != type) continue;
        const Vec2 place = placeOf(map_.things[i].x, map_.things[i].y);
        const auto region = plan_.regionAt(place);
        if (region && hasRoom(*region)) {
          if (!isFirst || type != kStarts.front()) tellOfStart(Part::Thing, i);
          return bodyAt(*region, place, angleOf(map_.things[i].angle));
        }
        isFirst = false;
      }
    return movedPlayerJson();
  }

  /// Before the longest wall of all sectors with room.
  std::optional<Json> movedPlayerJson() {
    std::optional<Json> player;
    double longest = 0;
    std::size_t sector = 0;
    for (std::uint32_t region = 0; region < plan_.regions().size(); ++region) {
      if (!hasRoom(region)) continue;
      for (const std::uint32_t h : plan_.regions()[region].loops.front()) {
        const Vec2 along = plan_.halfEdge(h).to - plan_.halfEdge(h).from;
        const Vec2 place = lerp(plan_.halfEdge(h).from, plan_.halfEdge(h).to, 0.5) +
                           (2 * kRadius / length(along)) * turned90(along);
        if (length(along) <= longest || !plan_.contains(region, place)) continue;
        longest = length(along);
        sector = plan_.regions()[region].sector;
        player = bodyAt(region, place, 0);
      }
    }
    if (player)
      tellOfStart(Part::Sector, sector);
    else
      findings_.push_back(
          {Outcome::Dropped, Part::Thing, 0, "no player starts, nor is there room for one"});
    return player;
  }

  bool hasRoom(std::uint32_t region) const {
    const Space space = plan_.spaceOf(region);
    return space.ceiling - space.floor >= kBodyHeight;
  }

  Json bodyAt(std::uint32_t region, Vec2 place, int angle) const {
    return {{"sector", plan_.nameOf(region)},
            {"x", place.x},
            {"y", place.y},
            {"z", plan_.spaceOf(region).floor + kEye},
            {"angle", angle},
            {"height", kBodyHeight},
            {"eye", kEye},
            {"radius", kRadius},
            {"step", kStep}};
  }

  void tellOfStart(Part part, std::size_t number) {
    findings_.push_back({Outcome::Repaired, part, number,
                         "the player starts here: it has no start of its own with room for it"});
  }

  const GroundPlan& plan_;
  const Map& map_;
  double ambient_;
  Materials& materials_;
  Findings& findings_;
  std::set<std::pair<std::uint32_t, WallPart>> toldOf_;  ///< lines
  std::set<std::uint32_t> shownMiddles_;                 ///< sides
};

}  // namespace

Json levelJson(const GroundPlan& plan, double ambient, Materials& materials, Findings& findings) {
  return Converter(plan, ambient, materials, findings).level();
}

}  // namespace hearth::doom
