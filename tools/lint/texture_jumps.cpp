#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <map>

#include "lint/authored_wall.h"
#include "lint/sector_graph.h"
#include "lint/texture_placement.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

/// Levels by which the image must differ on the mean from itself, moved by the jump. Bricks and
/// boards do; plaster and grass do not, nor does what comes again within the image.
constexpr double kSeen = 8;

/// Pixels of the image, along and down, that are looked at for that: enough for a mean.
constexpr int kLookedAt = 128;

/// Where a surface of a wall begins or ends: the place of its image there.
struct ImageEnd {
  double u;  ///< in repeats
  double v;  ///< where z is 0, likewise
};

ImageEnd imageAt(const TextureMapping& mapping, const TexturePlacement& placement, double s,
                 const Image& image) {
  return {(s + placement.along) / mapping.repeat.x - mapping.offsetTexels.x / image.width(),
          placement.z / mapping.repeat.y - mapping.offsetTexels.y / image.height()};
}

/// Pixels from a whole number of repeats.
double pixelsOff(double repeats, int pixels) {
  return std::abs(repeats - std::round(repeats)) * pixels;
}

/// From 0 to 1: the part of a jump that is no whole number of repeats.
double partOf(double repeats) { return repeats - std::floor(repeats); }

/// Mean difference in levels between the image and itself, moved by these parts of it.
double differenceMoved(const Image& image, double u, double v) {
  const int right = static_cast<int>(std::round(u * image.width()));
  const int down = static_cast<int>(std::round(v * image.height()));
  const int stepX = std::max(1, image.width() / kLookedAt);
  const int stepY = std::max(1, image.height() / kLookedAt);
  std::int64_t sum = 0;
  std::int64_t count = 0;
  for (int y = 0; y < image.height(); y += stepY)
    for (int x = 0; x < image.width(); x += stepX) {
      const Rgb p = image.at(x, y);
      const Rgb q = image.at((x + right) % image.width(), (y + down) % image.height());
      sum += std::abs(p.r - q.r) + std::abs(p.g - q.g) + std::abs(p.b - q.b);
      count += 3;
    }
  return static_cast<double>(sum) / static_cast<double>(count);
}

class JumpFinder {
 public:
  JumpFinder(const LintedLevel& linted, Findings& findings)
      : linted_(linted),
        scene_(linted.scene()),
        findings_(findings),
        linked_(undirected(sectorGraph(scene_.level()))) {
    for (const SurfaceId surface : scene_.shownSurfaces())
      if (isOfWall(surface)) starting_.emplace(segmentOf(surface).p0, surface);
  }

  void look() {
    for (const SurfaceId surface : fromLeftToRight()) {
      const auto [first, last] = starting_.equal_range(segmentOf(surface).p1);
      for (auto next = first; next != last; ++next) lookAtJoint(surface, next->second);
    }
  }

 private:
  bool isOfWall(SurfaceId surface) const {
    const SurfaceKind kind = scene_[surface].kind;
    return isUpright(kind) && !isSky(kind) && !isSidewall(kind) &&
           kind != SurfaceKind::MaskedMiddle;
  }

  /// So that along a row of walls, whatever the order of their sectors, each is mended before the
  /// next one is compared with it.
  std::vector<SurfaceId> fromLeftToRight() const {
    std::vector<std::pair<double, SurfaceId>> ordered;  // by metres along the own line
    for (const SurfaceId surface : scene_.shownSurfaces()) {
      if (!isOfWall(surface)) continue;
      const Segment& segment = segmentOf(surface);
      ordered.emplace_back(dot(segment.p0, segment.p1 - segment.p0) / segment.length, surface);
    }
    std::ranges::stable_sort(ordered, {}, &std::pair<double, SurfaceId>::first);
    std::vector<SurfaceId> surfaces;
    for (const auto& [along, surface] : ordered) surfaces.push_back(surface);
    return surfaces;
  }

  const TextureMapping& mappingOf(SurfaceId surface) const { return scene_[surface].mapping; }
  const Segment& segmentOf(SurfaceId surface) const { return scene_[*scene_[surface].segment]; }
  const Image& imageOf(SurfaceId surface) const {
    return linted_.loaded.textures[mappingOf(surface).texture.index()];
  }

  void lookAtJoint(SurfaceId left, SurfaceId right) {
    if (!areAlike(mappingOf(left), mappingOf(right)) || !areInOnePlane(left, right)) return;
    if (!touch(left, right) || !areSeenTogether(scene_[left].sector, scene_[right].sector)) return;
    const ImageEnd jump =
        jumpAt(left, placementOf(linted_, left), right, placementOf(linted_, right));
    if (!isSeen(jump, imageOf(left))) return;
    // What was told before mends walls together: a row of them, or all pieces of one.
    const ImageEnd rest = jumpAt(left, mendedPlacementOf(left), right, mendedPlacementOf(right));
    if (isSeen(rest, imageOf(left))) report(left, right, jump, rest);
  }

