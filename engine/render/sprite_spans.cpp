#include "render/sprite_spans.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "math/tolerance.h"
#include "render/ray_exits.h"
#include "render/ray_slopes.h"

namespace hearth {

namespace {

void addSpans(const SpritePart& part, int strip, const LaneRowRanges& rows, SpanGroups& found) {
  const auto [group, lanes] = found.add(part.front->surface(), strip, rows);
  if (!group) return;
  group->view = &part.front->view();
  group->zTop = part.front->zTop();
  setLanes(group->depth, part.depth, lanes);
  setLanes(group->fraction, part.fraction, lanes);
}

LaneRowRanges only(std::size_t lane, int begin, int end) {
  LaneRowRanges one;
  one.begin[lane] = begin;
  one.end[lane] = end;
  return one;
}

}  // namespace

/// A run, and the air that its rays cross.
struct SpriteSpans::Look {
  const ColumnRun& run;
  const RunEntry& entry;
  const MeshSpans* meshes;  ///< null if none show
  const Projection& projection;
  RunRays rays;
  LaneSet lanes;  ///< of the run

  Look(const ColumnRun& ofRun, const RunEntry& atEntry, const MeshSpans* ofMeshes,
       const Projection& of)
      : run(ofRun), entry(atEntry), meshes(ofMeshes), projection(of) {
    for (std::size_t lane = 0; lane < Strip::kColumns; ++lane)
      rays.slants[lane] = projection.slantOf(columnOf(lane) + 0.5);
    rays.entries = entry.depths;
    rays.exits = run.depths;
    lanes = lanesWhere([this](std::size_t lane) { return run.open.has(lane); });
  }

