#include "walk/body.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory_resource>
#include <optional>
#include <set>

#include "level/locate.h"
#include "lint/authored_wall.h"
#include "lint/sector_graph.h"
#include "math/tolerance.h"
#include "walk/passage.h"

namespace hearth {

namespace {

/// Of the step that the player climbs: no higher ones are taken for a stair. Sills, parapets and
/// tables are, and need not be climbed.
constexpr double kHighestMeant = 1.5;

/// Of the player's height, from where the player stands: no lower ones are taken for a way. Niches,
/// fireplaces and shafts are.
constexpr double kLowestMeant = 0.85;

/// Of the player's width, likewise: slits are not.
constexpr double kNarrowestMeant = 0.5;

/// Square metres that must be gained, or nobody meant to go there: benches, plinths and beds have
/// less.
constexpr double kRoom = 4;

/// Where along a wall heights are compared: enough for wedges, which change them evenly.
constexpr std::array kFractions = {0.0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0};

/// What is asked of a body that passes a wall.
struct Demand {
  double rise;   ///< metres that it must climb
  double clear;  ///< metres between what it stands on there and what is above
};

/// The height that feet come to in a column of air: below flat portals, too.
double feetAt(const Scene& scene, SectorId id, Vec2 p) {
  while (scene[id].floor.flatPortal)
    id = sectorAcross(scene.level(), scene[*scene[id].floor.flatPortal], FlatPortalSide::Lower, p);
  return scene.airBottom(scene[id], p);
}

/// Likewise where a head comes to: above flat portals, too.
double ceilingAt(const Scene& scene, SectorId id, Vec2 p) {
  while (scene[id].ceiling.flatPortal)
    id =
        sectorAcross(scene.level(), scene[*scene[id].ceiling.flatPortal], FlatPortalSide::Upper, p);
  return scene.airTop(scene[id], p);
}

Demand demandAt(const Scene& scene, const Segment& segment, const Passage& passage, SectorId next,
                double fraction) {
  const Vec2 p = lerp(segment.p0, segment.p1, fraction);
  const double feet = feetAt(scene, segment.sector, p);
  double bottom = passage.zBottom({fraction, fraction});
  if (bottom == -kInfinity) bottom = feetAt(scene, next, p);
  return {bottom - feet, passage.zTop({fraction, fraction}) - std::max(bottom, feet)};
}

/// A way that a body just cannot take.
struct Hindrance {
  FindingKind kind;
  SegmentId segment;
  SectorId next;
  double zBottom;  ///< of the opening
  Demand demand;
  double width = kInfinity;  ///< metres of the gap that the opening is a part of
};

/// Where a body can go on foot. It counts too much rather than too little: slopes are taken for
/// walkable, and gaps for wide enough unless walls end them on both sides, so that what it cannot
/// reach nobody can.
class Walks {
 public:
  Walks(const Scene& scene, const Body& body) : scene_(scene), body_(body) {
    const Level& level = scene.level();
    links_.resize(level.sectors.size());
    for (Links& links : linksIfMended_) links.resize(level.sectors.size());
    open_.resize(level.segments.size());
    for (const Segment& segment : level.segments) lookAtWall(segment);
    for (const Sector& sector : level.sectors)
      for (const Loop& loop : sector.loops)
        for (std::uint32_t i = 0; i < loop.count; ++i) lookAtGap(loop, i);
    for (const FlatPortal& flatPortal : level.flatPortals) lookAtFlat(flatPortal);
    addWaysOfMovers(level);
    for (Links& links : linksIfMended_)
      for (std::size_t i = 0; i < links.size(); ++i)
        links[i].insert(links[i].end(), links_[i].begin(), links_[i].end());
  }

  const std::vector<Hindrance>& hindrances() const { return hindrances_; }

  const std::vector<bool>& reachableFrom(SectorId sector) {
    const auto [found, isNew] = reached_.try_emplace(sector);
    if (isNew) found->second = hearth::reachableFrom(links_, sector);
    return found->second;
  }

