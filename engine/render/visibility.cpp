#include "render/visibility.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <variant>

#include "level/openings.h"
#include "math/tolerance.h"
#include "render/column_run.h"
#include "render/ray_exits.h"
#include "render/span_groups.h"

namespace hearth {

namespace {

class Visibility {
 public:
  Visibility(const Scene& scene, const SpriteIndex& sprites, const Camera& camera,
             const Projection& projection, ColumnRange columns, VisibilityScratch& scratch)
      : scene_(scene),
        camera_(camera),
        projection_(projection),
        columns_(columns),
        exits_(scene, projection, camera.width, columns, scratch.rayExits),
        hasSprites_(!sprites.isEmpty()),
        sprites_(scene, sprites, camera, projection, columns, scratch.sprites),
        hasMeshes_(!scene.level().meshes.empty()),
        meshes_(scene, camera, projection, columns, scratch.meshes),
        scratch_(scratch),
        found_(scratch.found),
        viewports_(scratch.viewports),
        flatPortals_(scratch.flatPortals) {}

  void find() {
    start();
    while (!viewports_.empty() || !flatPortals_.empty()) {
      if (!viewports_.empty())
        lookAtLast(viewports_);
      else
        lookAtLast(flatPortals_);
    }
    found_.stats.segments = exits_.projectedSegments();
    found_.stats.sprites = scratch_.sprites.fronts.count();
    found_.stats.faces = hasMeshes_ ? scratch_.meshes.fronts.count() : 0;
    found_.stats.maskedSpans = found_.overLevel.spans();
    found_.stats.spans = found_.level.spans() + found_.overLevel.spans();
  }

 private:
  void start() {
    const int firstStrip = columns_.begin / Strip::kColumns;
    const int strips = Strip::countIn(columns_.end - columns_.begin);
    found_.level.clear(firstStrip, strips);
    found_.overLevel.clear(firstStrip, strips);
    found_.stats = {};
    Viewport first{nullptr, camera_.sector, std::nullopt, std::nullopt, noWindows()};
    for (int column = columns_.begin; column < columns_.end; ++column)
      first.windows.emplace_back(column, 0, camera_.height, 0);
    viewports_.push_back(std::move(first));
  }

  /// Takes the last off a stack; looking may put more there. So what lies behind an opening is
  /// looked at after it. New ones are in the order of the level, not of the columns that see them
  /// first: so a strip's groups, and all that is rounded on the way through them, do not depend on
  /// the strips that are found with it.
  template <typename View>
  void lookAtLast(std::vector<View>& views) {
    View view = std::move(views.back());
    views.pop_back();
    firstNewViewport_ = viewports_.size();
    firstNewFlatPortal_ = flatPortals_.size();
    look(view);
    sortFrom(viewports_, firstNewViewport_);
    sortFrom(flatPortals_, firstNewFlatPortal_);
    scratch_.spareWindows.giveBack(std::move(view.windows));
  }

  template <typename View>
  static void sortFrom(std::vector<View>& views, std::size_t first) {
    std::ranges::sort(std::span(views).subspan(first), {}, &View::place);
  }

  std::vector<Window> noWindows() {
    return scratch_.spareWindows.take(columns_.end - columns_.begin);
  }

  // --- sectors seen from the side ---------------------------------------------------------------

  void look(const Viewport& viewport) {
    ++found_.stats.viewports;
    const std::vector<Window>& windows = viewport.windows;
    found_.stats.windows += windows.size();
    if (hasMeshes_) lookedThrough_ = rectAround(windows);
    const std::vector<ColumnHit>& hits = exits_.closest(viewport.sector, viewport.entry, windows);
    for (std::size_t i = 0; i < windows.size();) {
      if (hits[i].depth == RayExits::kNoDepth) {
        ++i;
        continue;
      }
      const std::size_t first = i;
      ColumnRun run(scene_[viewport.sector], scene_[hits[i].segment], windows[i], hits[i]);
      while (++i < windows.size() && hits[i].depth < RayExits::kNoDepth &&
             run.continuesIn(windows[i], hits[i]))
        run.add(windows[i], hits[i]);
      if (hasSprites_ || hasMeshes_)
        showThings(run, entryThrough(viewport.from, std::span(windows).subspan(first, i - first)));
      show(run);
    }
  }

  /// Of a run whose columns are those of some windows.
  static RunEntry entryThrough(std::optional<SectorId> from, std::span<const Window> windows) {
    RunEntry entry;
    entry.from = from;
    for (const Window& window : windows)
      entry.depths[static_cast<std::size_t>(window.column % Strip::kColumns)] = window.depth;
    return entry;
  }

