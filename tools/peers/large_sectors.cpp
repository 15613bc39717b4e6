// Frames, bakes and loading of sectors of many walls.

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <utility>

#include "peers/child.h"
#include "peers/evenly.h"
#include "peers/grown_level.h"
#include "peers/peer_inputs.h"
#include "peers/peer_rows.h"

namespace hearth {

namespace {

constexpr double kMillion = 1e6;
constexpr double kBillion = 1e9;
constexpr double kLeastSeconds = 1;

/// Cells of a small and a large maze, each way.
constexpr int kSmallMaze = 30;
constexpr int kLargeMaze = 1000;
/// Cells of a hall of pillars, each way: of 104 and of 10,004 walls.
constexpr int kSmallHall = 13;
constexpr int kLargeHall = 103;
constexpr int kCellsOfLamp = 10;  ///< each way

/// A level that is one grid of cells of a metre, with solid cells around.
template <typename IsSolid>
void writeCells(const std::filesystem::path& file, int cells, IsSolid&& isSolid) {
  std::ofstream out(file);
  out << R"({"light":0.6,"grid":{"legend":{"#":{"wall":"#a08060"},)"
      << R"(".":{"floor":{"texture":"#606060"},"ceiling":{"z":3,"texture":"#a0a0a0"}}},"rows":[)";
  for (int y = 0; y < cells; ++y) {
    out << (y == 0 ? "\n\"" : ",\n\"");
    for (int x = 0; x < cells; ++x) {
      const bool isAround = std::min(x, y) == 0 || std::max(x, y) == cells - 1;
      out << (isAround || isSolid(x, y) ? '#' : '.');
    }
    out << '"';
  }
  out << "]}}\n";
}

/// Around the place (kSmallMaze / 2, kSmallMaze / 2) all mazes are the same, up to a wall.
void writeMaze(const std::filesystem::path& file, int cells) {
  writeCells(file, cells, [](int x, int y) {
    const auto isAtBorder = [](int a) { return a == 0 || a == kSmallMaze - 1; };
    const bool isRing = (isAtBorder(x) && y < kSmallMaze) || (isAtBorder(y) && x < kSmallMaze);
    if (isRing || (x % 2 == 0 && y % 2 == 0)) return true;
    return (x % 2 == 0 || y % 2 == 0) && evenly(x, y, 5) < 0.3;
  });
}

constexpr Vec3 kEyeInMaze{(kSmallMaze + 1) / 2.0, (kSmallMaze + 1) / 2.0, 1.6};

tl::expected<std::shared_ptr<GrownLevel>, std::string> maze(const std::filesystem::path& file,
                                                            int cells) {
  writeMaze(file, cells);
  return GrownLevel::of(file, kEyeInMaze);
}

/// A hall of pillars with a lamp in each square of kCellsOfLamp.
std::filesystem::path writeHall(const PeerInputs& inputs, int cells) {
  std::filesystem::path file = inputs.folder() / fmt::format("hall-{}.json", cells);
  writeCells(file, cells, [](int x, int y) { return x % 2 == 0 && y % 2 == 0; });
  std::ofstream lights(inputs.folder() / fmt::format("hall-{}.lights.json", cells));
  lights << R"({"lights":[)";
  const int lamps = cells / kCellsOfLamp;
  const auto middle = [](int lamp) { return kCellsOfLamp * lamp + (kCellsOfLamp + 1) / 2.0; };
  for (int i = 0; i < lamps * lamps; ++i)
    lights << (i == 0 ? "\n" : ",\n")
           << fmt::format(R"({{"x":{},"y":{},"z":2.5,"radius":0.2,"curve":[[0,250],[8,0]]}})",
                          middle(i % lamps), middle(i / lamps));
  lights << "]}\n";
  return file;
}

/// Millions of rays a second of a bake on one thread, or of several, so that their number evens
/// out.
double millionsOfRaysPerSecond(const PeerLevel& level, const Clock& clock) {
  const Scene scene = level.loaded.scene();
  const double begin = clock();
  double rays = 0;
  double seconds = 0;
  while (seconds < kLeastSeconds) {
    rays += static_cast<double>(bake(scene, scene.level().bake, 1).stats.rays);
    seconds = clock() - begin;
  }
  return rays / kMillion / seconds;
}

}  // namespace

Prepared prepareMazeFrame(PeerInputs& inputs) {
  const std::filesystem::path file = inputs.folder() / "maze.json";
  const auto small = maze(file, kSmallMaze);
  if (!small) return tl::unexpected(small.error());
  const auto large = maze(file, kLargeMaze);
  if (!large) return tl::unexpected(large.error());
  if ((*small)->pictures() != (*large)->pictures())
    return tl::unexpected<std::string>("the two levels do not show the same");
  return Measure([small = *small, large = *large, &inputs] {
    const FrameBench ofSmall = small->measure(inputs.clock());
    const FrameBench ofLarge = large->measure(inputs.clock());
    const double one = ofSmall.milliseconds.median;
    const double other = ofLarge.milliseconds.median;
    return Figures{other / one, one, other};
  });
}

Prepared prepareMazeLoad(PeerInputs& inputs) {
  const std::filesystem::path file = inputs.folder() / "large-maze.json";
  writeMaze(file, kLargeMaze);
  const LoadResult loaded = loadLevel(file);
  if (!loaded.loaded) return tl::unexpected(format(loaded.diagnostics.front()));
  const auto walls = static_cast<double>(loaded.loaded->level.segments.size());
  return Measure([file, walls, &inputs] {
    const double begin = inputs.clock()();
    (void)loadLevel(file);
    return Figures{inputs.clock()() - begin, walls / kMillion};
  });
}

Prepared prepareMazePeak(PeerInputs& inputs) {
  const std::filesystem::path file = absolute(inputs.folder()) / "large-maze.json";
  writeMaze(file, kLargeMaze);
  const std::string eye = fmt::format("{},{},{},0", kEyeInMaze.x, kEyeInMaze.y, kEyeInMaze.z);
  const Child loads{{hearthProgram().string(), "shot", file.string(), "--camera", eye, "--channel",
                     "world", "--size", "8x8", "-o", "loaded.png"},
                    inputs.folder()};
  return Measure([loads]() -> tl::expected<Figures, std::string> {
    return peakOf(loads).map(
        [](std::int64_t bytes) { return Figures{static_cast<double>(bytes) / kBillion}; });
  });
}

Prepared prepareWallRays(PeerInputs& inputs) {
  const auto small = inputs.level(writeHall(inputs, kSmallHall));
  if (!small) return tl::unexpected(small.error());
  return inputs.level(writeHall(inputs, kLargeHall))
      .map([small = *small, &inputs](const PeerLevel* large) -> Measure {
        return [small, large, &inputs] {
          const double ofSmall = millionsOfRaysPerSecond(*small, inputs.clock());
          const double ofLarge = millionsOfRaysPerSecond(*large, inputs.clock());
          return Figures{ofLarge / ofSmall, ofSmall, ofLarge};
        };
      });
}

}  // namespace hearth
