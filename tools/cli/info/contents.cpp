#include "cli/info/contents.h"

#include <string_view>
#include <vector>

#include "render/texture.h"

namespace hearth {

std::vector<MoverContents> moverContents(const LoadedLevel& authored,
                                         std::span<const double> shares) {
  std::vector<MoverContents> contents;
  for (const Mover& mover : authored.level.movers) {
    const Sector& first = authored.level[mover.sectors.front()];
    const double from = mover.part == FlatPart::Floor ? first.floor.z : first.ceiling.z;
    const std::size_t index = contents.size();
    contents.push_back({mover, from, shares[index], authored.level.hasSwitch(index)});
  }
  return contents;
}

Contents contentsOf(const LoadedLevel& loaded, const LevelSource& source, const Bake& bake) {
  const Level& level = loaded.level;
  Contents contents;
  contents.settings = bake.settings;
  contents.light = lightReport(loaded.scene(), bake.light);
  for (const Sector& sector : level.sectors) contents.loops += std::ssize(sector.loops);
  for (const Image& image : loaded.textures)
    contents.textureBytes +=
        static_cast<std::int64_t>(sizeof(Texture::Texel)) * image.width() * image.height();

  countGeometry(loaded.scene(), contents.features);
  std::vector<std::string_view> texts;
  for (const Document& document : source.documents) texts.push_back(document.text);
  countSpellings(texts, contents.features);
  return contents;
}

}  // namespace hearth
