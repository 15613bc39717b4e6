#include "light/baking/clipped_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "light/baking/left_out.h"
#include "light/baking/patch_light.h"
#include "light/baking/surface_light.h"
#include "light/grid/lit_lattice.h"

namespace hearth {

namespace {

/// Values at the corners of a unit cell, between which they are interpolated.
struct CornerLevels {
  double at00;
  double at10;
  double at01;
  double at11;

  double at(Vec2 p) const {
    const double upper = at00 + p.x * (at10 - at00);
    const double lower = at01 + p.x * (at11 - at01);
    return upper + p.y * (lower - upper);
  }

  double mean() const { return (at00 + at10 + at01 + at11) / 4; }

  double spread() const {
    const auto [least, most] = std::minmax({at00, at10, at01, at11});
    return most - least;
  }
};

/// A cell is cut in four while its corners differ by more levels than this ...
constexpr double kMaxCornerSpread = 8;
/// ... until so many cells lie along the side of a texel: for a point light, where no line divides
/// lit from dark, and for a ball, whose light changes gradually and costs more rays.
constexpr int kMaxCellsPerSide = 8;
constexpr int kMaxCellsPerSideSoft = 4;

/// The corners of a tile's texels, row by row.
template <typename Places>
std::vector<SamplePoint> placedCorners(const Places& places, const TexelRect& tile) {
  std::vector<SamplePoint> corners;
  for (int j = tile.j0; j <= tile.j0 + tile.height; ++j)
    for (int i = tile.i0; i <= tile.i0 + tile.width; ++i)
      corners.push_back(places.place({static_cast<double>(i), static_cast<double>(j)}));
  return corners;
}

/// Those of the i-th texel in the j-th row of a tile, by index.
std::array<std::size_t, 4> cornersOf(const TexelRect& tile, int i, int j) {
  const auto columns = static_cast<std::size_t>(tile.width) + 1;
  const std::size_t first = static_cast<std::size_t>(j) * columns + static_cast<std::size_t>(i);
  return {first, first + 1, first + columns, first + columns + 1};
}

/// Adds the used texels of a tile whose corners are all left out.
void addEmptyBetween(const UsedTexels& texels, const TexelRect& tile, const LeftOut& left,
                     EmptyTexels& empty) {
  if (left.isNone()) return;
  for (int j = 0; j < tile.height; ++j)
    texels.forEachRunIn(tile, tile.j0 + j, [&](int first, int last) {
      for (int i = first; i <= last; ++i)
        if (left.areAll(cornersOf(tile, i - tile.i0, j))) empty.add(i, tile.j0 + j);
    });
}

template <typename Lit>
class ClippedLight {
 public:
  ClippedLight(Lit& surface, const UsedTexels& texels, const TexelRect& tile)
      : surface_(surface),
        texels_(texels),
        rect_(tile),
        blocks_(surface.inBlocks(placedCorners(surface, tile), tile.width + 1)),
        corners_(blocks_.samples()),
        left_(surface, corners_) {}

  const LeftOut& leftOut() const { return left_; }

  void add(std::size_t light, TexelSums& sums) {
    if (surface_.isSoft(light))
      addSoft(light, sums);
    else
      addHard(light, sums);
  }

 private:
  Vec2 corner(double i, double j) const { return {rect_.i0 + i, rect_.j0 + j}; }
  std::size_t index(int i, int j) const { return blocks_.index(i, j); }

  /// Of a point between two corners. Where both lie on one surface, so does what is between them,
  /// except for walls' corners inside a texel.
  SamplePoint placedBetween(Vec2 p) const {
    const auto whole = [](double x) { return static_cast<int>(x); };
    const SamplePoint& a = corners_[index(whole(std::floor(p.x)), whole(std::floor(p.y)))];
    const SamplePoint& b = corners_[index(whole(std::ceil(p.x)), whole(std::ceil(p.y)))];
    if (a.surface != b.surface) return surface_.place(corner(p.x, p.y));
    // p lies on an edge of the lattice: one of its coordinates is whole.
    const double fraction = p.x - std::floor(p.x) + p.y - std::floor(p.y);
    return {a.point + fraction * (b.point - a.point), a.surface,
            a.target + fraction * (b.target - a.target), a.isMoved || b.isMoved};
  }

