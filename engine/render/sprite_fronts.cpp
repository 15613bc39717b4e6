#include "render/sprite_fronts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

namespace hearth {

namespace {

Vec2 pictureRight(const Projection& projection) { return turned90(projection.direction()); }

struct ShownImage {
  const SpriteView& view;
  SpriteRect rect;
};

ShownImage shownOf(const Sprite& sprite, const Projection& projection, double seconds) {
  const SpriteView& view = viewOf(sprite, projection.eye().xy(), seconds);
  return {view, rectOf(sprite, view, pictureRight(projection))};
}

}  // namespace

void SpriteFront::Depths::keepPositive(double atEye, double perMetre) {
  const double zero = -atEye / perMetre;
  if (perMetre > 0)
    from = std::max(from, zero);
  else if (perMetre < 0)
    to = std::min(to, zero);
  else if (atEye < 0)
    to = 0;
}

SpriteFront::SpriteFront(const Sprite& sprite, const SpriteView& view, const SpriteRect& rect,
                         const Projection& projection, int width)
    : surface_(sprite.surface),
      thing_(sprite.thing),
      view_(&view),
      lies_(sprite.facing == Facing::Flat),
      zBottom_(rect.corner.z),
      zTop_(rect.corner.z + rect.up.z),
      lower_{projection.toCamera(rect.corner.xy()), projection.toCameraDirection(rect.right.xy())},
      up_(projection.toCameraDirection(rect.up.xy())),
      columns_{} {
  if (sprite.facing == Facing::Camera) {
    // The depth of the whole image, whatever the rounding of its edges.
    lower_.corner.depth = projection.toCamera(sprite.position.xy()).depth;
    lower_.along.depth = 0;
  }
  columns_ = columnsIn(projection, width);
}

CameraPoint SpriteFront::at(double right, double up) const {
  return {lower_.corner.depth + right * lower_.along.depth + up * up_.depth,
          lower_.corner.lateral + right * lower_.along.lateral + up * up_.lateral};
}

ColumnRange SpriteFront::columnsIn(const Projection& projection, int width) const {
  const std::array<CameraPoint, 4> corners{at(0, 0), at(1, 0), at(0, 1), at(1, 1)};
  const auto isAhead = [](CameraPoint p) { return p.depth > 0; };
  if (std::ranges::none_of(corners, isAhead)) return {0, 0};
  if (!std::ranges::all_of(corners, isAhead)) return {0, width};
  double left = width;
  double right = 0;
  for (const CameraPoint corner : corners) {
    left = std::min(left, projection.columnOf(corner));
    right = std::max(right, projection.columnOf(corner));
  }
  // A column more on either side, so that nothing is left to rounding.
  if (!(left < width && right > 0)) return {0, 0};
  return {static_cast<int>(std::max(0.0, left - 1)),
          static_cast<int>(std::min<double>(width, right + 2))};
}

SpriteFront::Depths SpriteFront::over(double slant) const {
  Depths depths{0, std::numeric_limits<double>::infinity()};
  // Along each edge, how far a point of the ray is from the corner, in squares of metres.
  for (const CameraPoint edge : {lower_.along, up_}) {
    const double atEye = -(lower_.corner.depth * edge.depth + lower_.corner.lateral * edge.lateral);
    const double perMetre = edge.depth + slant * edge.lateral;
    const double size = edge.depth * edge.depth + edge.lateral * edge.lateral;
    depths.keepPositive(atEye, perMetre);
    depths.keepPositive(size - atEye, -perMetre);
  }
  return depths;
}

void SpriteFronts::find(const Scene& scene, const SpriteIndex& index, const Camera& camera,
                        const Projection& projection, SectorId sector, ColumnRange columns) {
  const auto home = index.atHomeIn(sector);
  found_.assign(home.begin(), home.end());
  index.visitRoaming(scene[sector], [&](std::uint32_t sprite) {
    if (scene.level().sprites[sprite].sector != sector &&
        isIn(scene, projection, camera.seconds, sprite, sector))
      found_.push_back(sprite);
  });
  nearToFar_.clear();
  unsorted_.clear();
  for (const std::uint32_t i : found_) {
    const Sprite& sprite = scene.level().sprites[i];
    const auto [view, rect] = shownOf(sprite, projection, camera.seconds);
    const SpriteFront front(sprite, view, rect, projection, camera.width);
    if (!haveCommon(front.columns(), columns)) continue;
    nearToFar_.emplace_back(projection.toCamera(sprite.position.xy()).depth,
                            static_cast<std::uint32_t>(unsorted_.size()));
    unsorted_.push_back(front);
  }
  std::ranges::sort(nearToFar_);
  fronts_.begin(sector);
  for (const auto& [depth, i] : nearToFar_) fronts_.add(unsorted_[i]);
  if (begun_ == byStrip_.size()) byStrip_.emplace_back();
  const std::span<const SpriteFront> found = fronts_.of(sector);
  byStrip_[begun_++].sort(found.size(), [found](std::size_t i) { return found[i].columns(); });
}

bool SpriteFronts::isIn(const Scene& scene, const Projection& projection, double seconds,
                        std::uint32_t sprite, SectorId sector) {
  const Guest guest = guestOf(scene, projection, seconds, sprite);
  const auto sectors = std::span(sectors_).subspan(guest.begin, guest.end - guest.begin);
  return std::ranges::find(sectors, sector) != sectors.end();
}

/// Finds where a sprite is when that is asked for the first time in a frame.
SpriteFronts::Guest SpriteFronts::guestOf(const Scene& scene, const Projection& projection,
                                          double seconds, std::uint32_t index) {
  const auto known = std::ranges::find(guests_, index, &Guest::sprite);
  if (known != guests_.end()) return *known;
  const Sprite& sprite = scene.level().sprites[index];
  const std::size_t begin = sectors_.size();
  std::ranges::copy(finder_.find(scene, sprite, shownOf(sprite, projection, seconds).rect),
                    std::back_inserter(sectors_));
  guests_.push_back({index, begin, sectors_.size()});
  return guests_.back();
}

}  // namespace hearth
