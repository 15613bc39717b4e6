// usage: example LEVEL.json OUT.png: bakes a level and draws the first of its shots.

#include <iostream>
#include <string>

#include "image/image_file.h"
#include "light/bakery.h"
#include "load/load.h"
#include "math/parallel.h"
#include "render/renderer.h"

int fail(const std::string& message) {
  std::cerr << "example: " << message << '\n';
  return 2;
}

int main(int argc, char** argv) {
  if (argc != 3) return fail("give LEVEL.json and OUT.png");
  const hearth::LoadResult file = hearth::loadLevel(argv[1]);
  for (const auto& diagnostic : file.diagnostics) std::cerr << format(diagnostic) << '\n';
  if (!file.loaded) return 2;

  const hearth::Level& level = file.loaded->level;
  const hearth::Scene scene = file.loaded->scene();
  if (level.shots.empty()) return fail("the level has no shots");
  if (const auto mistake = mistakeInSettings(scene, level.bake)) return fail(*mistake);
  const hearth::BakedLight light = bake(scene, level.bake, hearth::availableThreads());

  const hearth::Renderer renderer(scene, file.loaded->textures, light);
  const auto picture = renderer.draw(cameraOf(level.shots.front()), hearth::LightMode::Both);
  const auto written = hearth::writePng(argv[2], picture);
  return written ? 0 : fail(written.error());
}
