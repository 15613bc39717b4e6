#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>

#include "level/scene.h"
#include "light/bake_progress.h"
#include "light/bakery.h"

namespace hearth {

/// What each light brings to each surface, from one bake of a level that is being edited to the
/// next.
class LightMemory {
 public:
  static constexpr std::size_t kMostBytes = std::size_t{1} << 30;

  /// Of light past so many bytes nothing is kept.
  explicit LightMemory(std::size_t mostBytes = kMostBytes);
  ~LightMemory();
  LightMemory(const LightMemory&) = delete;
  LightMemory& operator=(const LightMemory&) = delete;

  std::size_t bytes() const;

 private:
  friend class Rebake;
  struct Kept;

  std::unique_ptr<Kept> kept_;
};

/// The bake of a level of which an earlier version may have been baked: to the byte what `bake`
/// gives, counters and all, but only what a change can have touched is asked for anew. What a light
/// brings to a surface stays as long as both do, and all sectors that the light's rays to it come
/// into.
class Rebake {
 public:
  /// Looks what is to be done; with settings without a mistake. Memory, level and geometry must
  /// outlive the rebake; meanwhile the memory is its alone, and no flat moves. No byte depends on
  /// `threads`.
  Rebake(LightMemory& memory, const Scene& scene, const BakeSettings& settings, int threads);
  ~Rebake();
  Rebake(const Rebake&) = delete;
  Rebake& operator=(const Rebake&) = delete;

  /// Texels of surfaces, counted once for each light, that `finish` will ask for.
  std::int64_t texelLightsLeft() const;

  /// The light in haste: of what is left to do one sample to 4 x 4 texels, and balls as points.
  BakedLight draft() const;

  /// None where it was asked to stop; what was done until then is kept. Called once. `progress`, if
  /// any, is new.
  std::optional<BakedLight> finish(BakeProgress* progress = nullptr,
                                   const std::stop_token& stop = {});

 private:
  class Baker;

  std::unique_ptr<Baker> baker_;
};

}  // namespace hearth