  /// What would be gained behind a hindrance if all of its kind were mended: a doorway has two
  /// sides that are too narrow, and a stair many steps that are too high, or too low to walk.
  std::vector<SectorId> gainedBehind(const Hindrance& hindrance) {
    const SectorId from = scene_[hindrance.segment].sector;
    return newlyReachableFrom(linksIfMended_[indexOf(hindrance.kind)], hindrance.next,
                              reachableFrom(from));
  }

 private:
  using Links = std::vector<std::vector<SectorId>>;

  static constexpr std::array kHindranceKinds{FindingKind::HighStep, FindingKind::LowPassage,
                                              FindingKind::NarrowPassage};
  static std::size_t indexOf(FindingKind kind) {
    return static_cast<std::size_t>(std::ranges::find(kHindranceKinds, kind) -
                                    kHindranceKinds.begin());
  }

  /// A door opens, and a lift goes up and down.
  void addWaysOfMovers(const Level& level) {
    const MovingWalls moving(level);
    for (const Segment& segment : level.segments)
      if (moving.has(segment))
        for (const SectorId next : targetsOf(segment.wall))
          links_[segment.sector.index()].push_back(next);
  }

  void lookAtWall(const Segment& segment) {
    std::pmr::vector<Passage> passages;
    findPassages(scene_, segment, passages);
    for (const Passage& passage : passages)
      for (std::size_t i = passage.first(); i <= passage.last(); ++i) {
        const WallPiece& piece = scene_.piecesOf(segment)[i];
        const SectorId next = std::get<Opening>(piece.content).next;
        lookAtOpening({{}, segment.id, next, piece.zBottom, {}}, passage);
      }
  }

  void lookAtOpening(Hindrance hindrance, const Passage& passage) {
    std::optional<Hindrance> easiest;
    for (const double fraction : kFractions) {
      hindrance.demand =
          demandAt(scene_, scene_[hindrance.segment], passage, hindrance.next, fraction);
      if (!isHigh(hindrance.demand) && !isLow(hindrance.demand))
        return open_[hindrance.segment.index()].push_back(hindrance);
      const std::optional<FindingKind> kind = kindOf(hindrance.demand);
      if (!kind) continue;
      hindrance.kind = *kind;
      if (!easiest || isEasier(hindrance, *easiest)) easiest = hindrance;
    }
    // Of what goes on below the wall, the walls down there tell.
    const bool hasBottom = passage.zBottom({0, 1}) > -kInfinity;
    const bool isWide = scene_[hindrance.segment].length >= 2 * body_.radius;
    if (easiest && hasBottom && isWide) add(*easiest);
  }

  /// What is neither too high nor too low is a way unless the gap is too narrow.
  void lookAtGap(const Loop& loop, std::uint32_t i) {
    const std::size_t segment = loop.first.index() + i;
    if (open_[segment].empty()) return;
    const double width = widthOfGap(loop, i);
    const bool isNarrow = width < 2 * body_.radius - kSkin;
    for (Hindrance hindrance : open_[segment]) {
      if (!isNarrow)
        links_[scene_.level().segments[segment].sector.index()].push_back(hindrance.next);
      if (!isNarrow || width < kNarrowestMeant * 2 * body_.radius) continue;
      hindrance.kind = FindingKind::NarrowPassage;
      hindrance.width = width;
      add(hindrance);
    }
  }

  void add(const Hindrance& hindrance) {
    const SectorId from = scene_[hindrance.segment].sector;
    linksIfMended_[indexOf(hindrance.kind)][from.index()].push_back(hindrance.next);
    hindrances_.push_back(hindrance);
  }

  /// Metres from wall to wall along the line of a segment that is open; endless where it is open
  /// round a corner, too.
  double widthOfGap(const Loop& loop, std::uint32_t i) const {
    const Segment& segment = scene_.level().segments[loop.first.index() + i];
    double width = segment.length;
    for (const std::uint32_t step : {1U, loop.count - 1})
      for (std::uint32_t j = (i + step) % loop.count; j != i; j = (j + step) % loop.count) {
        if (open_[loop.first.index() + j].empty()) break;
        const Segment& next = scene_.level().segments[loop.first.index() + j];
        if (!areInLine(segment, next)) return kInfinity;
        width += next.length;
      }
    return width;
  }

