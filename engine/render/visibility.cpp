#include "render/visibility.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <variant>

#include "level/openings.h"
#include "math/check.h"
#include "math/predicates.h"
#include "math/round_up.h"
#include "math/tolerance.h"
#include "render/segment_columns.h"

namespace hearth {

namespace {

class Visibility {
 public:
  Visibility(const Scene& scene, const Camera& camera, const Projection& projection,
             ColumnRange columns, VisibilityScratch& scratch)
      : scene_(scene),
        camera_(camera),
        projection_(projection),
        columns_(columns),
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
    addMaskedMiddles();
    found_.stats.spans = found_.spans.size();
  }

 private:
  void start() {
    found_.spans.clear();
    found_.stats = {};
    scratch_.maskedMiddles.clear();
    scratch_.slants.clear();
    for (int column = columns_.begin; column < columns_.end; ++column)
      scratch_.slants.push_back(projection_.slantOf(column + 0.5));
    Viewport first{camera_.sector, std::nullopt, noWindows()};
    for (int column = columns_.begin; column < columns_.end; ++column)
      first.windows.push_back({column, 0, camera_.height, 0});
    viewports_.push_back(std::move(first));
  }

  /// What lies behind an opening is looked at after it, so that nearer ones were found before.
  void addMaskedMiddles() {
    found_.spans.insert(found_.spans.end(), scratch_.maskedMiddles.rbegin(),
                        scratch_.maskedMiddles.rend());
    found_.stats.maskedMiddleSpans = scratch_.maskedMiddles.size();
  }

  /// Takes the last off a stack; looking may put more there.
  template <typename View>
  void lookAtLast(std::vector<View>& views) {
    View view = std::move(views.back());
    views.pop_back();
    look(view);
    scratch_.spareWindows.giveBack(std::move(view.windows));
  }

  std::vector<Window> noWindows() {
    return scratch_.spareWindows.take(columns_.end - columns_.begin);
  }

  // --- sectors seen from the side ---------------------------------------------------------------

  void look(const Viewport& viewport) {
    ++found_.stats.viewports;
    found_.stats.windows += viewport.windows.size();
    const std::size_t firstNew = viewports_.size();
    const std::size_t firstNewFlat = flatPortals_.size();
    const std::vector<ColumnHit>& hits = closestHits(viewport);
    for (std::size_t i = 0; i < viewport.windows.size(); ++i)
      if (hits[i].depth < kNoDepth)
        showColumn(viewport.sector, viewport.windows[i], hits[i], firstNew, firstNewFlat);
  }

  /// For every window the nearest segment, seen from its front, beyond the viewport's entry; at
  /// kNoDepth where there is none.
  const std::vector<ColumnHit>& closestHits(const Viewport& viewport) {
    std::vector<ColumnHit>& closest = scratch_.closest;
    closest.assign(viewport.windows.size(), {SegmentId(0), kNoDepth, 0});
    const std::vector<Window>& windows = viewport.windows;
    const std::optional<SegmentId> entry = viewport.entry;
    meetSegments(viewport.sector, entry, windows, [&](std::size_t k, const ColumnHit& hit) {
      if (isBeyond(entry, windows[k].depth, hit) && isNearer(hit, closest[k])) set(closest[k], hit);
    });
    return closest;
  }

  static constexpr double kNoDepth = std::numeric_limits<double>::infinity();

  /// Number by number: copied as a whole, it would have to be in memory first.
  static void set(ColumnHit& to, const ColumnHit& hit) {
    to.segment = hit.segment;
    to.depth = hit.depth;
    to.fraction = hit.fraction;
  }

  /// Calls `met(k, hit)` for windows k and the segments, except the one whose fronts they show.
  template <typename Met>
  void meetSegments(SectorId id, std::optional<SegmentId> except,
                    const std::vector<Window>& windows, Met&& met) {
    const Sector& sector = scene_[id];
    for (std::size_t i = 0; i < sector.segmentCount; ++i) {
      const SegmentId segment(sector.firstSegment.index() + i);
      if (segment == except) continue;
      ++found_.stats.segments;
      const ColumnRange columns = columnsOf(projection_, scene_[segment], camera_.width);
      const auto [begin, end] = windowsIn(windows, columns);
      if (begin == end) continue;
      const SegmentMeetings meetings(projection_, scene_[segment]);
      for (std::size_t k = begin; k < end; ++k) {
        const auto [depth, fraction] = meetings.at(slantOf(windows[k].column));
        met(k, ColumnHit{segment, depth, fraction});
      }
    }
  }

