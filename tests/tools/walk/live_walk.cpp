#include "live_walk.h"

#include <nlohmann/json.hpp>

namespace hearth::test {

namespace {

using Json = nlohmann::ordered_json;

Json read(const fs::path& file) { return Json::parse(std::ifstream(file)); }

}  // namespace

void LiveWalk::paintFloors(const std::string& texture) {
  Json level = read(levelFile());
  for (auto& [name, sector] : level["sectors"].items())
    if (sector["floor"].contains("texture")) sector["floor"]["texture"] = texture;
  write(levelFile(), level.dump());
}

void LiveWalk::writeRoom(const std::string& name, double floor) {
  Json level = read(levelFile());
  level.erase("shots");
  level["player"] = {{"sector", name}, {"x", 1}, {"y", 2}, {"z", 1.6}, {"angle", 0}};
  level["sectors"] = {
      {name,
       {{"floor", {{"z", floor}, {"texture", "#707070"}}},
        {"ceiling", {{"z", 3}, {"texture", "#707070"}}},
        {"loops",
         {{"border", {{"v", {0, 0, 4, 0, 4, 4, 0, 4}}, {"walls", {{"texture", "#a08060"}}}}}}}}}};
  write(levelFile(), level.dump());
  write(lightsFile(), R"([{"x": 2, "y": 2, "z": 2.5, "falloff": 0.4}])");
}

}  // namespace hearth::test
