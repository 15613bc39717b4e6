#include <nlohmann/json.hpp>

#include "changes.h"

namespace hearth::extremes {

LevelFiles withUnseenSector(const LevelFiles& files) {
  using Json = nlohmann::ordered_json;
  Json level = Json::parse(files.level);
  Json lights = Json::parse(files.lights);
  const Json wall = {{"walls", {{{"texture", "#123456"}, {"z", 1.0}}, {{"texture", "#654321"}}}}};
  Json sector = {{"floor", {{"z", 0.0}, {"texture", "#405060"}}},
                 {"ceiling", {{"z", 4.0}, {"texture", "#605040"}}},
                 {"slopeFloor", {{"z", {0.0, 0.0, 0.5, 0.5}}, {"sidewall", "#ffffff"}}},
                 {"loops",
                  {{"border",
                    {{"v", {500.0, 500.0, 504.0, 500.0, 504.0, 504.0, 500.0, 504.0}},
                     {"walls", Json::array({wall, wall, wall, wall})}}}}}};
  if (level["sectors"].is_object()) {
    level["sectors"]["unseen"] = sector;
  } else {
    sector["name"] = "unseen";
    level["sectors"].push_back(sector);
  }
  for (const char* color : {"#ff0000", "#00ff40"})
    lights["lights"].push_back({{"x", 502.0},
                                {"y", 502.0},
                                {"z", 2.0},
                                {"sector", "unseen"},
                                {"color", color},
                                {"radius", 0.25},
                                {"curve", {{0.0, 255.0}, {2.0, 100.0}}}});
  return {level.dump(), lights.dump(), files.textures};
}

}  // namespace hearth::extremes