  double slantOf(int column) const {
    return scratch_.slants[static_cast<std::size_t>(column - columns_.begin)];
  }

  /// Indices [begin, end) of the windows whose column lies in the range.
  static std::pair<std::size_t, std::size_t> windowsIn(const std::vector<Window>& windows,
                                                       ColumnRange columns) {
    if (columns.end <= windows.front().column || columns.begin > windows.back().column)
      return {0, 0};
    const auto isLeftOf = [](const Window& window, int column) { return window.column < column; };
    const auto begin = std::lower_bound(windows.begin(), windows.end(), columns.begin, isLeftOf);
    const auto end = std::lower_bound(begin, windows.end(), columns.end, isLeftOf);
    return {static_cast<std::size_t>(begin - windows.begin()),
            static_cast<std::size_t>(end - windows.begin())};
  }

  bool isBeyond(std::optional<SegmentId> entry, double entryDepth, const ColumnHit& hit) const {
    if (hit.depth > entryDepth * (1 + kNearTie)) return true;
    if (!entry || hit.depth < entryDepth * (1 - kNearTie)) return false;
    return inOrder(*entry, hit.segment);
  }

  bool isNearer(const ColumnHit& a, const ColumnHit& b) const {
    if (a.depth < b.depth * (1 - kNearTie)) return true;
    if (a.depth > b.depth * (1 + kNearTie)) return false;
    return inOrder(a.segment, b.segment);
  }

  bool inOrder(SegmentId a, SegmentId b) const {
    return meetsFirst(projection_.eye().xy(), scene_[a].p0, scene_[a].p1, scene_[b].p0,
                      scene_[b].p1);
  }

  // --- one column of one sector -----------------------------------------------------------------

  /// Ceiling, wall and floor of a sector in a window, from the height at which the column leaves
  /// it.
  void showColumn(SectorId id, const Window& window, const ColumnHit& hit, std::size_t firstNew,
                  std::size_t firstNewFlat) {
    const Sector& sector = scene_[id];
    const Segment& segment = scene_[hit.segment];
    const AirColumn air = scene_.airAt(segment, hit.fraction);
    const int wallTop = rowIn(window, air.zTop, hit.depth);
    const int wallBottom = std::max(wallTop, rowIn(window, air.zBottom, hit.depth));
    const Window above{window.column, window.top, wallTop, hit.depth};
    const Window below{window.column, wallBottom, window.bottom, hit.depth};
    showFlat(sector.ceiling, sector.ceilingSurface, above, false, firstNewFlat);
    showFlat(sector.floor, sector.floorSurface, below, true, firstNewFlat);
    if (wallTop < wallBottom)
      showWall(segment, air, {window.column, wallTop, wallBottom, hit.depth}, hit, firstNew);
  }

  /// The first row of the window whose centre is not above height z.
  int rowIn(const Window& window, double z, double depth) const {
    const double row = projection_.rowOf(z, depth) - 0.5;
    return roundedUp(
        std::clamp(row, static_cast<double>(window.top), static_cast<double>(window.bottom)));
  }

  void showFlat(const Flat& flat, std::optional<SurfaceId> surface, const Window& window,
                bool isFloor, std::size_t firstNewFlat) {
    if (window.top >= window.bottom) return;
    if (surface) {
      found_.spans.emplace_back(window.column, window.top, window.bottom, *surface, window.depth);
      return;
    }
    addTo(flatPortalView(*flat.flatPortal, isFloor, firstNewFlat).windows, window);
  }

