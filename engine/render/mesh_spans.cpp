#include "render/mesh_spans.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "math/tolerance.h"
#include "render/ray_slopes.h"

namespace hearth {

MeshSpans::MeshSpans(const Scene& scene, const Camera& camera, const Projection& projection,
                     ColumnRange columns, MeshSpansScratch& scratch)
    : scene_(scene), projection_(projection), scratch_(scratch) {
  if (scene.level().meshes.empty()) return;
  scratch_.fronts.begin(scene.level(), {columns, 0, camera.height});
  findRaySlopes(projection, camera.height, scratch_.raySlopes);
  scratch_.nearest.resize(camera.height);
}

bool MeshSpans::find(const ColumnRun& run, const RunEntry& entry, const PictureRect& windows) {
  scratch_.nearest.clear();
  scratch_.faces.clear();
  const std::span<const MeshInSector> meshes = scene_.level().meshesIn(run.sector.id);
  for (const MeshInSector& there : meshes)
    scratch_.fronts.find(scene_, projection_, there.mesh, windows);
  std::optional<AirRays> rays;
  for (const MeshInSector& there : meshes) {
    const auto inStrip = scratch_.fronts.inStrip(there.mesh, run.strip);
    if (inStrip.empty()) continue;
    if (!rays) rays = raysOf(run, entry);
    const std::span<const FaceFront> fronts = scratch_.fronts.frontsOf(there.mesh);
    for (const std::uint32_t i : inStrip) {
      scratch_.faces.push_back(&fronts[i]);
      cover_(fronts[i], scratch_.faces.size(), *rays, scratch_.nearest);
    }
  }
  return scratch_.nearest.begin() < scratch_.nearest.end();
}

AirRays MeshSpans::raysOf(const ColumnRun& run, const RunEntry& entry) const {
  const Vec3 eye = projection_.eye();
  AirRays rays;
  rays.firstColumn = run.strip * Strip::kColumns;
  rays.raySlopes = scratch_.raySlopes.data();
  rays.horizonRow = projection_.horizonRow();
  rays.distancePx = projection_.distancePx();
  rays.floorBelow = eye.z - scene_.airBottom(run.sector, eye.xy()) + kPositionSlack;
  rays.ceilingAbove = scene_.airTop(run.sector, eye.xy()) - eye.z + kPositionSlack;
  for (std::size_t lane = 0; lane < Strip::kColumns; ++lane) {
    const double column = rays.firstColumn + static_cast<double>(lane) + 0.5;
    const Vec2 ray = projection_.rayOf(column);
    rays.slants[lane] = projection_.slantOf(column);
    rays.floorRises[lane] = riseAlong(run.sector.floorSlope, ray);
    rays.ceilingRises[lane] = riseAlong(run.sector.ceilingSlope, ray);
    const double enters = entry.depths[lane] * (1 - kNearTie) - kPositionSlack;
    rays.least[lane] = 1 / (run.depths[lane] * (1 + kNearTie) + kPositionSlack);
    rays.most[lane] = enters > 0 ? 1 / enters : std::numeric_limits<double>::infinity();
    if (!run.open.has(lane)) continue;
    rays.begins[lane] = run.open.begin[lane];
    rays.ends[lane] = run.open.end[lane];
  }
  return rays;
}

const FaceFront* MeshSpans::frontAt(std::size_t lane, int row) const {
  const NearestFaces::Number face = scratch_.nearest[row].faces[lane];
  return face == 0 ? nullptr : scratch_.faces[face - 1];
}

bool MeshSpans::hide(std::size_t lane, int row, double depth, std::uint32_t thing) const {
  if (row < scratch_.nearest.begin() || row >= scratch_.nearest.end()) return false;
  const FaceFront* const front = frontAt(lane, row);
  if (!front) return false;
  const double times = depth * scratch_.nearest[row].nearness[lane];
  if (std::abs(times - 1) <= kNearTie) return front->thing > thing;
  return times > 1;
}

void MeshSpans::show(const ColumnRun& run, SpanGroups& found) {
  scratch_.narrow.clear();
  const NearestFaces& nearest = scratch_.nearest;
  for (std::size_t lane = run.laneBegin; lane < run.laneEnd; ++lane) {
    int row = std::max(nearest.begin(), run.open.begin[lane]);
    const int last = std::min(nearest.end(), run.open.end[lane]);
    while (row < last) {
      const int begin = row;
      const NearestFaces::Number face = nearest[begin].faces[lane];
      while (row < last && nearest[row].faces[lane] == face) ++row;
      if (face == 0) continue;
      const double least = std::min(nearest[begin].nearness[lane], nearest[row - 1].nearness[lane]);
      addSpan(run, {scratch_.faces[face - 1], lane, begin, row, 1 / least}, found);
    }
  }
  addNarrow(run, found);
}

/// Those of narrow faces are put off, to be added all at once.
void MeshSpans::addSpan(const ColumnRun& run, const FaceSpan& span, SpanGroups& found) {
  if (span.front->isNarrow) {
    scratch_.narrow.push_back(span);
    return;
  }
  LaneRowRanges rows;
  rows.begin[span.lane] = span.rowBegin;
  rows.end[span.lane] = span.rowEnd;
  const auto [group, lanes] =
      found.add(span.front->mesh, scene_.level().indexOf(*span.front->face), run.strip, rows);
  group->face = span.front->face;
  LaneDoubles depth;
  depth.fill(span.depth);
  setLanes(group->depth, depth, lanes);
}

void MeshSpans::addNarrow(const ColumnRun& run, SpanGroups& found) {
  std::vector<FaceSpan>& all = scratch_.narrow;
  const auto place = [](const FaceSpan& span) {
    return std::tuple(span.front->mesh, span.lane, span.rowBegin);
  };
  // They are if they are of a single mesh.
  if (!std::ranges::is_sorted(all, {}, place)) std::ranges::sort(all, {}, place);
  for (std::size_t begin = 0; begin < all.size();) {
    std::size_t end = begin;
    while (end < all.size() && all[end].front->mesh == all[begin].front->mesh) ++end;
    found.addFaces(all[begin].front->mesh, run.strip, std::span(all).subspan(begin, end - begin));
    begin = end;
  }
}

}  // namespace hearth
