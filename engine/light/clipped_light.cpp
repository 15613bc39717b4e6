#include "light/clipped_light.h"

#include <cmath>
#include <unordered_map>
#include <vector>

#include "light/lit_lattice.h"

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
};

/// Samples along a texel's side, where its lit part is no polygon.
constexpr int kSide = 4;

class ClippedLight {
 public:
  ClippedLight(SurfaceLight& surface, TexelSums& sums)
      : surface_(surface), sums_(sums), rect_(surface.texels()) {
    for (int j = 0; j <= rect_.height; ++j)
      for (int i = 0; i <= rect_.width; ++i) corners_.push_back(surface.place(corner(i, j)));
  }

  void add(std::size_t light) {
    if (surface_.light(light).radius > 0)
      addSoft(light);
    else
      addHard(light);
  }

 private:
  Vec2 corner(double i, double j) const { return {rect_.i0 + i, rect_.j0 + j}; }
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(rect_.width + 1) +
           static_cast<std::size_t>(i);
  }

  /// Of a point between two corners. Where both lie on one surface, so does what is between them,
  /// but for walls' corners inside a texel.
  SamplePoint placedBetween(Vec2 p) const {
    const auto whole = [](double x) { return static_cast<int>(x); };
    const SamplePoint& a = corners_[index(whole(std::floor(p.x)), whole(std::floor(p.y)))];
    const SamplePoint& b = corners_[index(whole(std::ceil(p.x)), whole(std::ceil(p.y)))];
    if (a.surface != b.surface) return surface_.place(corner(p.x, p.y));
    const double share = p.x - std::floor(p.x) + p.y - std::floor(p.y);
    return {a.point + share * (b.point - a.point), a.surface,
            a.target + share * (b.target - a.target), a.isMoved || b.isMoved};
  }

  /// Whether the surface, or what continues it, ends inside the texel.
  bool hasEdge(int i, int j) const {
    return corners_[index(i, j)].isMoved || corners_[index(i + 1, j)].isMoved ||
           corners_[index(i, j + 1)].isMoved || corners_[index(i + 1, j + 1)].isMoved;
  }

  /// Beyond an edge the nearest points of a surface can lie apart, and no line divides lit from
  /// dark.
  double sampledLevel(std::size_t light, int i, int j) {
    double sum = 0;
    for (const SamplePoint& at : samplesOf(i, j)) {
      const double seen = surface_.seenShare(light, at);
      if (seen > 0) sum += seen * surface_.fullLevel(light, at);
    }
    return sum / (kSide * kSide);
  }

  const std::vector<SamplePoint>& samplesOf(int i, int j) {
    std::vector<SamplePoint>& samples = samples_[index(i, j)];
    if (samples.empty())
      for (int b = 0; b < kSide; ++b)
        for (int a = 0; a < kSide; ++a)
          samples.push_back(surface_.place(corner(i + (a + 0.5) / kSide, j + (b + 0.5) / kSide)));
    return samples;
  }

  CornerLevels levelsAt(const std::vector<double>& levels, int i, int j) const {
    const double* upper = &levels[index(i, j)];
    const double* lower = upper + rect_.width + 1;
    return {upper[0], upper[1], lower[0], lower[1]};
  }

  template <typename LevelOf>
  void addTexels(std::size_t light, LevelOf&& levelOf) {
    for (int j = 0; j < rect_.height; ++j)
      for (int i = 0; i < rect_.width; ++i)
        if (const double level = levelOf(i, j); level > 0)
          sums_.add(rect_.i0 + i, rect_.j0 + j, surface_.light(light), level);
  }

  void addHard(std::size_t light) {
    const auto isLit = [&](Vec2 p) { return surface_.seenShare(light, placedBetween(p)) > 0; };
    const auto isCornerLit = [&](int i, int j) {
      return surface_.seenShare(light, corners_[index(i, j)]) > 0;
    };
    const LitLattice lattice(rect_.width, rect_.height, isLit, isCornerLit);
    if (lattice.isUniform() && !lattice.isLitAt(0, 0)) return;
    std::vector<double> levels;
    levels.reserve(corners_.size());
    for (const SamplePoint& at : corners_) levels.push_back(surface_.fullLevel(light, at));
    addTexels(light, [&](int i, int j) {
      const int lit = lattice.litCorners(i, j);
      if (lit == 0) return 0.0;
      if (lit == 4) return levelsAt(levels, i, j).mean();
      return hasEdge(i, j) ? sampledLevel(light, i, j)
                           : lattice.part(i, j).integral([&, corners = levelsAt(levels, i, j)](
                                                             Vec2 p) { return corners.at(p); });
    });
  }

  /// What is seen of a ball changes gradually, so that its share too is interpolated.
  void addSoft(std::size_t light) {
    std::vector<double> levels;
    levels.reserve(corners_.size());
    for (const SamplePoint& at : corners_) {
      const double seen = surface_.seenShare(light, at);
      levels.push_back(seen > 0 ? seen * surface_.fullLevel(light, at) : 0);
    }
    addTexels(light, [&](int i, int j) { return levelsAt(levels, i, j).mean(); });
  }

  SurfaceLight& surface_;
  TexelSums& sums_;
  TexelRect rect_;
  std::vector<SamplePoint> corners_;  ///< row by row, one more each way than texels
  std::unordered_map<std::size_t, std::vector<SamplePoint>> samples_;  ///< of texels that need them
};

}  // namespace

void addClippedLight(SurfaceLight& surface, TexelSums& sums, BakeProgress& progress) {
  SurfaceProgress lights(progress, surface.texels().count(), std::ssize(surface.facing()));
  ClippedLight clipped(surface, sums);
  for (const std::size_t light : surface.facing()) {
    clipped.add(light);
    lights.step();
  }
}

}  // namespace hearth
