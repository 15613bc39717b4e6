// Every frame and every texel of the levels in the tree, to the byte, as hashes. Changes that are
// not meant to be seen leave them alone. After one that is meant to be seen, look at the pictures
// (`hearth check --report`), and keep the new hashes with
//   HEARTH_UPDATE_GOLDENS=1 build/release/tests/levels/test_levels_bytes

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "load/load.h"
#include "math/hash.h"
#include "render/renderer.h"
#include "support/in_tree.h"

namespace hearth {
namespace {

const std::filesystem::path kTree = test::inTree("");
const std::filesystem::path kKept = kTree / "tests/levels/bytes.txt";

/// Of the surfaces that show.
std::uint64_t hashOf(const Scene& scene, const BakedLight& light) {
  Hash hash;
  for (const SurfaceId id : scene.shownSurfaces()) {
    const std::optional<Lightmap>& map = light.lightmaps[id.index()];
    hash.addWhole(map.has_value());
    if (!map) continue;
    for (const int number :
         {map->rect.i0, map->rect.j0, map->rect.width, map->rect.height, map->channels})
      hash.addWhole(static_cast<std::uint64_t>(number));
    for (int j = map->rect.j0; j < map->rect.j0 + map->rect.height; ++j)
      for (int i = map->rect.i0; i < map->rect.i0 + map->rect.width; ++i)
        for (int channel = 0; channel < map->channels; ++channel)
          hash.addWhole(map->at(i, j, channel));
  }
  return hash.value();
}

std::uint64_t hashOf(const Image& picture) {
  Hash hash;
  hash.addWhole(static_cast<std::uint64_t>(picture.width()));
  for (const Rgb pixel : picture.pixels())
    hash.addWhole(static_cast<std::uint64_t>(pixel.r << 16 | pixel.g << 8 | pixel.b));
  return hash.value();
}

struct NamedBake {
  std::string name;
  BakeSettings settings;
};

std::vector<NamedBake> bakesOf(const BakeSettings& own) {
  BakeSettings points = own, cosine = own;
  points.softSamples = 0;
  cosine.lambert = true;
  cosine.texel = 0.5;
  cosine.samples = 4;
  return {
      {"own settings", own}, {"points", points}, {"cosine, 4 samples, texels of 0.5 m", cosine}};
}

struct NamedDrawing {
  std::string name;
  DrawSettings settings;
  LightMode mode = LightMode::Both;
};

std::vector<NamedDrawing> drawings() {
  std::vector<NamedDrawing> list = {
      {"both", {}}, {"none", {}, LightMode::None}, {"only", {}, LightMode::Only}};
  const auto add = [&](const char* name, auto member, auto value) {
    DrawSettings settings;
    settings.*member = value;
    list.push_back({name, settings});
  };
  add("bilinear textures", &DrawSettings::textureFilter, TextureFilter::Bilinear);
  add("mipmapped textures", &DrawSettings::textureFilter, TextureFilter::Mipmapped);
  add("nearest light", &DrawSettings::lightFilter, LightFilter::Nearest);
  add("squares of 2 pixels", &DrawSettings::pixelSize, 2);
  return list;
}

std::vector<std::filesystem::path> levelFiles() {
  std::vector<std::filesystem::path> files;
  for (const char* folder : {"levels", "tests/levels"})
    for (const auto& entry : std::filesystem::directory_iterator(kTree / folder)) {
      const std::string name = entry.path().filename();
      if (name.ends_with(".json") && name.find('.') == name.rfind('.'))
        files.push_back(entry.path());
    }
  std::ranges::sort(files);
  return files;
}

void addLevel(const std::filesystem::path& file, std::vector<std::string>& lines) {
  const LoadResult result = loadLevel(file);
  ASSERT_TRUE(result.loaded) << file;
  const LoadedLevel& loaded = *result.loaded;
  const std::string name = std::filesystem::relative(file, kTree).string();
  const auto add = [&](const std::string& what, std::uint64_t hash) {
    lines.push_back(fmt::format("{:016x} {}: {}", hash, name, what));
  };
  for (const NamedBake& bakeOf : bakesOf(loaded.level.bake))
    add("texels, " + bakeOf.name, hashOf(loaded.scene(), bake(loaded.scene(), bakeOf.settings, 2)));
  const BakedLight light = bake(loaded.scene(), loaded.level.bake, 2);
  for (const NamedDrawing& drawing : drawings()) {
    const Renderer renderer(loaded.scene(), loaded.textures, light, drawing.settings);
    for (const Shot& shot : loaded.level.shots)
      add(fmt::format("shot {}, {}", shot.name, drawing.name),
          hashOf(renderer.draw(cameraOf(shot), drawing.mode)));
  }
}

std::vector<std::string> keptLines() {
  std::vector<std::string> lines;
  std::ifstream file(kKept);
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

TEST(Bytes, FramesAndTexelsOfEveryLevelAreAsKept) {
  std::vector<std::string> lines;
  for (const std::filesystem::path& file : levelFiles())
    ASSERT_NO_FATAL_FAILURE(addLevel(file, lines));
  if (std::getenv("HEARTH_UPDATE_GOLDENS")) {
    std::ofstream file(kKept);
    for (const std::string& line : lines) file << line << '\n';
    return;
  }
  const std::vector<std::string> kept = keptLines();
  ASSERT_EQ(kept.size(), lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) EXPECT_EQ(kept[i], lines[i]);
}

}  // namespace
}  // namespace hearth
