#include "light/baking/atlas_light.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace hearth {

namespace {

int channelOf(const Lightmap& light, int channel) { return light.channels == 1 ? 0 : channel; }

class Atlas {
 public:
  Atlas(const TexelRect& rect, int channels) : map_(Lightmap::dark(rect, channels)) {}

  void addPatch(const LitMesh::Patch& patch, const Lightmap& light) {
    const TexelRect& rect = light.rect;
    for (int j = 0; j < rect.height; ++j)
      for (int i = 0; i < rect.width; ++i)
        for (int channel = 0; channel < map_.channels; ++channel)
          texel(patch.i + i, patch.j + j, channel) =
              light.at(rect.i0 + i, rect.j0 + j, channelOf(light, channel));
  }

  void addFaces(std::span<const LitMesh::SmallFace> faces, const Lightmap& light) {
    for (std::size_t row = 0; row < faces.size(); ++row)
      for (int channel = 0; channel < map_.channels; ++channel) {
        const auto at = [&](int corner) {
          return light.at(corner, static_cast<int>(row), channelOf(light, channel));
        };
        const auto& [face, i, j] = faces[row];
        texel(i, j, channel) = at(0);
        texel(i + 1, j, channel) = at(1);
        texel(i, j + 1, channel) = at(2);
        texel(i + 1, j + 1, channel) =
            static_cast<std::uint8_t>(std::clamp(at(1) + at(2) - at(0), 0, 255));
      }
  }

  Lightmap taken() { return compacted(std::move(map_)); }

 private:
  std::uint8_t& texel(int i, int j, int channel) { return map_.texel(i, j)[channel]; }

  Lightmap map_;
};

}  // namespace

std::optional<Lightmap> atlasOf(const LitMesh& mesh, std::span<const PartOfAtlas> parts) {
  int channels = 0;
  for (const PartOfAtlas& part : parts)
    if (part.light) channels = std::max(channels, part.light->channels);
  if (channels == 0) return std::nullopt;
  Atlas atlas(mesh.texels, channels);
  for (const auto& [patch, faces, light] : parts) {
    if (!light) continue;
    if (patch)
      atlas.addPatch(*patch, *light);
    else
      atlas.addFaces(faces, *light);
  }
  return atlas.taken();
}

}  // namespace hearth