  Vec2 rayOf(std::size_t lane) const { return projection.rayOf(columnOf(lane) + 0.5); }
  int columnOf(std::size_t lane) const {
    return run.strip * Strip::kColumns + static_cast<int>(lane);
  }
  int rowIn(std::size_t lane, double z, double depth) const {
    return projection.rowIn(run.open.begin[lane], run.open.end[lane], z, depth);
  }
};

SpriteSpans::SpriteSpans(const Scene& scene, const SpriteIndex& index, const Camera& camera,
                         const Projection& projection, ColumnRange columns,
                         SpriteSpansScratch& scratch)
    : scene_(scene),
      index_(index),
      camera_(camera),
      projection_(projection),
      columns_(columns),
      scratch_(scratch) {
  scratch_.fronts.clear();
}

std::span<const SpriteFront> SpriteSpans::frontsIn(SectorId sector) {
  if (!scratch_.fronts.has(sector))
    scratch_.fronts.find(scene_, index_, camera_, projection_, sector, columns_);
  return scratch_.fronts.of(sector);
}

void SpriteSpans::show(const ColumnRun& run, const RunEntry& entry, const MeshSpans* meshes,
                       SpanGroups& found) {
  const std::span<const SpriteFront> fronts = frontsIn(run.sector.id);
  if (fronts.empty()) return;
  const Look look(run, entry, meshes, projection_);
  auto& [all, standing, nearToFar, lying] = scratch_;
  standing.clear();
  lying.clear();
  for (const std::uint32_t i : scratch_.fronts.inStrip(run.sector.id, run.strip)) {
    const SpriteFront& front = fronts[i];
    if (front.lies())
      lying.push_back(&front);
    else
      findStanding(look, front);
  }
  nearToFar.clear();
  for (const SpritePart& part : standing) nearToFar.push_back(&part);
  const double eyeZ = projection_.eye().z;
  // Of two at one height the later in the level first.
  std::ranges::sort(lying, {}, [eyeZ](const SpriteFront* front) {
    return std::pair(std::abs(front->zBottom() - eyeZ), ~front->surface().value);
  });
  if (standing.empty()) {
    for (const SpriteFront* front : lying) {
      const SpritePart part = lyingPart(look, *front);
      add(look, part, part.rows, found);
    }
  } else if (lying.empty() && sortStanding()) {
    for (const SpritePart* part : nearToFar) add(look, *part, part->rows, found);
  } else {
    for (std::size_t lane = run.laneBegin; lane < run.laneEnd; ++lane) showLane(look, lane, found);
  }
}

/// Adds those of its rows in which no mesh is before it.
void SpriteSpans::add(const Look& look, const SpritePart& part, const LaneRowRanges& rows,
                      SpanGroups& found) const {
  if (!look.meshes) return addSpans(part, look.run.strip, rows, found);
  for (std::size_t lane = look.run.laneBegin; lane < look.run.laneEnd; ++lane) {
    const auto isHidden = [&](int row) {
      return look.meshes->hide(lane, row, depthAt(part, lane, row), part.front->thing());
    };
    for (int row = rows.begin[lane]; row < rows.end[lane];) {
      while (row < rows.end[lane] && isHidden(row)) ++row;
      const int begin = row;
      while (row < rows.end[lane] && !isHidden(row)) ++row;
      addSpans(part, look.run.strip, only(lane, begin, row), found);
    }
  }
}

double SpriteSpans::depthAt(const SpritePart& part, std::size_t lane, int row) const {
  if (!part.front->lies()) return part.depth[lane];
  return (part.front->zBottom() - projection_.eye().z) / projection_.raySlopeAt(row + 0.5);
}

// --- What stands ---------------------------------------------------------------------------------

void SpriteSpans::findStanding(const Look& look, const SpriteFront& front) {
  StandingMeetings met;
  kernels_.meet(front.lowerEdge(), look.rays, met);
  unsigned lanes = met.lanes & look.lanes;
  if ((lanes & met.atEntry) != 0 && isBeforeEntry(look, front)) lanes &= ~unsigned{met.atEntry};
  if (lanes == 0) return;
  const LaneRowRanges rows = standingRows(look, front, static_cast<LaneSet>(lanes), met.depth);
  if (rows.lanes() != 0)
    scratch_.standing.push_back({&front, met.nearest, rows, met.depth, met.fraction});
}

/// Whether what is at the entry shows in the sector before it. Only windows that lie in an opening
/// have an entry.
bool SpriteSpans::isBeforeEntry(const Look& look, const SpriteFront& front) const {
  const std::span<const SpriteFront> before = scratch_.fronts.of(*look.entry.from);
  return std::ranges::find(before, front.surface(), &SpriteFront::surface) != before.end();
}

/// Those of lanes in which it shows, in the air of the sector.
LaneRowRanges SpriteSpans::standingRows(const Look& look, const SpriteFront& front, LaneSet lanes,
                                        const LaneDoubles& depth) const {
  const Sector& sector = look.run.sector;
  LaneRowRanges rows;
  if (front.lowerEdge().hasOneDepth() && !sector.floorSlope && !sector.ceilingSlope) {
    // The same in all columns, as far as their windows show them.
    const double zBottom = std::max(front.zBottom(), scene_.zFloor(sector));
    const double zTop = std::min(front.zTop(), scene_.zCeiling(sector));
    if (zBottom >= zTop) return rows;
    const int begin = projection_.rowIn(0, camera_.height, zTop, depth[0]);
    const int end = projection_.rowIn(0, camera_.height, zBottom, depth[0]);
    kernels_.show(begin, end, lanes, look.run.open, rows);
    return rows;
  }
  for (unsigned rest = lanes; rest != 0; rest &= rest - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
    const Vec2 at = projection_.eye().xy() + depth[lane] * look.rayOf(lane);
    const double zBottom = std::max(front.zBottom(), scene_.airBottom(sector, at));
    const double zTop = std::min(front.zTop(), scene_.airTop(sector, at));
    if (zBottom >= zTop) continue;
    rows.begin[lane] = look.rowIn(lane, zTop, depth[lane]);
    rows.end[lane] = look.rowIn(lane, zBottom, depth[lane]);
  }
  return rows;
}

/// Sorts what stands by rising depth, and says whether that is the order in every column.
bool SpriteSpans::sortStanding() {
  std::ranges::sort(scratch_.nearToFar, {}, &SpritePart::nearest);
  LaneDoubles reached{};
  for (const SpritePart* part : scratch_.nearToFar) {
    const LaneSet notBehind = lanesWhere(
        [&](std::size_t lane) { return part->depth[lane] <= reached[lane] * (1 + kNearTie); });
    if ((part->rows.lanes() & notBehind) != 0) return false;
    for (std::size_t lane = 0; lane < reached.size(); ++lane)
      reached[lane] = part->rows.has(lane) ? part->depth[lane] : reached[lane];
  }
  return true;
}

// --- What lies -----------------------------------------------------------------------------------

/// All of what lies, if nothing stands in it.
SpritePart SpriteSpans::lyingPart(const Look& look, const SpriteFront& front) const {
  SpritePart part{&front, 0, {}, {}, {}};
  for (std::size_t lane = look.run.laneBegin; lane < look.run.laneEnd; ++lane)
    lie(look, lane, {look.entry.depths[lane], look.run.depths[lane]}, part);
  return part;
}

/// Finds the rows of one column in which it lies between two depths, the first excluded.
void SpriteSpans::lie(const Look& look, std::size_t lane, SpriteFront::Depths between,
                      SpritePart& part) const {
  const double z = part.front->zBottom();
  const double eyeZ = projection_.eye().z;
  if (z == eyeZ) return;
  // What lies in a flat portal belongs to the side that it is seen from.
  if (look.entry.plane && std::abs(z - *look.entry.plane) <= kPositionSlack) return;
  SpriteFront::Depths depths = part.front->over(look.rays.slants[lane]);
  depths = {std::max(depths.from, between.from), std::min(depths.to, between.to)};
  const Sector& sector = look.run.sector;
  const Vec2 eye = projection_.eye().xy();
  const Vec2 ray = look.rayOf(lane);
  depths.keepPositive(z - scene_.airBottom(sector, eye) + kPositionSlack,
                      -riseAlong(sector.floorSlope, ray));
  depths.keepPositive(scene_.airTop(sector, eye) - z + kPositionSlack,
                      riseAlong(sector.ceilingSlope, ray));
  if (depths.from >= depths.to) return;
  const double upper = z < eyeZ ? depths.to : depths.from;
  const double lower = z < eyeZ ? depths.from : depths.to;
  part.rows.begin[lane] = look.rowIn(lane, z, upper);
  part.rows.end[lane] = look.rowIn(lane, z, lower);
  part.depth[lane] = depths.to;
}

// --- Both, column by column ----------------------------------------------------------------------

/// What lies is divided by the depths of what stands. Between two of these it hides what lies
/// farther from the height of the eye: where two share a pixel, the ray meets that later.
void SpriteSpans::showLane(const Look& look, std::size_t lane, SpanGroups& found) {
  const auto depthOf = [lane](const SpritePart* part) {
    return part->rows.has(lane) ? part->depth[lane] : RayExits::kNoDepth;
  };
  std::ranges::sort(scratch_.nearToFar, {}, depthOf);
  putLaterFirst(lane);
  double reached = look.entry.depths[lane];
  for (const SpritePart* part : scratch_.nearToFar) {
    if (!part->rows.has(lane)) break;
    showLying(look, lane, {reached, part->depth[lane]}, found);
    add(look, *part, only(lane, part->rows.begin[lane], part->rows.end[lane]), found);
    reached = std::max(reached, part->depth[lane]);
  }
  showLying(look, lane, {reached, look.run.depths[lane]}, found);
}

/// Where depths differ by rounding alone, as in one plane.
void SpriteSpans::putLaterFirst(std::size_t lane) {
  std::vector<const SpritePart*>& parts = scratch_.nearToFar;
  for (std::size_t i = 1; i < parts.size(); ++i)
    for (std::size_t k = i; k > 0 && parts[k]->rows.has(lane); --k) {
      if (parts[k]->depth[lane] > parts[k - 1]->depth[lane] * (1 + kNearTie)) break;
      if (parts[k]->front->surface() < parts[k - 1]->front->surface()) break;
      std::swap(parts[k], parts[k - 1]);
    }
}

void SpriteSpans::showLying(const Look& look, std::size_t lane, SpriteFront::Depths between,
                            SpanGroups& found) const {
  for (const SpriteFront* front : scratch_.lying) {
    SpritePart part{front, 0, {}, {}, {}};
    lie(look, lane, between, part);
    add(look, part, part.rows, found);
  }
}

}  // namespace hearth