  static bool areInLine(const Segment& a, const Segment& b) {
    const Vec2 along = a.p1 - a.p0;
    return dot(along, b.p1 - b.p0) > 0 &&
           std::abs(cross(along, b.p1 - b.p0)) / a.length <= noiseOf(std::min(a.length, b.length));
  }

  bool isHigh(const Demand& demand) const { return demand.rise > body_.stepHeight + kSkin; }
  bool isLow(const Demand& demand) const { return demand.clear < body_.height - kSkin; }

  /// What it just fails in, and in nothing else.
  std::optional<FindingKind> kindOf(const Demand& demand) const {
    if (!isLow(demand) && demand.rise <= kHighestMeant * body_.stepHeight + kSkin)
      return FindingKind::HighStep;
    const double aboveFeet = demand.clear + std::max(0.0, demand.rise);
    if (!isHigh(demand) && aboveFeet >= kLowestMeant * body_.height - kSkin)
      return FindingKind::LowPassage;
    return std::nullopt;
  }

  static bool isEasier(const Hindrance& a, const Hindrance& b) {
    if (a.kind != b.kind) return false;
    return a.kind == FindingKind::HighStep ? a.demand.rise < b.demand.rise
                                           : a.demand.clear > b.demand.clear;
  }

  /// Down the body falls; going up it is in both where it is taller than the lower one.
  void lookAtFlat(const FlatPortal& flatPortal) {
    for (const SectorId upper : flatPortal.upper)
      for (const SectorId lower : flatPortal.lower) {
        links_[upper.index()].push_back(lower);
        if (minHeight(scene_[lower]) < body_.height) links_[lower.index()].push_back(upper);
      }
  }

  double minHeight(const Sector& sector) const {
    double least = kInfinity;
    for (const Segment& segment : scene_.segmentsOf(sector)) {
      const AirColumn& air = scene_.geometryOf(segment).air0;
      least = std::min(least, air.zTop - air.zBottom);
    }
    return least;
  }

  Scene scene_;
  const Body& body_;
  std::vector<std::vector<Hindrance>> open_;  ///< by segment: what is high enough to walk through
  Links links_;
  std::array<Links, kHindranceKinds.size()> linksIfMended_;  ///< these, and those of hindrances
  std::vector<Hindrance> hindrances_;
  std::map<SectorId, std::vector<bool>> reached_;
};

class HindranceFinder {
 public:
  HindranceFinder(const LintedLevel& linted, Findings& findings)
      : linted_(linted), scene_(linted.scene()), findings_(findings) {}

  void look(const Body& body, bool isCrouching) {
    Walks walks(scene_, body);
    const std::vector<bool> isVisited = walks.reachableFrom(scene_.level().player->sector);
    for (const Hindrance& hindrance : walks.hindrances()) {
      const SectorId from = scene_[hindrance.segment].sector;
      // A crouching body climbs no more than a standing one, and is as wide.
      if (isCrouching && hindrance.kind != FindingKind::LowPassage) continue;
      if (!isVisited[from.index()]) continue;
      if (told_.contains(hindrance.next)) continue;
      const std::vector<SectorId> gained = walks.gainedBehind(hindrance);
      if (areaOf(scene_.level(), gained) < kRoom) continue;
      told_.insert(gained.begin(), gained.end());
      report(hindrance, body, isCrouching);
    }
  }

 private:
  void report(const Hindrance& hindrance, const Body& body, bool isCrouching) {
    const Place place = authoredWallAt(linted_, hindrance.segment, hindrance.zBottom).place;
    const std::string& name = scene_[hindrance.next].name;
    if (hindrance.kind == FindingKind::HighStep)
      findings_.add(hindrance.kind, place,
                    fmt::format("the step to sector \"{}\" is {:.3g} m high, the player climbs "
                                "{:.3g} m, and nothing else leads there",
                                name, hindrance.demand.rise, body.stepHeight),
                    "make it lower, or make two of it");
    else if (hindrance.kind == FindingKind::NarrowPassage)
      findings_.add(
          hindrance.kind, place,
          fmt::format("the way to sector \"{}\" is {:.3g} m wide, the player {:.3g} m, and "
                      "nothing else leads there",
                      name, hindrance.width, 2 * body.radius),
          "make it wider");
    else
      findings_.add(hindrance.kind, place,
                    fmt::format("the way to sector \"{}\" is {:.3g} m high, the player {:.3g} m{}, "
                                "and nothing else leads there",
                                name, hindrance.demand.clear, body.height,
                                isCrouching ? " when crouching" : ""),
                    "make it higher");
  }

