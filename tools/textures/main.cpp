#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <vector>

#include "image/image_file.h"
#include "textures/sprites.h"
#include "textures/textures.h"

int main(int argumentCount, char** arguments) {
  if (argumentCount != 2) {
    std::fputs(
        "usage: hearth-textures OUTDIR\nWrites the project's textures and sprites as PNG files.\n",
        stderr);
    return 2;
  }
  const std::filesystem::path folder = arguments[1];
  std::vector<hearth::textures::Texture> all = hearth::textures::makeAll();
  std::ranges::move(hearth::textures::makeSprites(), std::back_inserter(all));
  for (const hearth::textures::Texture& texture : all) {
    if (const auto written = hearth::writePng(folder / (texture.name + ".png"), texture.image);
        !written) {
      std::fprintf(stderr, "error: %s\n", written.error().c_str());
      return 2;
    }
  }
  return 0;
}
