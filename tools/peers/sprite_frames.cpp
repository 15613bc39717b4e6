// Frames with many sprites, against the same level without them.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <numbers>
#include <string_view>

#include "peers/evenly.h"
#include "peers/frame_phases.h"
#include "peers/made_images.h"
#include "peers/peer_inputs.h"
#include "peers/peer_rows.h"

namespace hearth {

namespace {

constexpr int kSpriteFrames = 10;
constexpr ImageSize kHallPicture{1920, 1080};

// A hall of squares, each a sector with a floor of its own, from x = 0 on.
constexpr int kSquares = 6;  ///< each way
constexpr int kSquareSide = 8;
constexpr int kHallSide = kSquares * kSquareSide;
constexpr double kHallHeight = 12;
constexpr double kHighestFloor = 0.4;
constexpr Vec3 kHallEye{1, 0.5, 6};

// One sprite is in each cell of a grid in the picture.
constexpr int kCellColumns = 40;
constexpr int kCellRows = 25;
constexpr int kSprites = kCellColumns * kCellRows;
constexpr double kSmallestPx = 21;  ///< sides of sprites
constexpr double kLargestPx = 42;
constexpr double kNearestSprite = 3;  ///< metres of depth
/// Pixels of all their images, holes included, over those of the picture; how far it may be off.
constexpr double kCovered = 0.5;
constexpr double kCoveredSlack = 0.02;

constexpr std::string_view kLamps = R"([
{"x":8,"y":-12,"z":9,"intensity":300,"falloff":0.03,"color":"#ffd8a0"},
{"x":30,"y":14,"z":8,"intensity":400,"falloff":0.03,"color":"#a0c8ff"},
{"x":40,"y":-10,"z":10,"intensity":300,"falloff":0.02,"color":"#ffffff"}])";

std::string squareName(int x, int y) { return fmt::format("{},{}", x, y); }

std::string squareWall(int x, int y) {
  const bool isInside = x >= 0 && x < kSquares && y >= 0 && y < kSquares;
  if (!isInside) return R"({"texture":"plaster 4,4"})";
  return fmt::format(R"({{"next":"{}","texture":"plaster 4,4"}})", squareName(x, y));
}

std::string squareText(int x, int y) {
  const int left = x * kSquareSide;
  const int top = y * kSquareSide - kHallSide / 2;
  const int right = left + kSquareSide;
  const int bottom = top + kSquareSide;
  return fmt::format(
      R"("{}":{{"floor":{{"z":{:.3f},"texture":"plaster 3,3"}},"ceiling":{{"z":{},"texture":"paint 6,6"}},)"
      R"("loops":{{"border":{{"v":[{},{},{},{},{},{},{},{}],"walls":[{},{},{},{}]}}}}}})",
      squareName(x, y), kHighestFloor * evenly(x, y, 0), kHallHeight, left, top, right, top, right,
      bottom, left, bottom, squareWall(x, y - 1), squareWall(x + 1, y), squareWall(x, y + 1),
      squareWall(x - 1, y));
}

Camera hallCamera() {
  Camera camera;
  camera.sector = SectorId(kSquares / 2);
  camera.eye = kHallEye;
  camera.width = kHallPicture.width;
  camera.height = kHallPicture.height;
  return camera;
}