  /// `window` is the part of it that shows the wall: all of the air.
  void showWall(const Segment& segment, AirColumn air, const Window& window, const ColumnHit& hit,
                std::size_t firstNew) {
    countColumn(segment);
    // What lies above something begins where that ends, so most rows are known.
    double zReached = air.zBottom;
    int rowReached = window.bottom;
    const auto part = [&](double zBottom, double zTop) {
      const int bottom = zBottom == zReached ? rowReached : rowIn(window, zBottom, hit.depth);
      rowReached = zTop == air.zTop ? window.top : rowIn(window, zTop, hit.depth);
      zReached = zTop;
      return Window{window.column, rowReached, bottom, hit.depth};
    };
    visitWallColumn(
        scene_, segment, hit.fraction,
        [&](SurfaceId surface, double zBottom, double zTop) {
          const Window shown = part(zBottom, zTop);
          if (shown.top < shown.bottom) addUprightSpan(found_.spans, surface, shown, hit);
        },
        [&](const Opening& opening, double zBottom, double zTop) {
          const Window open = part(zBottom, zTop);
          if (open.top < open.bottom) showOpening(opening, open, hit, firstNew);
        });
  }

  void showOpening(const Opening& opening, const Window& window, const ColumnHit& hit,
                   std::size_t firstNew) {
    addTo(viewportBehind(opening, firstNew).windows, window);
    if (!opening.maskedMiddle) return;
    const SurfaceGeometry& middle = scene_.geometryOf(*opening.maskedMiddle);
    const int top = rowIn(window, middle.zTop, hit.depth);
    const int bottom = rowIn(window, middle.zBottom, hit.depth);
    if (top < bottom)
      addUprightSpan(scratch_.maskedMiddles, *opening.maskedMiddle,
                     {window.column, top, bottom, hit.depth}, hit);
  }

  void countColumn(const Segment& segment) {
    ++found_.stats.wallColumns;
    if (std::holds_alternative<Stack>(segment.wall)) ++found_.stats.stackColumns;
    if (scene_.geometryOf(segment).airRises) ++found_.stats.slopeColumns;
  }

  static void addTo(std::vector<Window>& windows, const Window& window) {
    windows.emplace_back(window.column, window.top, window.bottom, window.depth);
  }

  void addUprightSpan(std::vector<Span>& to, SurfaceId id, const Window& window,
                      const ColumnHit& hit) const {
    const Surface& surface = scene_[id];
    const Segment& segment = scene_[hit.segment];
    Span& span = to.emplace_back(window.column, window.top, window.bottom, id, hit.depth);
    span.fraction = hit.fraction;
    span.s = segment.sBefore + hit.fraction * segment.length;
    if (isSidewall(surface.kind)) {
      // A sidewall wears the far wall's texture, from that wall's right end as seen from inside.
      const Segment& far = scene_[twinOf(segment, id)];
      span.s = far.sAfter + hit.fraction * far.length;
      const AirColumn edge = scene_.airAt(far, 1 - hit.fraction);
      span.zRef = surface.kind == SurfaceKind::FloorSidewall ? edge.zBottom : edge.zTop;
    }
    if (const auto zRef = scene_.geometryOf(id).zRef) span.zRef = *zRef;
  }

  SegmentId twinOf(const Segment& segment, SurfaceId sidewall) const {
    for (const WallPiece& piece : scene_.piecesOf(segment)) {
      const Opening* opening = std::get_if<Opening>(&piece.content);
      if (opening && (opening->floorSidewall == sidewall || opening->ceilingSidewall == sidewall))
        return opening->twin;
    }
    CHECK(false, sidewall);
  }

  /// The viewport behind an opening, among those begun by the present look.
  Viewport& viewportBehind(const Opening& opening, std::size_t firstNew) {
    for (std::size_t i = viewports_.size(); i-- > firstNew;)
      if (viewports_[i].entry == opening.twin && viewports_[i].sector == opening.next)
        return viewports_[i];
    viewports_.push_back({opening.next, opening.twin, noWindows()});
    return viewports_.back();
  }

  // --- sectors seen through flat portals --------------------------------------------------------

  FlatPortalView& flatPortalView(FlatPortalId id, bool down, std::size_t firstNew) {
    for (std::size_t i = flatPortals_.size(); i-- > firstNew;)
      if (flatPortals_[i].flatPortal == id && flatPortals_[i].down == down) return flatPortals_[i];
    flatPortals_.push_back({id, down, noWindows()});
    return flatPortals_.back();
  }