  const LintedLevel& linted_;
  Scene scene_;
  Findings& findings_;
  std::set<SectorId> told_;  ///< sectors that a finding has spoken of
};

/// Less is mended by the step with which a walk begins.
void lookAtFeet(const LintedLevel& linted, const Body& body, Findings& findings) {
  const Player& player = *linted.level().player;
  const double floor = feetAt(linted.scene(), player.sector, player.eye.xy());
  const double depth = floor - (player.eye.z - body.eyeHeight);
  if (depth <= body.stepHeight + kSkin) return;
  findings.add(
      FindingKind::SunkenPlayer, linted.source.level.player->place,
      fmt::format("the player's feet are {:.3g} m below the floor: \"z\" is that of the eye, not "
                  "theirs",
                  depth),
      fmt::format("write \"z\": {:.6g}, which is {:.3g} m above the floor", floor + body.eyeHeight,
                  body.eyeHeight));
}

/// Without room to stand the player begins crouching; without room for that the player is stuck.
void lookAtHead(const LintedLevel& linted, const Body& crouching, double eyeHeight,
                Findings& findings) {
  const Player& player = *linted.level().player;
  const double ceiling = ceilingAt(linted.scene(), player.sector, player.eye.xy());
  const double above = player.eye.z - crouching.eyeHeight + crouching.height - ceiling;
  if (above <= kSkin) return;
  const double floor = feetAt(linted.scene(), player.sector, player.eye.xy());
  findings.add(FindingKind::StuckPlayer, linted.source.level.player->place,
               fmt::format("the player's head is {:.3g} m inside the ceiling, crouching", above),
               fmt::format("write \"z\": {:.6g}, which is {:.3g} m above the floor",
                           floor + eyeHeight, eyeHeight));
}

/// A thing that the player could step up to is a place to stand on.
void lookAtThings(const LintedLevel& linted, const Body& body, Findings& findings) {
  const Level& level = linted.level();
  const double feet = level.player->eye.z - body.eyeHeight;
  for (const BodyInSector& there : level.bodiesIn(level.player->sector)) {
    const ThingBody& thing = level.bodies[there.body];
    const bool isBeside =
        !thing.outline.isWithin(level.player->eye.xy(), body.radius + thing.radius - kSkin);
    const bool isUnder = thing.zTop <= feet + body.stepHeight + kSkin;
    const bool isAbove = thing.zBottom >= feet + body.height - kSkin;
    if (isBeside || isUnder || isAbove) continue;
    findings.add(
        FindingKind::StuckPlayer, linted.source.level.player->place,
        fmt::format("the player begins inside a solid thing, which reaches from z = {:.3g} "
                    "to {:.3g}",
                    thing.zBottom, thing.zTop),
        "move the player or the thing");
  }
}

}  // namespace

void findImpassable(const LintedLevel& linted, Findings& findings) {
  if (!linted.level().player) return;
  HindranceFinder finder(linted, findings);
  for (const bool isCrouching : {false, true})
    finder.look(bodyOf(linted.level(), isCrouching ? 1 : 0), isCrouching);
}

std::vector<SectorId> outOfReach(const Scene& scene) {
  if (!scene.level().player) return {};
  const std::vector<bool> isReached =
      Walks(scene, bodyOf(scene.level(), 1)).reachableFrom(scene.level().player->sector);
  std::vector<SectorId> unreached;
  for (std::size_t i = 0; i < isReached.size(); ++i)
    if (!isReached[i]) unreached.emplace_back(i);
  return unreached;
}

void findMisplacedPlayer(const LintedLevel& linted, Findings& findings) {
  if (!linted.level().player) return;
  const Body standing = bodyOf(linted.level(), 0);
  lookAtFeet(linted, standing, findings);
  lookAtHead(linted, bodyOf(linted.level(), 1), standing.eyeHeight, findings);
  lookAtThings(linted, standing, findings);
}

}  // namespace hearth
