#include "walk/moving_level.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "math/check.h"
#include "math/trig.h"
#include "walk/stand.h"
#include "walk/surroundings.h"

namespace hearth {

namespace {

/// Where a line on the map leaves a sector.
struct Exit {
  const Segment* segment;
  double fraction;  ///< of the way along the line
};

/// The first wall that the line meets from its front, not before `from`.
std::optional<Exit> exitOf(const Scene& scene, const Sector& sector, Vec2 origin, Vec2 motion,
                           double from) {
  std::optional<Exit> first;
  for (const Segment& segment : scene.segmentsOf(sector)) {
    const Vec2 along = segment.p1 - segment.p0;
    const double approach = -cross(along, motion);
    if (!(approach > 0)) continue;
    const double fraction = cross(along, origin - segment.p0) / approach;
    if (fraction < from || fraction > 1 || (first && first->fraction <= fraction)) continue;
    const double s = dot(origin + fraction * motion - segment.p0, along) / dot(along, along);
    if (s >= 0 && s <= 1) first = Exit{&segment, fraction};
  }
  return first;
}

/// The opening of a wall in which some of these heights lie.
const Opening* openingAt(const Scene& scene, const Segment& segment, double zBottom, double zTop) {
  for (const WallPiece& piece : scene.piecesOf(segment))
    if (const Opening* opening = std::get_if<Opening>(&piece.content))
      if (piece.zBottom < zTop && zBottom < piece.zTop) return opening;
  return nullptr;
}

/// Calls `visit(segment, opening)` for the walls that a line on the map meets, with the opening
/// through which it goes on between these heights: none at the last. Stops where that is false.
template <typename Visit>
void followOnMap(const Scene& scene, const Walker& from, Vec2 motion, double height,
                 Visit&& visit) {
  constexpr int kMostWalls = 256;
  SectorId sector = from.sector;
  double fraction = 0;
  for (int i = 0; i < kMostWalls; ++i) {
    const auto exit = exitOf(scene, scene[sector], from.feet.xy(), motion, fraction);
    if (!exit) return;
    const Opening* opening = openingAt(scene, *exit->segment, from.feet.z, from.feet.z + height);
    if (!visit(*exit->segment, opening) || !opening) return;
    sector = opening->next;
    fraction = exit->fraction;
  }
}

bool has(const std::vector<SectorId>& sectors, SectorId sector) {
  return std::ranges::find(sectors, sector) != sectors.end();
}

/// Whether a wall leads to a sector.
bool leadsTo(const Wall& wall, SectorId sector) {
  if (const Portal* portal = std::get_if<Portal>(&wall)) return portal->next == sector;
  const Stack* stack = std::get_if<Stack>(&wall);
  return stack && std::ranges::any_of(stack->subWalls, [&](const SubWall& subWall) {
           const Portal* portal = std::get_if<Portal>(&subWall.kind);
           return portal && portal->next == sector;
         });
}

bool isNear(const Level& level, const Mover& mover, Vec2 p, double radius) {
  return std::ranges::any_of(mover.sectors, [&](SectorId sector) {
    return grown(level[sector].box, radius + kSkin).contains(p);
  });
}

/// A step from one share towards another.
double approached(double share, double target, double step) {
  return share < target ? std::min(target, share + step) : std::max(target, share - step);
}

bool fits(const Scene& scene, const Walker& walker) {
  const Body body = bodyOf(scene.level(), walker.crouch);
  const auto stand = standAt(scene, body, walker.sector, walker.feet, walker.feet.z,
                             body.stepHeight, body.stepHeight);
  return stand && stand->hasRoomFor(body.height);
}

/// The walker on a floor that has moved from one height to another; none where that leaves it no
/// room. A floor that rises lifts what it meets, one that sinks takes along what stands on it.
std::optional<Walker> carried(const Scene& scene, Walker walker, double from, double to) {
  const Body body = bodyOf(scene.level(), walker.crouch);
  const double feet = walker.feet.z;
  const bool isLifted = to > from && from <= feet + kSkin && feet < to;
  const bool isLowered = to < from && walker.isOnGround && std::abs(feet - from) <= kSkin;
  const Vec3 at{walker.feet.x, walker.feet.y, isLowered ? to : feet};
  const auto stand = standAt(scene, body, walker.sector, at, isLifted ? to : feet, body.stepHeight,
                             body.stepHeight);
  if (!stand || !stand->hasRoomFor(body.height)) return std::nullopt;
  walker.sector = stand->sector;
  walker.feet = stand->feet;
  return walker;
}

/// The body where it stands.
SweepQuery bodyOn(const Level& level, const Walker& walker) {
  const Body body = bodyOf(level, walker.crouch);
  const double feet = walker.feet.z;
  return {walker.feet.xy(), body.radius, 0, {feet, feet, body.height}, feet, feet + body.height};
}

/// Whether a body still reaches into all sectors that it reached into before. A flat that closes an
/// opening beside its axis would have part of it in solid.
bool isWhole(const Surroundings& before, const Scene& scene, const Walker& walker) {
  const Surroundings after(scene, walker.sector, bodyOn(scene.level(), walker));
  return std::ranges::all_of(before.sectors(), [&](SectorId sector) {
    return std::ranges::find(after.sectors(), sector) != after.sectors().end();
  });
}

}  // namespace

MovingLevel::MovingLevel(const Scene& authored) : moved_(authored.level(), authored.geometry()) {
  for (const Mover& mover : level().movers) states_.push_back(firstState(mover));
}

MovingLevel::MovingLevel(const Scene& authored, std::span<const double> shares)
    : MovingLevel(authored) {
  CHECK(shares.size() == states_.size(), shares.size(), states_.size());
  for (std::size_t i = 0; i < shares.size(); ++i) states_[i].share = shares[i];
  moved_.setShares(shares);
}

MovingLevel::MovingLevel(const Scene& authored, const MovingLevel& before) : MovingLevel(authored) {
  const std::vector<Mover>& movers = before.level().movers;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const auto same = std::ranges::find(movers, level().movers[i].name, &Mover::name);
    if (same == movers.end()) continue;
    states_[i] = before.states_[static_cast<std::size_t>(same - movers.begin())];
    moved_.setShare(i, states_[i].share);
  }
}

