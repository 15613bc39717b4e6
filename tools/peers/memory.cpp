// Bytes of baked light, on Freedoom.

#include "light/saved_bake.h"
#include "peers/peer_inputs.h"
#include "peers/peer_rows.h"

namespace hearth {

namespace {

/// Texels whose centres lie on a surface that light reaches, once for each channel of its light.
std::int64_t channelsOfTexels(const BakedLight& light) {
  std::int64_t count = 0;
  for (std::size_t i = 0; i < light.surfaces.size(); ++i) {
    if (!light.surfaces[i] || !light.lightmaps[i]) continue;
    const LitSurface& surface = *light.surfaces[i];
    const TexelRect& rect = surface.texels;
    std::int64_t texels = 0;
    for (int t = rect.j0; t < rect.j0 + rect.height; ++t)
      for (int s = rect.i0; s < rect.i0 + rect.width; ++s)
        if (surface.outline.contains({s + 0.5, t + 0.5})) ++texels;
    count += light.lightmaps[i]->channels * texels;
  }
  return count;
}

/// The same each time: bytes over channels of texels; millions of both.
Measure perChannel(std::size_t bytes, const BakedLight& light) {
  const auto taken = static_cast<double>(bytes);
  const auto channels = static_cast<double>(channelsOfTexels(light));
  return [=] { return Figures{taken / channels, 1e-6 * taken, 1e-6 * channels}; };
}

Prepared prepareSavedLight(PeerInputs& inputs, const char* map) {
  return inputs.freedoomLevel(map).map([](const PeerLevel* level) {
    const double texel = level->loaded.level.bake.texel;
    const std::string bytes = encodeBake(level->loaded.scene(), level->light, texel, "");
    return perChannel(bytes.size(), level->light);
  });
}

/// Texels with what is kept beside them of each lightmap.
std::size_t bytesOf(const BakedLight& light) {
  std::size_t bytes = 0;
  for (const auto& lightmap : light.lightmaps)
    if (lightmap) bytes += sizeof *lightmap + lightmap->bytes();
  return bytes;
}

Prepared prepareKeptLight(PeerInputs& inputs, const char* map) {
  return inputs.freedoomLevel(map).map(
      [](const PeerLevel* level) { return perChannel(bytesOf(level->light), level->light); });
}

}  // namespace

Prepared prepareMap01Saved(PeerInputs& inputs) { return prepareSavedLight(inputs, "MAP01"); }
Prepared prepareMap15Saved(PeerInputs& inputs) { return prepareSavedLight(inputs, "MAP15"); }
Prepared prepareLargestSaved(PeerInputs& inputs) { return prepareSavedLight(inputs, kLargestMap); }
Prepared prepareMap01Kept(PeerInputs& inputs) { return prepareKeptLight(inputs, "MAP01"); }
Prepared prepareMap15Kept(PeerInputs& inputs) { return prepareKeptLight(inputs, "MAP15"); }
Prepared prepareLargestKept(PeerInputs& inputs) { return prepareKeptLight(inputs, kLargestMap); }

}  // namespace hearth
