#include "level_files.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "changes.h"
#include "math/check.h"
#include "random_levels/random_level.h"
#include "support/in_tree.h"

namespace hearth::extremes {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Files of this process, gone with it.
class Scratch {
 public:
  Scratch() {
    fs::create_directories(folder_);
    CHECK(writeRandomLevelTextures(folder_ / "textures"));
  }
  ~Scratch() { fs::remove_all(folder_); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  const fs::path& folder() const { return folder_; }

 private:
  fs::path folder_ = fs::temp_directory_path() / fmt::format("hearth-extremes-{}", ::getpid());
};

const fs::path& scratchFolder() {
  static const Scratch scratch;
  return scratch.folder();
}

Json parsed(std::string_view text) {
  std::string json(text);
  std::ranges::replace(json, '\'', '"');
  return Json::parse(json);
}

Json asObject(Json lights) {
  Json object = lights.is_array() ? Json{{"lights", std::move(lights)}} : std::move(lights);
  if (!object["bake"].contains("texel")) object["bake"]["texel"] = 0.125;
  return object;
}

double toGrid(double metres) { return std::ldexp(std::round(std::ldexp(metres, 20)), -20); }

}  // namespace

LevelFiles randomFiles(std::uint64_t seed) {
  const RandomLevel random = makeRandomLevel(seed);
  const LevelFiles files{random.levelJson, asObject(Json::parse(random.lightsJson)).dump(),
                         scratchFolder() / "textures"};
  return withLengths(files, {.point =
                                 [](Vec2 p) {
                                   return Vec2{toGrid(p.x), toGrid(p.y)};
                                 },
                             .height = toGrid,
                             .length = toGrid});
}

LevelFiles withPointSuns(LevelFiles files) {
  Json lights = Json::parse(files.lights);
  if (lights.contains("suns"))
    for (Json& sun : lights["suns"]) sun.erase("size");
  files.lights = lights.dump();
  return files;
}

LevelFiles withoutSky(LevelFiles files) {
  Json lights = Json::parse(files.lights);
  lights.erase("sky");
  files.lights = lights.dump();
  return files;
}

LevelFiles filesOf(std::string_view level, std::string_view lights) {
  return {parsed(level).dump(), asObject(parsed(lights)).dump(), test::inTree("textures")};
}

LoadResult tryLoad(const LevelFiles& files) {
  Json level = Json::parse(files.level);
  level["textures"] = files.textures.string();
  level["lights"] = "level.lights.json";
  std::ofstream(scratchFolder() / "level.json") << level.dump();
  std::ofstream(scratchFolder() / "level.lights.json") << files.lights;
  return loadLevel(scratchFolder() / "level.json");
}

LoadedLevel load(const LevelFiles& files) {
  LoadResult result = tryLoad(files);
  std::string messages;
  for (const Diagnostic& diagnostic : result.diagnostics) messages += format(diagnostic) + '\n';
  CHECK(result.loaded, messages);
  return std::move(*result.loaded);
}

}  // namespace hearth::extremes