  /// From where the image of the left surface ends to where that of the right one begins.
  ImageEnd jumpAt(SurfaceId left, const TexturePlacement& placementLeft, SurfaceId right,
                  const TexturePlacement& placementRight) const {
    const Image& image = imageOf(left);
    const Segment& before = segmentOf(left);
    const ImageEnd end =
        imageAt(mappingOf(left), placementLeft, before.sBefore + before.length, image);
    const ImageEnd start =
        imageAt(mappingOf(right), placementRight, segmentOf(right).sBefore, image);
    // Two heights that were both written down are meant: beams and ribs have stones of their
    // own.
    const bool areMeant = placementLeft.hasZRef && placementRight.hasZRef;
    // In grids nobody can shift the image of a single wall along it.
    const bool canMove = !isOfGrid(linted_, left) && !isOfGrid(linted_, right);
    return {canMove ? start.u - end.u : 0, areMeant ? 0 : start.v - end.v};
  }

  static bool isSeen(const ImageEnd& jump, const Image& image) {
    return differenceMoved(image, partOf(jump.u), partOf(jump.v)) > kSeen;
  }

  /// One for all pieces of a wall, even where one wall of the file stands for all of a loop.
  using TextureOnWall = std::pair<std::uint32_t, Place>;
  TextureOnWall onWall(SurfaceId surface) const {
    constexpr std::uint32_t kAllOfGrid = ~std::uint32_t{0};
    return {isOfGrid(linted_, surface) ? kAllOfGrid
                                       : linted_.source.edgeOf[segmentOf(surface).id.index()],
            textureOf(linted_, surface).description->name.place};
  }

  /// As it would be with what has been told.
  TexturePlacement mendedPlacementOf(SurfaceId surface) const {
    TexturePlacement placement = placementOf(linted_, surface);
    const auto mended = mended_.find(onWall(surface));
    if (mended == mended_.end()) return placement;
    if (!isOfGrid(linted_, surface)) placement.along = mended->second.along;
    if (mended->second.hasZRef) placement.z = mended->second.z;
    placement.hasZRef |= mended->second.hasZRef;
    return placement;
  }

  static bool areAlike(const TextureMapping& a, const TextureMapping& b) {
    return a.texture == b.texture && a.repeat == b.repeat;
  }

  bool areInOnePlane(SurfaceId left, SurfaceId right) const {
    const Segment& a = segmentOf(left);
    const Segment& b = segmentOf(right);
    const Vec2 along = a.p1 - a.p0;
    return dot(along, b.p1 - b.p0) > 0 &&
           std::abs(cross(along, b.p1 - b.p0)) / a.length <= noiseOf(std::min(a.length, b.length));
  }

  bool touch(SurfaceId left, SurfaceId right) const {
    const SurfaceGeometry& a = scene_.geometryOf(left);
    const SurfaceGeometry& b = scene_.geometryOf(right);
    return std::min(a.zTop, b.zTop) - std::max(a.zBottom, b.zBottom) > kAuthorNoise;
  }

  bool areSeenTogether(SectorId a, SectorId b) const {
    return a == b || std::ranges::binary_search(linked_[a.index()], b);
  }

  void report(SurfaceId left, SurfaceId right, const ImageEnd& jump, const ImageEnd& rest) {
    const Image& image = imageOf(right);
    const Vec2 joint = segmentOf(right).p0;
    const bool isLevel = pixelsOff(rest.v, image.height()) < 0.5;
    TexturePlacement mended = shiftedBack(mendedPlacementOf(right), mappingOf(right).repeat, rest.u,
                                          isLevel ? 0 : rest.v);
    if (isOfGrid(linted_, right)) mended.along = textureOf(linted_, right).description->along;
    mended_.insert_or_assign(onWall(right), mended);
    findings_.add(
        FindingKind::TextureJump, placeOf(linted_, right),
        fmt::format("\"{}\" jumps by {:.0f} pixels along and {:.0f} up at ({}, {}), where it meets "
                    "the {} of sector \"{}\"",
                    scene_.level().textures[mappingOf(right).texture.index()],
                    pixelsOff(jump.u, image.width()), pixelsOff(jump.v, image.height()), joint.x,
                    joint.y, name(scene_[left].kind), scene_[scene_[left].sector].name),
        fmt::format("{} {}", standsForAll(right) ? "give each wall its own, and this one" : "write",
                    placementText(textureOf(linted_, right), mended)));
  }

  /// Whether the file has one wall for all of the loop.
  bool standsForAll(SurfaceId surface) const {
    const Edge& edge = linted_.source.edge(segmentOf(surface).id);
    return describedLoop(linted_.source.level, linted_.source.outlines, edge).walls.size() == 1;
  }

  const LintedLevel& linted_;
  Scene scene_;
  Findings& findings_;
  std::vector<std::vector<SectorId>> linked_;
  std::multimap<Vec2, SurfaceId, decltype(&lessXY)> starting_{&lessXY};  ///< by p0
  std::map<TextureOnWall, TexturePlacement> mended_;                     ///< as told
};

}  // namespace

void findTextureJumps(const LintedLevel& linted, Findings& findings) {
  JumpFinder(linted, findings).look();
}

}  // namespace hearth
