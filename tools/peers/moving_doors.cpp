// Frames in which many flats move.

#include <fmt/format.h>

#include <fstream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "load/source.h"
#include "peers/peer_inputs.h"
#include "peers/peer_rows.h"
#include "viewer/walk/moved_view.h"

namespace hearth {

namespace {

constexpr int kDoors = 20;  ///< half of them on each side of the hall
constexpr int kFrames = 24;

/// A hall of 44 m, doors of 2 m along both of its long walls, and a cell with a lamp behind each.
class HallOfDoors {
 public:
  std::string level() {
    std::string south;
    std::string north;
    for (int i = 0; i < kDoors / 2; ++i) {
      south += corner(3.0 + 4 * i, 0, doorName(i, 0)) + corner(5.0 + 4 * i, 0, "");
      north += corner(41.0 - 4 * i, 10, doorName(9 - i, 1)) + corner(39.0 - 4 * i, 10, "");
      addCell(i, 0, 0, -1);
      addCell(i, 1, 10, 1);
    }
    const std::string hall = corner(0, 0, "") + south + corner(44, 0, "") + corner(44, 10, "") +
                             north + corner(0, 10, "");
    addSector("hall", hall, 5);
    return fmt::format(R"({{"light":0.1,"player":{{"x":1,"y":5,"z":1.7,"angle":0}},
"movers":{{{}}},"sectors":{{{}}}}})",
                       movers_, sectors_);
  }

  static std::string lights() {
    std::string lights;
    for (int i = 0; i < kDoors / 2; ++i)
      for (const double y : {-2.5, 5.0, 12.5})
        lights += fmt::format(R"({}{{"x":{},"y":{},"z":2.6,"curve":[[0,220],[9,0]]}})",
                              lights.empty() ? "" : ",", 4 + 4 * i, y);
    return fmt::format(R"({{"lights":[{}]}})", lights);
  }

 private:
  static std::string doorName(int i, int side) { return fmt::format("door {} {}", i, side); }

  /// A corner, and what its wall leads to.
  static std::string corner(double x, double y, const std::string& next) {
    return fmt::format("{},{},{};", x, y, next);
  }

  void addCell(int i, int side, double y, double out) {
    const std::string door = doorName(i, side);
    const std::string cell = fmt::format("cell {} {}", i, side);
    const double west = 3 + 4 * i;
    const double east = west + 2;
    const double outer = y + 0.4 * out;
    // Clockwise on the plan, where y grows down.
    if (out < 0) {
      addSector(door,
                corner(west, outer, cell) + corner(east, outer, "") + corner(east, y, "hall") +
                    corner(west, y, ""),
                0);
      addSector(cell,
                corner(west - 0.8, y - 5, "") + corner(east + 0.8, y - 5, "") +
                    corner(east + 0.8, outer, "") + corner(east, outer, door) +
                    corner(west, outer, "") + corner(west - 0.8, outer, ""),
                3);
    } else {
      addSector(door,
                corner(west, y, "hall") + corner(east, y, "") + corner(east, outer, cell) +
                    corner(west, outer, ""),
                0);
      addSector(cell,
                corner(west - 0.8, outer, "") + corner(west, outer, door) +
                    corner(east, outer, "") + corner(east + 0.8, outer, "") +
                    corner(east + 0.8, y + 5, "") + corner(west - 0.8, y + 5, ""),
                3);
    }
    movers_ += fmt::format(R"({}"{}":{{"sectors":"{}","part":"ceiling","to":2.6}})",
                           movers_.empty() ? "" : ",", door, door);
  }

  void addSector(const std::string& name, std::string corners, double ceiling) {
    std::string points;
    std::string walls;
    for (std::size_t end = 0; (end = corners.find(';')) != std::string::npos;
         corners.erase(0, end + 1)) {
      const std::string one = corners.substr(0, end);
      const std::size_t comma = one.rfind(',');
      const std::string next = one.substr(comma + 1);
      if (!points.empty()) {
        points += ',';
        walls += ',';
      }
      points += one.substr(0, comma);
      walls += next.empty() ? R"({"texture":"#908070"})"
                            : fmt::format(R"({{"next":"{}","texture":"#705030"}})", next);
    }
    sectors_ += fmt::format(
        R"({}"{}":{{"floor":{{"texture":"#707070"}},"ceiling":{{"z":{},"texture":"#909090"}},
"loops":{{"border":{{"v":[{}],"walls":[{}]}}}}}})",
        sectors_.empty() ? "" : ",\n", name, ceiling, points, walls);
  }

  std::string movers_;
  std::string sectors_;
};