void MovingLevel::setMovers(std::span<const MoverState> states) {
  CHECK(states.size() == states_.size(), states.size(), states_.size());
  for (std::size_t i = 0; i < states.size(); ++i) {
    states_[i] = states[i];
    if (shares()[i] != states[i].share) moved_.setShare(i, states[i].share);
  }
}

Walker MovingLevel::ticked(const Walker& walker, const WalkInput& input) {
  if (level().movers.empty()) return walked(scene(), walker, input);
  if (input.use) startUsed(walker);
  Walker before = walker;
  for (std::size_t i = 0; i < states_.size(); ++i) move(i, before);
  const Walker after = walked(scene(), before, input);
  startCrossed(before, after);
  startEntered(after);
  return after;
}

void MovingLevel::start(std::size_t mover) {
  states_[mover] = started(level().movers[mover], states_[mover]);
}

/// What lies ahead, or else what the walker stands in.
void MovingLevel::startUsed(const Walker& walker) {
  const SinCos heading = sinCosDegrees(walker.angle);
  bool isStarted = false;
  followOnMap(scene(), walker, kUseReach * Vec2{heading.cos, heading.sin},
              bodyOf(level(), walker.crouch).height, [&](const Segment& segment, const Opening*) {
                isStarted = startAt(segment);
                return !isStarted;
              });
  if (!isStarted) startOf(walker.sector);
}