  void look(const FlatPortalView& view) {
    ++found_.stats.flatPortals;
    found_.stats.windows += view.windows.size();
    const std::size_t firstNew = viewports_.size();
    const std::size_t firstNewFlat = flatPortals_.size();
    const FlatPortal& flatPortal = scene_[view.flatPortal];
    findStretches(view.down ? flatPortal.lower : flatPortal.upper, view.windows);
    for (std::size_t i = 0; i < view.windows.size(); ++i)
      lookThroughPlane(flatPortal.z, view.down, view.windows[i], stretchesOf(i), firstNew,
                       firstNewFlat);
  }

  /// Divides a window on the plane among the stretches behind it, near to far, without gap.
  void lookThroughPlane(double z, bool down, Window window, std::span<const Stretch> stretches,
                        std::size_t firstNew, std::size_t firstNewFlat) {
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      const ColumnHit& exit = stretches[i].exit;
      // The farthest stretch ends where the window does, whatever rounding says; one that ends
      // before the window begins must not turn the look back, or it might go on for ever.
      const bool rest = i + 1 == stretches.size() && exit.depth > window.depth * (1 - kNearTie);
      const int farRow = rest ? (down ? window.top : window.bottom) : rowIn(window, z, exit.depth);
      Window part = window;
      (down ? part.top : part.bottom) = farRow;
      (down ? window.bottom : window.top) = farRow;
      if (part.top < part.bottom)
        showColumn(stretches[i].sector, part, exit, firstNew, firstNewFlat);
    }
  }

  /// For every window the stretches of its column inside the members, by rising depth. Only where
  /// the ray leaves a member matters: where it came in, another stretch has ended.
  void findStretches(const std::vector<SectorId>& members, const std::vector<Window>& windows) {
    scratch_.stretches.clear();
    for (const SectorId member : members) addStretches(member, windows);
    groupByWindow(windows.size());
    for (std::size_t i = 0; i < windows.size(); ++i) sortByDepth(stretchesOf(i));
  }

  void addStretches(SectorId id, const std::vector<Window>& windows) {
    meetSegments(id, std::nullopt, windows, [&](std::size_t k, const ColumnHit& exit) {
      scratch_.stretches.push_back({k, {id, exit}});
    });
  }

  /// Counts the stretches of each window, and puts them where those of the windows before end.
  void groupByWindow(std::size_t windowCount) {
    std::vector<std::size_t>& begin = scratch_.stretchesBegin;
    begin.assign(windowCount + 2, 0);
    for (const auto& [window, stretch] : scratch_.stretches) ++begin[window + 2];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    scratch_.stretchesByWindow.resize(scratch_.stretches.size());
    for (const auto& [window, stretch] : scratch_.stretches)
      scratch_.stretchesByWindow[begin[window + 1]++] = stretch;
  }

  std::span<Stretch> stretchesOf(std::size_t window) {
    const std::size_t begin = scratch_.stretchesBegin[window];
    return std::span(scratch_.stretchesByWindow)
        .subspan(begin, scratch_.stretchesBegin[window + 1] - begin);
  }

  /// Near to far, near ties in exact order.
  void sortByDepth(std::span<Stretch> stretches) const {
    std::ranges::sort(stretches, {}, [](const Stretch& stretch) { return stretch.exit.depth; });
    for (std::size_t i = 1; i < stretches.size(); ++i)
      for (std::size_t k = i; k > 0 && isNearer(stretches[k].exit, stretches[k - 1].exit); --k)
        std::swap(stretches[k], stretches[k - 1]);
  }

  Scene scene_;
  const Camera& camera_;
  const Projection& projection_;
  ColumnRange columns_;
  VisibilityScratch& scratch_;
  VisibleSpans& found_;
  std::vector<Viewport>& viewports_;
  std::vector<FlatPortalView>& flatPortals_;
};

}  // namespace

const VisibleSpans& findVisibleSpans(const Scene& scene, const Camera& camera,
                                     const Projection& projection, ColumnRange columns,
                                     VisibilityScratch& scratch) {
  Visibility(scene, camera, projection, columns, scratch).find();
  return scratch.found;
}

}  // namespace hearth