/// The level with the light of all states that its doors pass, one after the other.
struct Doors {
  LoadedLevel authored;
  BakedLight light;
  Renderer still;
  MovedView view;
  FrameScratch scratch = {};
  PixelBuffer memory = {};

  explicit Doors(LoadedLevel level)
      : authored(std::move(level)),
        light(bake(authored.scene(), authored.level.bake, 1)),
        still(authored.scene(), authored.textures, light),
        view(authored.scene(), still) {}
};

/// The first door is ahead of the second by a little, and so on: no two stand alike.
std::vector<double> sharesAt(int frame) {
  std::vector<double> shares;
  for (int i = 0; i < kDoors; ++i) shares.push_back(0.02 * (frame + 1) + 0.02 * (kDoors - i));
  return shares;
}

tl::expected<std::shared_ptr<Doors>, std::string> doorsOf(const std::filesystem::path& file) {
  SourcedResult sourced = loadLevelWithSource(file);
  if (!sourced.result.loaded) return tl::unexpected(format(sourced.result.diagnostics.front()));
  auto doors = std::make_shared<Doors>(*std::move(sourced.result.loaded));
  const RestStates states(sharesAt(0));
  for (std::size_t i = 1; i < states.count(); ++i) {
    LoadResult rest = levelAt(doors->authored, sourced.source, states.shares(i));
    if (!rest.loaded) return tl::unexpected(format(rest.diagnostics.front()));
    BakedLight light = bake(rest.loaded->scene(), rest.loaded->level.bake, 1);
    doors->view.add(std::make_shared<const RestLight>(
        RestLight{states.shares(i), std::move(rest.loaded->geometry), std::move(light)}));
  }
  return doors;
}

}  // namespace

Prepared prepareMovingDoors(PeerInputs& inputs) {
  HallOfDoors hall;
  const std::filesystem::path file = inputs.folder() / "doors.json";
  std::ofstream(file) << hall.level();
  std::ofstream(inputs.folder() / "doors.lights.json") << HallOfDoors::lights();
  return doorsOf(file).map([&inputs](const std::shared_ptr<Doors>& doors) -> Measure {
    return [doors, &inputs] {
      const Player& player = *doors->authored.level.player;
      const Camera camera{player.sector, player.eye, player.angle, 0, 100, 1920, 1080};
      const PixelRows rows = doors->memory.rows(camera.width, camera.height);
      const Clock& clock = inputs.clock();
      double moving = 0;
      double drawing = 0;
      for (int frame = 0; frame < kFrames; ++frame) {
        const std::vector<double> shares = sharesAt(frame);
        const double begin = clock();
        doors->view.moveTo(shares);
        doors->view.light(nullptr);
        const double moved = clock();
        doors->view.renderer().draw(camera, LightMode::Both, doors->scratch, rows);
        // The first one sums up what differs between the states, as it is when a door sets out.
        if (frame == 0) continue;
        moving += moved - begin;
        drawing += clock() - moved;
      }
      const double frames = kFrames - 1;
      return Figures{(moving + drawing) / drawing, 1e3 * moving / frames, 1e3 * drawing / frames};
    };
  });
}

}  // namespace hearth
