#pragma once

#include <functional>

#include "level_files.h"
#include "light/bakery.h"
#include "render/renderer.h"

namespace hearth::extremes {

/// A level with its light, ready to be drawn from its shots.
class LitLevel {
 public:
  explicit LitLevel(const LevelFiles& files, int threads = 1)
      : loaded_(load(files)), light_(bake(loaded_.scene(), loaded_.level.bake, threads)) {}

  const Level& level() const { return loaded_.level; }
  Scene scene() const { return loaded_.scene(); }
  const LoadedLevel& loaded() const { return loaded_; }
  const BakedLight& light() const { return light_; }
  Renderer renderer() const { return {loaded_.scene(), loaded_.textures, light_}; }

  Image look(std::size_t shot, LightMode mode) const {
    return renderer().draw(cameraOf(level().shots[shot]), mode);
  }

 private:
  LoadedLevel loaded_;
  BakedLight light_;
};

/// Fails the running test where two levels do not look alike from all their shots, to the byte: in
/// their textures, in their light, and in both.
void expectSamePictures(const LitLevel& expected, const LitLevel& actual);

/// ... or do not have the same bytes of light, surface by surface, in sectors of the same place in
/// the level, or of the places that `actualSector` says.
void expectSameLight(const LitLevel& expected, const LitLevel& actual,
                     const std::function<SectorId(SectorId)>& actualSector);

}  // namespace hearth::extremes