/// A sprite in a cell of the picture, at any depth at which all of it is in the air of the hall.
std::string spriteText(int cellColumn, int cellRow) {
  const auto between = [&](double low, double high, int which) {
    return low + (high - low) * evenly(cellColumn, cellRow, which);
  };
  const Projection projection(hallCamera(), kHallEye);
  const double column = (cellColumn + between(0.2, 0.8, 0)) * kHallPicture.width / kCellColumns;
  const double row = (cellRow + between(0.2, 0.8, 1)) * kHallPicture.height / kCellRows;
  const double slant = projection.slantOf(column);
  const double slope = projection.raySlopeAt(row);
  const double size = between(kSmallestPx, kLargestPx, 2) / projection.distancePx();

  const double room = kHallHeight / 2 - kHighestFloor;  // above the eye and below
  const double side = kHallSide / 2.0 - 1;              // to its left and right
  const double depth = between(
      kNearestSprite,
      std::min({room / (std::abs(slope) + size / 2), side / std::abs(slant), kHallSide - 2.0}), 3);
  // Every fourth one is fixed, and none seen edge-on.
  const double towardsEye = 180 + std::atan(slant) * 180 / std::numbers::pi;
  const std::string facing =
      (cellColumn + cellRow) % 4 == 0
          ? fmt::format(R"(,"facing":"angle","angle":{:.1f})", towardsEye + between(-60, 60, 4))
          : "";
  return fmt::format(
      R"({{"sprite":"disc","x":{:.4f},"y":{:.4f},"z":{:.4f},"size":[{:.4f},{:.4f}]{}}})",
      kHallEye.x + depth, kHallEye.y + depth * slant, kHallEye.z + depth * (slope - size / 2),
      depth * size, depth * size, facing);
}

std::string hallText(bool withSprites) {
  std::string text = R"({"light":0.2,"textures":".","lights":"lamps.json","sectors":{)";
  for (int i = 0; i < kSquares * kSquares; ++i)
    text += (i == 0 ? "\n" : ",\n") + squareText(i / kSquares, i % kSquares);
  text += "},\"things\":[";
  for (int i = 0; withSprites && i < kSprites; ++i)
    text += (i == 0 ? "\n" : ",\n") + spriteText(i % kCellColumns, i / kCellColumns);
  return text + "]}\n";
}

tl::expected<void, std::string> writeHalls(const std::filesystem::path& folder) {
  return writeImages(folder).map([&] {
    std::ofstream(folder / "lamps.json") << kLamps;
    std::ofstream(folder / "with.json") << hallText(true);
    std::ofstream(folder / "without.json") << hallText(false);
  });
}

/// Frames of a hall with sprites, each drawn after the same without them.
class SpriteHall {
 public:
  SpriteHall(const PeerLevel& with, const PeerLevel& without) : with_(with), without_(without) {}

  /// Pixels of the images in view, holes included, over those of the picture.
  double covered() const {
    FrameScratch scratch;
    with_.renderer.findSpans(hallCamera(), scratch);
    double pixels = 0;
    scratch.forEachSpan([&](const Span& span) {
      if (span.view) pixels += span.rowEnd - span.rowBegin;
    });
    return pixels / kHallPicture.width / kHallPicture.height;
  }

  Figures measure(const Clock& clock) {
    draw(clock);  // caches that others have used are warm again
    ofWith_.clear();
    ofWithout_.clear();
    for (int i = 0; i < kSpriteFrames; ++i) draw(clock);
    return {ofWith_.frame() / ofWithout_.frame(), ofWith_.frame(), ofWithout_.frame(),
            ofWith_.find() - ofWithout_.find(), ofWith_.color() - ofWithout_.color()};
  }

 private:
  void draw(const Clock& clock) {
    canvas_.draw(without_.renderer, hallCamera(), nullptr, ofWithout_, clock);
    canvas_.draw(with_.renderer, hallCamera(), nullptr, ofWith_, clock);
  }

  const PeerLevel& with_;
  const PeerLevel& without_;
  Canvas canvas_;
  PhaseTimes ofWith_;
  PhaseTimes ofWithout_;
};

}  // namespace

Prepared prepareSpriteFrame(PeerInputs& inputs) {
  const std::filesystem::path folder = inputs.folder() / "sprites";
  if (const auto written = writeHalls(folder); !written) return tl::unexpected(written.error());
  const auto with = inputs.level(folder / "with.json");
  if (!with) return tl::unexpected(with.error());
  const auto without = inputs.level(folder / "without.json");
  if (!without) return tl::unexpected(without.error());
  const auto hall = std::make_shared<SpriteHall>(**with, **without);
  if (const double covered = hall->covered(); std::abs(covered - kCovered) > kCoveredSlack)
    return tl::unexpected(fmt::format("the sprites cover {:.1f} % of the picture", 100 * covered));
  return [hall, &inputs] { return hall->measure(inputs.clock()); };
}

}  // namespace hearth