  /// Adds the sprites and meshes of the run's sector before what lies behind it is looked at:
  /// `overLevel` is filled from near to far. Sprites come first, as far as no mesh hides them.
  void showThings(const ColumnRun& run, const RunEntry& entry) {
    const bool meshesShow = hasMeshes_ && meshes_.find(run, entry, lookedThrough_);
    if (hasSprites_) sprites_.show(run, entry, meshesShow ? &meshes_ : nullptr, found_.overLevel);
    if (meshesShow) meshes_.show(run, found_.overLevel);
  }

  // --- columns that leave a sector at one segment -----------------------------------------------

  /// Ceiling, wall and floor of a sector, from the height at which the columns leave it.
  void show(const ColumnRun& run) {
    LaneRowRanges wall;
    for (std::size_t lane = run.laneBegin; lane < run.laneEnd; ++lane) {
      const AirColumn air = scene_.airAt(run.segment, run.fractions[lane]);
      wall.begin[lane] = rowIn(run, run.open, lane, air.zTop);
      wall.end[lane] = std::max(wall.begin[lane], rowIn(run, run.open, lane, air.zBottom));
    }
    showFlat(run, run.sector.ceiling, run.sector.ceilingSurface, {run.open.begin, wall.begin},
             false);
    showFlat(run, run.sector.floor, run.sector.floorSurface, {wall.end, run.open.end}, true);
    if (wall.lanes() != 0) showWall(run, wall);
  }

  /// The first of a lane's rows whose centre is not above height z.
  int rowIn(const ColumnRun& run, const LaneRowRanges& rows, std::size_t lane, double z) const {
    return projection_.rowIn(rows.begin[lane], rows.end[lane], z, run.depths[lane]);
  }

  void showFlat(const ColumnRun& run, const Flat& flat, std::optional<SurfaceId> surface,
                const LaneRowRanges& rows, bool isFloor) {
    if (!surface) {
      if (rows.lanes() != 0) addWindows(run, rows, flatPortalView(*flat.flatPortal, isFloor));
    } else if (const auto [group, lanes] = found_.level.add(*surface, run.strip, rows); group) {
      setLanes(group->depth, run.depths, lanes);
    }
  }

  /// `shown` are the rows that show the wall: all of the air.
  void showWall(const ColumnRun& run, const LaneRowRanges& shown) {
    countColumns(run.segment, shown.laneCount());
    std::vector<WallPart>& parts = scratch_.wallParts;
    parts.clear();
    if (run.hasLevelAir)
      addParts(run, run.laneBegin, run.laneEnd, shown);
    else
      for (std::size_t lane = run.laneBegin; lane < run.laneEnd; ++lane)
        if (shown.has(lane)) addParts(run, lane, lane + 1, shown);
    for (const WallPart& part : parts)
      if (part.opening)
        showOpening(run, *part.opening, part.rows);
      else
        addUprightSpans(found_.level, part.surface, run, part.rows);
  }

  /// Adds what the wall shows in lanes [begin, end), where it has the same heights.
  void addParts(const ColumnRun& run, std::size_t begin, std::size_t end,
                const LaneRowRanges& shown) {
    const double fraction = run.fractions[begin];
    const AirColumn air = scene_.airAt(run.segment, fraction);
    // What lies above something begins where that ends, so most rows are known.
    double zReached = air.zBottom;
    LaneRows reached = shown.end;
    const auto add = [&](const Opening* opening, SurfaceId surface, double zBottom, double zTop) {
      LaneRowRanges& rows = partOf(opening, surface).rows;
      for (std::size_t lane = begin; lane < end; ++lane) {
        rows.end[lane] = zBottom == zReached ? reached[lane] : rowIn(run, shown, lane, zBottom);
        rows.begin[lane] = zTop == air.zTop ? shown.begin[lane] : rowIn(run, shown, lane, zTop);
        reached[lane] = rows.begin[lane];
      }
      zReached = zTop;
    };
    visitWallColumn(
        scene_, run.segment, fraction,
        [&](SurfaceId surface, double zBottom, double zTop) {
          add(nullptr, surface, zBottom, zTop);
        },
        [&](const Opening& opening, double zBottom, double zTop) {
          add(&opening, {}, zBottom, zTop);
        });
  }

  WallPart& partOf(const Opening* opening, SurfaceId surface) {
    std::vector<WallPart>& parts = scratch_.wallParts;
    for (WallPart& part : parts)
      if (part.opening == opening && part.surface == surface) return part;
    return parts.emplace_back(WallPart{opening, surface, {}});
  }

  void showOpening(const ColumnRun& run, const Opening& opening, const LaneRowRanges& rows) {
    if (rows.lanes() == 0) return;
    addWindows(run, rows, viewportBehind(opening, run.sector.id));
    if (!opening.maskedMiddle) return;
    const SurfaceGeometry& middle = scene_.geometryOf(*opening.maskedMiddle);
    LaneRowRanges hung;
    for (std::size_t lane = run.laneBegin; lane < run.laneEnd; ++lane) {
      hung.begin[lane] = rowIn(run, rows, lane, middle.zTop);
      hung.end[lane] = rowIn(run, rows, lane, middle.zBottom);
    }
    addUprightSpans(found_.overLevel, *opening.maskedMiddle, run, hung);
  }

