#include "movers/random_movers.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "random_levels/random.h"
#include "random_levels/random_level.h"

namespace hearth::movers {

namespace {

using Json = nlohmann::ordered_json;
using random_levels::Random;

constexpr std::size_t kMostMovers = 4;
constexpr int kAttempts = 16;

/// A sector by its name, in an object or an array of sectors.
Json& sectorOf(Json& level, const std::string& name) {
  Json& sectors = level["sectors"];
  if (sectors.is_object()) return sectors[name];
  return *std::ranges::find_if(sectors, [&](const Json& sector) { return sector["name"] == name; });
}

std::vector<std::string> sectorNames(const Json& level) {
  std::vector<std::string> names;
  const Json& sectors = level["sectors"];
  for (const auto& [key, sector] : sectors.items())
    names.push_back(sectors.is_object() ? key : sector["name"].get<std::string>());
  return names;
}

template <typename Visit>
void forEachWall(Json& level, Visit&& visit) {
  const auto visitWall = [&](Json& wall) {
    if (!wall.contains("walls")) return visit(wall);
    for (Json& subWall : wall["walls"]) visit(subWall);
  };
  for (Json& sector : level["sectors"])
    for (Json& loop : sector["loops"]) {
      Json& walls = loop["walls"];
      if (walls.is_object()) {
        visitWall(walls);
      } else {
        for (Json& wall : walls) visitWall(wall);
      }
    }
}

/// Steps may show at walls where none did.
void dressPortals(Json& level) {
  forEachWall(level, [](Json& wall) {
    if (!wall.contains("next") || wall.contains("texture")) return;
    for (const char* step : {"upper", "lower"})
      if (!wall.contains(step)) wall[step] = "#7060a0";
  });
}

double heightOf(const Json& sector, const std::string& part) {
  const double standard = part == "floor" ? 0 : 4;
  return sector.contains(part) ? sector[part].value("z", standard) : standard;
}

/// A mover that may not suit the level.
Json anyMover(Random& random, Json& level) {
  const std::vector<std::string> names = sectorNames(level);
  const std::string name = names[random.below(names.size())];
  const Json& sector = sectorOf(level, name);
  const std::string part = random.below(2) == 0 ? "floor" : "ceiling";
  const double floor = heightOf(sector, "floor");
  const double ceiling = heightOf(sector, "ceiling");
  double to =
      (part == "floor" ? floor : ceiling) + 0.1875 * static_cast<double>(random.between(-8, 8));
  if (random.below(4) == 0) to = part == "floor" ? ceiling : floor;  // it closes
  return {{"sectors", {name}}, {"part", part}, {"to", to}};
}

}  // namespace

RandomMovers::RandomMovers(std::uint64_t seed, std::filesystem::path folder)
    : folder_(std::move(folder)), name_(fmt::format("movers_{}", seed)) {
  const RandomLevel random = makeRandomLevel(seed);
  lights_ = random.lightsJson;
  Json level = Json::parse(random.levelJson);
  level.erase("lights");
  dressPortals(level);
  level["movers"] = Json::object();
  Random whims(seed);
  for (int i = 0; i < kAttempts && level["movers"].size() < kMostMovers; ++i) {
    const std::string name = fmt::format("mover {}", i);
    level["movers"][name] = anyMover(whims, level);
    SourcedResult result = load(level.dump());
    if (!result.result.loaded) {
      level["movers"].erase(name);
      continue;
    }
    loaded_ = std::move(result);
  }
  level_ = level.dump();
}

RandomMovers::~RandomMovers() {
  for (const char* variant : {"", "_authored"})
    for (const char* kind : {".json", ".lights.json"})
      std::filesystem::remove(fileOf(std::string(variant) + kind));
}

std::filesystem::path RandomMovers::fileOf(const std::string& variant) const {
  return folder_ / (name_ + variant);
}

SourcedResult RandomMovers::load(const std::string& level) const {
  std::ofstream(fileOf(".json")) << level;
  std::ofstream(fileOf(".lights.json")) << lights_;
  return loadLevelWithSource(fileOf(".json"));
}

LoadResult RandomMovers::loadAuthoredAt(std::span<const double> ends) const {
  Json level = Json::parse(level_);
  std::size_t i = 0;
  for (const auto& [name, mover] : level["movers"].items()) {
    if (ends[i++] == 0) continue;
    const std::string part = mover["part"];
    for (const Json& sector : mover["sectors"])
      sectorOf(level, sector.get<std::string>())[part]["z"] = mover["to"];
  }
  level.erase("movers");
  std::ofstream(fileOf("_authored.json")) << level.dump();
  std::ofstream(fileOf("_authored.lights.json")) << lights_;
  return loadLevel(fileOf("_authored.json"));
}

}  // namespace hearth::movers
