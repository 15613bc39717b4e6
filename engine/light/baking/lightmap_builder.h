#pragma once

#include <optional>

#include "light/baking/left_out.h"
#include "light/baking/texel_sums.h"
#include "light/lightmap.h"
#include "light/used_texels.h"

namespace hearth {

/// Puts a lightmap together. The sums of a tile are rounded as soon as they are complete, so those
/// of a whole surface never take memory at once.
class LightmapBuilder {
 public:
  /// For the means of so many samples a texel. Keeps a reference to `texels`.
  LightmapBuilder(const UsedTexels& texels, int samples) : texels_(texels), samples_(samples) {}

  const UsedTexels& texels() const { return texels_; }
  bool isDark() const { return !map_; }

  /// Adds the used texels of a tile. All tiles in which there is light have the same channels.
  void add(const TexelSums& sums);

  /// Once all are added: empty texels get the light of the nearest used one that is not, and then
  /// those that are not used the light of the nearest in their row. None if all is dark; one
  /// channel if no coloured light has arrived.
  std::optional<Lightmap> finished(const EmptyTexels& empty) &&;

 private:
  const UsedTexels& texels_;
  int samples_;
  std::optional<Lightmap> map_;  ///< none until there is light
};

}  // namespace hearth