  void countColumns(const Segment& segment, int columns) {
    const auto count = static_cast<std::size_t>(columns);
    found_.stats.wallColumns += count;
    if (std::holds_alternative<Stack>(segment.wall)) found_.stats.stackColumns += count;
    if (scene_.geometryOf(segment).airRises) found_.stats.slopeColumns += count;
  }

  static void addWindows(const ColumnRun& run, const LaneRowRanges& rows,
                         std::vector<Window>& windows) {
    for (std::size_t lane = run.laneBegin; lane < run.laneEnd; ++lane)
      if (rows.has(lane))
        windows.emplace_back(run.strip * Strip::kColumns + static_cast<int>(lane), rows.begin[lane],
                             rows.end[lane], run.depths[lane]);
  }

  void addUprightSpans(SpanGroups& to, SurfaceId id, const ColumnRun& run,
                       const LaneRowRanges& rows) const {
    const auto [group, lanes] = to.add(id, run.strip, rows);
    if (!group) return;
    setLanes(group->depth, run.depths, lanes);
    setLanes(group->fraction, run.fractions, lanes);
  }

  /// Into the viewport behind an opening: among those begun by the present look.
  std::vector<Window>& viewportBehind(const Opening& opening, SectorId from) {
    for (std::size_t i = viewports_.size(); i-- > firstNewViewport_;)
      if (viewports_[i].opening == &opening) return viewports_[i].windows;
    viewports_.push_back({&opening, opening.next, opening.twin, from, noWindows()});
    return viewports_.back().windows;
  }

  // --- sectors seen through flat portals --------------------------------------------------------

  std::vector<Window>& flatPortalView(FlatPortalId id, bool down) {
    for (std::size_t i = flatPortals_.size(); i-- > firstNewFlatPortal_;)
      if (flatPortals_[i].flatPortal == id && flatPortals_[i].down == down)
        return flatPortals_[i].windows;
    flatPortals_.push_back({id, down, noWindows()});
    return flatPortals_.back().windows;
  }

  void look(const FlatPortalView& view) {
    ++found_.stats.flatPortals;
    found_.stats.windows += view.windows.size();
    if (hasMeshes_) lookedThrough_ = rectAround(view.windows);
    const FlatPortal& flatPortal = scene_[view.flatPortal];
    exits_.findStretches(view.down ? flatPortal.lower : flatPortal.upper, view.windows);
    for (std::size_t i = 0; i < view.windows.size(); ++i)
      lookThroughPlane(flatPortal.z, view.down, view.windows[i], exits_.stretchesOf(i));
  }

  /// Divides a window on the plane among the stretches behind it, near to far, without gap.
  /// One column at a time: its neighbours are divided differently.
  void lookThroughPlane(double z, bool down, Window window, std::span<const Stretch> stretches) {
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      const auto& [sector, exit] = stretches[i];
      // The farthest stretch ends where the window does, whatever rounding says; one that ends
      // before the window begins must not turn the look back, or it might go on for ever.
      const bool rest = i + 1 == stretches.size() && exit.depth > window.depth * (1 - kNearTie);
      const int farRow = rest ? (down ? window.top : window.bottom)
                              : projection_.rowIn(window.top, window.bottom, z, exit.depth);
      Window part = window;
      (down ? part.top : part.bottom) = farRow;
      (down ? window.bottom : window.top) = farRow;
      if (part.top >= part.bottom) continue;
      const ColumnRun run(scene_[sector], scene_[exit.segment], part, exit);
      if (hasSprites_ || hasMeshes_) showThings(run, {{}, std::nullopt, z});
      show(run);
    }
  }

  Scene scene_;
  const Camera& camera_;
  const Projection& projection_;
  ColumnRange columns_;
  RayExits exits_;
  bool hasSprites_;
  SpriteSpans sprites_;
  bool hasMeshes_;
  MeshSpans meshes_;
  VisibilityScratch& scratch_;
  VisibleSpans& found_;
  std::vector<Viewport>& viewports_;
  std::vector<FlatPortalView>& flatPortals_;
  // Of the present look:
  PictureRect lookedThrough_{};  ///< around its windows; found if there are meshes
  std::size_t firstNewViewport_ = 0;
  std::size_t firstNewFlatPortal_ = 0;
};

}  // namespace

const VisibleSpans& findVisibleSpans(const Scene& scene, const SpriteIndex& sprites,
                                     const Camera& camera, const Projection& projection,
                                     ColumnRange columns, VisibilityScratch& scratch) {
  Visibility(scene, sprites, camera, projection, columns, scratch).find();
  return scratch.found;
}

}  // namespace hearth
