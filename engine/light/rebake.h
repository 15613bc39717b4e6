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

/// The light of each source on each surface, kept from one bake of a level to the next: after an
/// edit, or with its movers elsewhere.
class LightMemory {
 public:
  static constexpr std::size_t kMaxBytes = std::size_t{1} << 30;

  /// Keeps no light beyond so many bytes: that of the oldest bake is let go of first.
  explicit LightMemory(std::size_t maxBytes = kMaxBytes);
  ~LightMemory();
  LightMemory(const LightMemory&) = delete;
  LightMemory& operator=(const LightMemory&) = delete;

  /// Keeps the light of so many bakes, at least one, from now on; of one at first. What several
  /// have in common is kept once.
  void keepBakes(std::size_t count);

  std::size_t bytes() const;

 private:
  friend class Rebake;
  struct Kept;

  std::unique_ptr<Kept> kept_;
};

/// Bakes a level of which earlier versions may have been baked. The result equals that of `bake`
/// to the byte, but only light that a change can affect is computed anew. Kept light counts the
/// samples and rays with which it was found; a bake may take a few others: where changes far away
/// make beams doubtful (BeamDoubts), or a mesh covers samples that the light does not reach. The
/// light of a source on a surface is kept while neither of them changes, nor any sector that rays
/// between them enter. That of all sources on a mesh is kept likewise.
class Rebake {
 public:
  /// Finds what must be baked. The settings have no mistake. Memory, level and geometry must
  /// outlive the rebake; nothing else may use the memory meanwhile, and no flat may move. No byte
  /// depends on `threads`.
  Rebake(LightMemory& memory, const Scene& scene, const BakeSettings& settings, int threads);
  ~Rebake();
  Rebake(const Rebake&) = delete;
  Rebake& operator=(const Rebake&) = delete;

  /// Texels of surfaces and meshes, counted once for each light, that `finish` will bake.
  std::int64_t texelLightsLeft() const;

  /// A quick preview: what is left gets one sample for 4 x 4 texels, balls are points, and no light
  /// bounces but what is known.
  BakedLight draft() const;

  /// None if `stop` was requested; the memory keeps what is done so far. Call it once. `progress`,
  /// if any, is new.
  std::optional<BakedLight> finish(BakeProgress* progress = nullptr,
                                   const std::stop_token& stop = {});

 private:
  class Baker;

  std::unique_ptr<Baker> baker_;
};

}  // namespace hearth
