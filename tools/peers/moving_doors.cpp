// Frames in which many flats move.

#include <fmt/format.h>

#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "load/source.h"
#include "peers/peer_inputs.h"
#include "peers/peer_rows.h"
#include "viewer/walk/moved_view.h"

namespace hearth {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kDoors = 20;  ///< half of them on each side of the hall
constexpr int kFrames = 24;

/// A corner of a sector, and what its wall leads to; empty where that is solid.
struct Corner {
  double x;
  double y;
  std::string next;
};

/// The same on the other side of a hall 10 m wide.
std::vector<Corner> mirrored(const std::vector<Corner>& corners) {
  std::vector<Corner> others;
  for (std::size_t i = corners.size(); i > 0; --i) {
    const Corner& corner = corners[i - 1];
    // Walls begin at the corner where they ended.
    const Corner& begin = corners[(i + corners.size() - 2) % corners.size()];
    others.push_back({corner.x, 10 - corner.y, begin.next});
  }
  return others;
}

Json sectorOf(const std::vector<Corner>& corners, double ceiling) {
  Json points = Json::array();
  Json walls = Json::array();
  for (const Corner& corner : corners) {
    points.insert(points.end(), {corner.x, corner.y});
    walls.push_back(corner.next.empty() ? Json{{"texture", "#908070"}}
                                        : Json{{"next", corner.next}, {"texture", "#705030"}});
  }
  return {{"floor", {{"texture", "#707070"}}},
          {"ceiling", {{"z", ceiling}, {"texture", "#909090"}}},
          {"loops", {{"border", {{"v", points}, {"walls", walls}}}}}};
}

/// A hall of 44 m, doors of 2 m along both of its long walls, and a cell with a lamp behind each.
Json hallOfDoors() {
  Json movers = Json::object();
  Json sectors = Json::object();
  std::vector<Corner> hall{{0, 0, ""}};
  std::vector<Corner> south;  // whose walls follow from east to west
  for (int i = 0; i < kDoors / 2; ++i) {
    const double west = 3 + 4 * i;
    const double east = west + 2;
    for (const std::string side : {"north", "south"}) {
      const std::string door = fmt::format("{} door {}", side, i);
      const std::string cell = fmt::format("{} cell {}", side, i);
      const std::vector<Corner> frame{
          {west, -0.4, cell}, {east, -0.4, ""}, {east, 0, "hall"}, {west, 0, ""}};
      const std::vector<Corner> room{{west - 0.8, -5, ""},   {east + 0.8, -5, ""},
                                     {east + 0.8, -0.4, ""}, {east, -0.4, door},
                                     {west, -0.4, ""},       {west - 0.8, -0.4, ""}};
      const bool isNorth = side == "north";
      sectors[door] = sectorOf(isNorth ? frame : mirrored(frame), 0);
      sectors[cell] = sectorOf(isNorth ? room : mirrored(room), 3);
      movers[door] = {{"sectors", door}, {"part", "ceiling"}, {"to", 2.6}};
    }
    hall.insert(hall.end(), {{west, 0, fmt::format("north door {}", i)}, {east, 0, ""}});
    south.insert(south.begin(), {{east, 10, fmt::format("south door {}", i)}, {west, 10, ""}});
  }
  hall.insert(hall.end(), {{44, 0, ""}, {44, 10, ""}});
  hall.insert(hall.end(), south.begin(), south.end());
  hall.push_back({0, 10, ""});
  sectors["hall"] = sectorOf(hall, 5);
  return {{"light", 0.1},
          {"player", {{"x", 1}, {"y", 5}, {"z", 1.7}, {"angle", 0}}},
          {"movers", std::move(movers)},
          {"sectors", std::move(sectors)}};
}

Json lampsOfDoors() {
  Json lamps = Json::array();
  for (int i = 0; i < kDoors / 2; ++i)
    for (const double y : {-2.5, 5.0, 12.5})
      lamps.push_back({{"x", 4 + 4 * i}, {"y", y}, {"z", 2.6}, {"curve", {{0, 220}, {9, 0}}}});
  return lamps;
}

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
  const std::filesystem::path file = inputs.folder() / "doors.json";
  std::ofstream(file) << hallOfDoors();
  std::ofstream(inputs.folder() / "doors.lights.json") << lampsOfDoors();
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
