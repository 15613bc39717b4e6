#pragma once

#include "level/mesh.h"
#include "load/model/read_model.h"
#include "math/trig.h"
#include "math/vec.h"

namespace hearth {

/// From the axes of a model, with `y` up, to those of a level, with `z` up; and back.
constexpr Vec3 inOtherAxes(Vec3 p) { return {p.x, p.z, p.y}; }

/// From the axes of a model to those of a level: scales, turns and moves.
class ModelPlacement {
 public:
  /// `scale` is along the level's axes before it is turned, `angle` in degrees.
  ModelPlacement(Vec3 scale, double angle, Vec3 position)
      : scale_(scale), turn_(sinCosDegrees(angle)), position_(position) {}

  /// All but its texture.
  MeshFace operator()(const ModelFace& face) const;

 private:
  Vec3 placed(Vec3 corner) const;

  Vec3 scale_;
  SinCos turn_;
  Vec3 position_;
};

/// False where corners lie in line, or too near to each other for doubles.
bool hasArea(const MeshFace& face);

/// Whether no coordinate is farther from the origin than those of level files may be.
bool isInReach(Vec3 corner);

}  // namespace hearth