/// The movers that the use key starts at a wall. Whether there are any.
bool MovingLevel::startAt(const Segment& segment) {
  bool isStarted = false;
  for (const MoverSwitch& each : level().switchesOf(segment.id)) {
    if (each.isCrossed) continue;
    start(each.mover);
    isStarted = true;
  }
  for (std::size_t i = 0; i < level().movers.size(); ++i) {
    const Mover& mover = level().movers[i];
    if (mover.trigger != MoverTrigger::Use) continue;
    if (std::ranges::none_of(mover.sectors, [&](SectorId sector) {
          return sector == segment.sector || leadsTo(segment.wall, sector);
        }))
      continue;
    start(i);
    isStarted = true;
  }
  return isStarted;
}

bool MovingLevel::startOf(SectorId sector) {
  bool isStarted = false;
  for (std::size_t i = 0; i < level().movers.size(); ++i) {
    const Mover& mover = level().movers[i];
    if (mover.trigger != MoverTrigger::Use || !has(mover.sectors, sector)) continue;
    start(i);
    isStarted = true;
  }
  return isStarted;
}

void MovingLevel::startCrossed(const Walker& before, const Walker& after) {
  if (level().switches.empty()) return;
  const Vec2 motion = after.feet.xy() - before.feet.xy();
  if (motion == Vec2{}) return;
  followOnMap(
      scene(), before, motion, bodyOf(level(), before.crouch).height,
      [&](const Segment& segment, const Opening* opening) {
        for (const MoverSwitch& each : level().switchesOf(segment.id))
          if (each.isCrossed && opening && targetOf(segment.wall, *each.subWall) == opening->next)
            start(each.mover);
        return true;
      });
}

void MovingLevel::startEntered(const Walker& walker) {
  for (std::size_t i = 0; i < level().movers.size(); ++i)
    if (level().movers[i].trigger == MoverTrigger::Enter &&
        has(level().movers[i].zones, walker.sector))
      start(i);
}

Walker MovingLevel::pushed(const Walker& walker, const MoverShare& towards) {
  // Small steps: so it goes as far as there is room, and takes the walker past nothing.
  constexpr double kStep = 0.05;  // metres
  constexpr int kMostSteps = 64;
  const auto [mover, share] = towards;
  const double distance = std::abs(moved_.heightAt(mover, 1) - moved_.heightAt(mover, 0));
  Walker after = walker;
  for (int i = 0; i < kMostSteps && shares()[mover] != share; ++i)
    if (!bring(mover, approached(shares()[mover], share, kStep / distance), after)) break;
  states_[mover] = {shares()[mover], 0, 0};
  return after;
}

/// By one tick, unless that would crush the walker: then it turns back.
void MovingLevel::move(std::size_t index, Walker& walker) {
  const Mover& mover = level().movers[index];
  const MoverState now = states_[index];
  const double distance = std::abs(moved_.heightAt(index, 1) - moved_.heightAt(index, 0));
  const MoverState next = moved(mover, distance, now);
  const bool hasRoom = next.share == now.share || bring(index, next.share, walker);
  states_[index] = hasRoom ? next : MoverState{now.share, -now.direction, 0};
}

/// Moves a mover with what stands on it, unless that would crush the walker. Whether it has moved.
bool MovingLevel::bring(std::size_t index, double share, Walker& walker) {
  const Mover& mover = level().movers[index];
  const double before = shares()[index];
  const bool isNearWalker =
      isNear(level(), mover, walker.feet.xy(), bodyOf(level(), walker.crouch).radius) &&
      fits(scene(), walker);
  if (!isNearWalker) {
    moved_.setShare(index, share);
    return true;
  }
  const Surroundings around(scene(), walker.sector, bodyOn(level(), walker));
  moved_.setShare(index, share);
  const bool isFloor = mover.part == FlatPart::Floor;
  const double from = isFloor ? moved_.heightAt(index, before) : walker.feet.z;
  const double to = isFloor ? moved_.heightAt(index, share) : walker.feet.z;
  const auto kept = carried(scene(), walker, from, to);
  if (kept && isWhole(around, scene(), *kept)) {
    walker = *kept;
    return true;
  }
  moved_.setShare(index, before);
  return false;
}

}  // namespace hearth
