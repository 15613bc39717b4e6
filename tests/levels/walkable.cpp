#include "walkable.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "level/locate.h"
#include "level/openings.h"

namespace hearth::test {
namespace {

constexpr double kRounding = 1e-6;  // metres: heights that are meant to be alike

/// Whether a walker gets through the opening `fraction` of the way along its segment.
bool isOpenAt(const Scene& scene, const Segment& segment, const WallPiece& piece, double fraction,
              const Gait& gait) {
  const AirColumn near = scene.airAt(segment, fraction);
  const AirColumn far = scene.airAt(scene[std::get<Opening>(piece.content).twin], 1 - fraction);
  const OpeningSpan span = openingSpan(piece, near, far);
  const double sill = std::max({near.zBottom, far.zBottom, span.zBottom});
  return sill - near.zBottom <= gait.stepHeight + kRounding &&
         span.zTop - sill >= gait.headroom - kRounding;
}

/// The doorways of one loop: openings to one sector may run on over several segments in line.
class Doorways {
 public:
  Doorways(const Scene& scene, const Gait& gait) : scene_(scene), gait_(gait) {}

  void pass(const Segment& segment, std::set<std::size_t>& ways) {
    std::map<std::size_t, double> reaching;
    for (const WallPiece& piece : scene_.piecesOf(segment)) {
      const auto* opening = std::get_if<Opening>(&piece.content);
      if (!opening) continue;
      const std::size_t next = opening->next.index();
      double width = continues(segment) && open_.contains(next) ? open_[next] : 0;
      for (int i = 0; i < kFractions; ++i) {
        const bool isOpen = isOpenAt(scene_, segment, piece, (i + 0.5) / kFractions, gait_);
        width = isOpen ? width + segment.length / kFractions : 0;
        if (width >= gait_.doorWidth - kRounding) ways.insert(next);
      }
      reaching[next] = width;
    }
    open_ = reaching;
    last_ = &segment;
  }

 private:
  static constexpr int kFractions = 64;

  bool continues(const Segment& segment) const {
    if (!last_ || last_->loop != segment.loop) return false;
    const Vec2 before = last_->p1 - last_->p0;
    const Vec2 after = segment.p1 - segment.p0;
    return dot(before, after) > 0.9999 * last_->length * segment.length;
  }

  Scene scene_;
  const Gait& gait_;
  const Segment* last_ = nullptr;
  std::map<std::size_t, double> open_;  ///< metres up to the last segment's end, by next sector
};

double distanceTo(const Segment& segment, Vec2 p) {
  const Vec2 along = segment.p1 - segment.p0;
  const double fraction = std::clamp(dot(p - segment.p0, along) / dot(along, along), 0.0, 1.0);
  const Vec2 apart = p - (segment.p0 + fraction * along);
  return std::sqrt(dot(apart, apart));
}

bool fits(const Scene& scene, const Sector& sector, Vec2 p, const Gait& gait) {
  constexpr double kSpare = 0.005;
  return contains(scene.level(), sector, p) &&
         scene.airTop(sector, p) - scene.airBottom(sector, p) >= gait.headroom &&
         std::ranges::all_of(scene.segmentsOf(sector), [&](const Segment& segment) {
           return distanceTo(segment, p) > gait.radius + kSpare;
         });
}

}  // namespace

Ways waysOf(const Scene& scene, const Gait& gait) {
  const Level& level = scene.level();
  Ways ways(level.sectors.size());
  for (std::size_t i = 0; i < level.sectors.size(); ++i) {
    Doorways doorways(scene, gait);
    for (const Segment& segment : scene.segmentsOf(level.sectors[i]))
      doorways.pass(segment, ways[i]);
  }
  for (const FlatPortal& flatPortal : level.flatPortals)
    for (const SectorId upper : flatPortal.upper)
      for (const SectorId lower : flatPortal.lower) ways[upper.index()].insert(lower.index());
  return ways;
}

Ways reversed(const Ways& ways) {
  Ways back(ways.size());
  for (std::size_t from = 0; from < ways.size(); ++from)
    for (const std::size_t to : ways[from]) back[to].insert(from);
  return back;
}

std::set<std::size_t> reachableFrom(const Ways& ways, std::size_t start) {
  std::set<std::size_t> found{start};
  std::vector<std::size_t> open{start};
  while (!open.empty()) {
    const std::size_t from = open.back();
    open.pop_back();
    for (const std::size_t to : ways[from])
      if (found.insert(to).second) open.push_back(to);
  }
  return found;
}

bool hasRoom(const Scene& scene, const Sector& sector, const Gait& gait) {
  if (sector.floor.isSky) return false;
  if (sector.floorSlope) {
    const Vec2 gradient = sector.floorSlope->gradient;
    if (std::sqrt(dot(gradient, gradient)) > gait.steepest) return false;
  }
  constexpr double kGrid = 0.05;
  for (double x = sector.box.min.x; x <= sector.box.max.x; x += kGrid)
    for (double y = sector.box.min.y; y <= sector.box.max.y; y += kGrid)
      if (fits(scene, sector, {x, y}, gait)) return true;
  return false;
}

}  // namespace hearth::test