  /// Whether the surface, or what continues it, ends inside the texel.
  bool hasEdge(int i, int j) const {
    return std::ranges::any_of(cornersOf(rect_, i, j),
                               [&](std::size_t corner) { return corners_[corner].isMoved; });
  }

  /// Of a texel some of whose corners are left out: the mean of those of its samples that are not.
  double levelOfKept(std::size_t light, int i, int j) {
    if (left_.areAll(cornersOf(rect_, i, j))) return 0;
    constexpr int kSide = 4;
    double sum = 0;
    int kept = 0;
    const auto add = [&](const SamplePoint& at) {
      ++kept;
      sum += brightnessAt(light, at, surface_.roughlySeenFraction(light, at));
    };
    for (int row = 0; row < kSide; ++row)
      for (int column = 0; column < kSide; ++column) {
        const SamplePoint at =
            surface_.place(corner(i + (column + 0.5) / kSide, j + (row + 0.5) / kSide));
        if (!surface_.isLeftOut(at)) add(at);
      }
    if (kept == 0)
      for (const std::size_t corner : cornersOf(rect_, i, j))
        if (!left_.is(corner)) add(corners_[corner]);
    return sum / kept;
  }

  /// What a light brings to a point between corners, in levels.
  double levelBetween(std::size_t light, Vec2 p) {
    const auto cells = [](double x) { return static_cast<int>(kMaxCellsPerSide * x); };
    const auto [entry, isNew] = between_.try_emplace({cells(p.x), cells(p.y)});
    if (!isNew) return entry->second;
    const SamplePoint at = surface_.place(corner(p.x, p.y));
    return entry->second = brightnessAt(light, at, surface_.roughlySeenFraction(light, at));
  }

  double brightnessAt(std::size_t light, const SamplePoint& at, double seen) const {
    return seen > 0 ? seen * surface_.unshadowedBrightness(light, at) : 0;
  }

  /// The mean over a square cell from `p` on, cut in four wherever its corners differ by much.
  double refinedLevel(std::size_t light, Vec2 p, double side, double finest,
                      const CornerLevels& corners) {
    if (corners.spread() <= kMaxCornerSpread || side <= finest) return corners.mean();
    const double half = side / 2;
    const auto at = [&](double x, double y) { return levelBetween(light, p + Vec2{x, y}); };
    const double top = at(half, 0);
    const double left = at(0, half);
    const double middle = at(half, half);
    const double right = at(side, half);
    const double bottom = at(half, side);
    const auto part = [&](double x, double y, const CornerLevels& levels) {
      return refinedLevel(light, p + Vec2{x, y}, half, finest, levels);
    };
    return (part(0, 0, {corners.at00, top, left, middle}) +
            part(half, 0, {top, corners.at10, middle, right}) +
            part(0, half, {left, middle, corners.at01, bottom}) +
            part(half, half, {middle, right, bottom, corners.at11})) /
           4;
  }

  static Vec2 texel(int i, int j) { return {static_cast<double>(i), static_cast<double>(j)}; }

  CornerLevels levelsAt(const std::vector<double>& levels, int i, int j) const {
    const double* upper = &levels[index(i, j)];
    const double* lower = upper + rect_.width + 1;
    return {upper[0], upper[1], lower[0], lower[1]};
  }

  /// Of a cell, with nothing where no light arrives.
  template <typename Lattice>
  static CornerLevels litOnly(const CornerLevels& unshadowed, const Lattice& lattice, int i,
                              int j) {
    return {lattice.isLitAt(i, j) ? unshadowed.at00 : 0,
            lattice.isLitAt(i + 1, j) ? unshadowed.at10 : 0,
            lattice.isLitAt(i, j + 1) ? unshadowed.at01 : 0,
            lattice.isLitAt(i + 1, j + 1) ? unshadowed.at11 : 0};
  }

  template <typename LevelOf>
  void addTexels(std::size_t light, TexelSums& sums, LevelOf&& levelOf) {
    between_.clear();
    for (int j = 0; j < rect_.height; ++j) {
      texels_.forEachRunIn(rect_, rect_.j0 + j, [&](int first, int last) {
        for (int i = first - rect_.i0; i <= last - rect_.i0; ++i) {
          const double level =
              left_.isAny(cornersOf(rect_, i, j)) ? levelOfKept(light, i, j) : levelOf(i, j);
          if (level > 0) sums.add(rect_.i0 + i, rect_.j0 + j, surface_.light(light), level);
        }
      });
    }
  }

