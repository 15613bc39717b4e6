#include "things_in_halls.h"

#include <fmt/format.h>

#include <algorithm>

namespace hearth::test {

namespace {

std::string wallsWithPortal(int portal, std::string_view next, std::string_view more) {
  std::string all;
  for (int i = 0; i < 4; ++i) {
    if (i > 0) all += ',';
    if (i == portal)
      all += fmt::format("{{'next':'{}'{}}}", next, more);
    else
      all += "{'texture':'#808080'}";
  }
  return "[" + all + "]";
}

}  // namespace

LoadedLevel levelWith(std::string_view things, std::string_view sectors,
                      const std::vector<NamedText>& others) {
  return levelFrom(fmt::format("{{'light':1,'things':[{}],'sectors':{{{}}}}}", things, sectors),
                   "[]", others);
}

std::string hall() { return sectorText("hall", "0,-4, 8,-4, 8,4, 0,4", 0, 4); }

std::string halves(std::string_view west, std::string_view east) {
  return sectorText("west", "0,-4, 4,-4, 4,4, 0,4", 0, 4, wallsWithPortal(1, "east", west)) + "," +
         sectorText("east", "4,-4, 8,-4, 8,4, 4,4", 0, 4, wallsWithPortal(3, "west", east));
}

Camera lookingEast(double x) { return {SectorId(0), {x, 0.001, 2}, 0, 0, 90, kSize, kSize, 0}; }

Image drawn(const LoadedLevel& loaded, const Camera& camera, LightMode mode,
            DrawSettings settings) {
  const BakedLight light = bake(loaded.scene(), loaded.level.bake, 1);
  return Renderer(loaded.scene(), loaded.textures, light, settings).draw(camera, mode);
}

int count(const Image& picture, Rgb color) {
  return static_cast<int>(std::ranges::count(picture.pixels(), color));
}

}  // namespace hearth::test
