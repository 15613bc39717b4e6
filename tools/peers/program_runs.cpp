// What the program takes from its start to its end: time and memory.

#include <array>
#include <utility>

#include "math/parallel.h"
#include "peers/child.h"
#include "peers/peer_inputs.h"
#include "peers/peer_rows.h"
#include "render/texels_in_view.h"

namespace hearth {

namespace {

constexpr double kMega = 1e6;
constexpr double kSpareMegabytes = 64;  ///< of a bake, beside twice its result

/// This program with a command, in the folder of temporary files.
Child ofProgram(const PeerInputs& inputs, std::vector<std::string> words) {
  words.insert(words.begin(), hearthProgram().string());
  return {std::move(words), inputs.folder()};
}

double allowedMegabytes(const BakedLight& light) {
  return 2 * static_cast<double>(light.stats.bytes) / kMega + kSpareMegabytes;
}

/// A bake's peak without that of a program that only loads the level.
Measure peakOfBake(const PeerInputs& inputs, const std::filesystem::path& file,
                   const BakedLight& light) {
  const Child bakes = ofProgram(inputs, {"bake", file.string(), "--mover-states", "1", "--quiet"});
  const Child loads = ofProgram(
      inputs, {"shot", file.string(), "--channel", "world", "--size", "8x8", "-o", "loaded.png"});
  return [bakes, loads, allowed = allowedMegabytes(light)]() -> tl::expected<Figures, std::string> {
    const auto baking = peakOf(bakes);
    if (!baking) return tl::unexpected(baking.error());
    const auto loading = peakOf(loads);
    if (!loading) return tl::unexpected(loading.error());
    const double taken = static_cast<double>(*baking - *loading) / kMega;
    return Figures{taken / allowed, taken, allowed};
  };
}

Prepared preparePeak(PeerInputs& inputs, const std::filesystem::path& file) {
  return inputs.level(file).map(
      [&](const PeerLevel* level) { return peakOfBake(inputs, absolute(file), level->light); });
}

/// The same here: loading the level, its light in view, and the frame.
std::array<double, 3> secondsOfFirstPicture(const PeerInputs& inputs) {
  const Clock& clock = inputs.clock();
  const double begin = clock();
  const LoadedLevel loaded = *loadLevel(inputs.castleFile()).loaded;
  const Scene scene = loaded.scene();
  const Level& level = loaded.level;
  const double read = clock();
  const Camera camera{level.player->sector, level.player->eye, level.player->angle};
  LitSurfaces surfaces = makeLitSurfaces(scene, level.bake.texel);
  const auto seen = texelsInView(scene, surfaces, camera, {});
  const BakedLight light =
      bakeOnly(seen, std::move(surfaces), scene, level.bake, availableThreads());
  const double lit = clock();
  (void)Renderer(scene, loaded.textures, light).draw(camera, LightMode::Both);
  return {read - begin, lit - read, clock() - lit};
}

}  // namespace

Prepared prepareStart(PeerInputs& inputs) {
  const Child shot =
      ofProgram(inputs, {"shot", absolute(inputs.castleFile()).string(), "--no-cache", "--quality",
                         "normal", "-o", "first.png", "--quiet"});
  return [shot, &inputs] {
    return timesOf(shot).map([&](const ChildTimes& times) {
      Figures figures{times.seconds};
      double rest = times.seconds;
      for (const double seconds : secondsOfFirstPicture(inputs)) {
        figures.push_back(seconds);
        rest -= seconds;
      }
      figures.push_back(rest);
      for (double& figure : figures) figure *= 1e3;
      return figures;
    });
  };
}

Prepared prepareCastlePeak(PeerInputs& inputs) { return preparePeak(inputs, inputs.castleFile()); }

Prepared prepareLargestPeak(PeerInputs& inputs) {
  return inputs.freedoomFile(kLargestMap).and_then([&](const std::filesystem::path& file) {
    return preparePeak(inputs, file);
  });
}

}  // namespace hearth