  void addHard(std::size_t light, TexelSums& sums) {
    const auto isLit = [&](Vec2 p) { return surface_.seenFraction(light, placedBetween(p)) > 0; };
    const std::vector<double>& seen = surface_.seenFractions(light, blocks_);
    const auto isCornerLit = [&](int i, int j) { return seen[index(i, j)] > 0; };
    const LitLattice lattice(rect_.width, rect_.height, isLit, isCornerLit);
    if (lattice.isUniform() && !lattice.isLitAt(0, 0)) return;
    std::vector<double> unshadowed;
    unshadowed.reserve(corners_.size());
    for (const SamplePoint& at : corners_)
      unshadowed.push_back(surface_.unshadowedBrightness(light, at));
    addTexels(light, sums, [&](int i, int j) {
      const int lit = lattice.litCorners(i, j);
      if (lit == 0) return 0.0;
      const CornerLevels levels = levelsAt(unshadowed, i, j);
      if (lit == 4) return levels.mean();
      // Samples beyond an edge are moved to the nearest points of the surface, which need not be
      // neighbours. Then no line divides lit from dark.
      if (hasEdge(i, j))
        return refinedLevel(light, texel(i, j), 1, 1.0 / kMaxCellsPerSide,
                            litOnly(levels, lattice, i, j));
      return lattice.part(i, j).integral([&](Vec2 p) { return levels.at(p); });
    });
  }

  /// What is seen of a ball changes gradually, so the fraction that is seen is interpolated as
  /// well.
  void addSoft(std::size_t light, TexelSums& sums) {
    std::vector<double> levels = surface_.seenFractions(light, blocks_);
    for (std::size_t i = 0; i < levels.size(); ++i)
      levels[i] = brightnessAt(light, corners_[i], levels[i]);
    addTexels(light, sums, [&](int i, int j) {
      return refinedLevel(light, texel(i, j), 1, 1.0 / kMaxCellsPerSideSoft,
                          levelsAt(levels, i, j));
    });
  }

  Lit& surface_;
  const UsedTexels& texels_;
  TexelRect rect_;
  typename Lit::Blocks blocks_;  ///< of corners, one more each way than texels
  const std::vector<SamplePoint>& corners_;
  LeftOut left_;  ///< of the corners
  /// Levels of the light at hand, by finest cells from the first corner on.
  std::map<std::pair<int, int>, double> between_;
};

}  // namespace

template <typename Lit>
void addClippedLight(Lit& surface, const UsedTexels& texels, const TexelRect& tile,
                     std::span<const std::size_t> lights, const SumsOf& sumsOf, EmptyTexels* empty,
                     const std::stop_token& stop) {
  ClippedLight clipped(surface, texels, tile);
  if (empty) addEmptyBetween(texels, tile, clipped.leftOut(), *empty);
  for (const std::size_t light : lights) {
    if (stop.stop_requested()) return;
    clipped.add(light, sumsOf(light));
  }
}

template void addClippedLight(SurfaceLight&, const UsedTexels&, const TexelRect&,
                              std::span<const std::size_t>, const SumsOf&, EmptyTexels*,
                              const std::stop_token&);
template void addClippedLight(PatchLight&, const UsedTexels&, const TexelRect&,
                              std::span<const std::size_t>, const SumsOf&, EmptyTexels*,
                              const std::stop_token&);

template <typename Places>
void addEmptyOfCorners(const Places& places, const UsedTexels& texels, const TexelRect& tile,
                       EmptyTexels& empty) {
  addEmptyBetween(texels, tile, LeftOut(places, placedCorners(places, tile)), empty);
}

template void addEmptyOfCorners(const SurfacePlaces&, const UsedTexels&, const TexelRect&,
                                EmptyTexels&);
template void addEmptyOfCorners(const PatchPlaces&, const UsedTexels&, const TexelRect&,
                                EmptyTexels&);

}  // namespace hearth
