#include "changes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "math/trig.h"

namespace hearth::extremes {

namespace {

using Json = nlohmann::ordered_json;

/// Both files, to be changed.
struct Documents {
  Json level;
  Json lights;
};

/// `files` after a change of their documents.
template <typename Change>
LevelFiles changed(const LevelFiles& files, Change&& change) {
  Documents documents{Json::parse(files.level), Json::parse(files.lights)};
  change(documents);
  return {documents.level.dump(), documents.lights.dump(), files.textures};
}

// What a level is made of, to be visited and changed.

/// Calls `visit(name, sector)` for each.
template <typename Visit>
void forEachSector(Json& level, Visit&& visit) {
  if (level["sectors"].is_object())
    for (auto& [name, sector] : level["sectors"].items()) visit(name, sector);
  else
    for (Json& sector : level["sectors"]) visit(sector["name"].get<std::string>(), sector);
}

/// Calls `visit(loop)`: vertices and walls.
template <typename Visit>
void forEachLoop(Json& sector, Visit&& visit) {
  for (auto& [key, loop] : sector["loops"].items()) visit(loop);
}

/// Calls `visit(wall)` for solids and portals, those of stacks too.
template <typename Visit>
void forEachWall(Json& loop, Visit&& visit) {
  const auto visitOne = [&](Json& wall) {
    if (!wall.contains("walls")) return visit(wall);
    for (Json& subWall : wall["walls"]) visit(subWall);
  };
  if (loop["walls"].is_object()) return visitOne(loop["walls"]);
  for (Json& wall : loop["walls"]) visitOne(wall);
}

/// Calls `visit(texture)` for each texture of the walls of a loop.
template <typename Visit>
void forEachTextureOf(Json& loop, Visit&& visit) {
  forEachWall(loop, [&](Json& wall) {
    for (const char* key : {"texture", "upper", "lower", "middle"})
      if (wall.contains(key)) visit(wall[key]);
  });
}

/// Both flats of a sector, whether the file has them or not, with their heights spelled out.
template <typename Visit>
void forEachFlat(Json& sector, Visit&& visit) {
  for (const char* key : {"floor", "ceiling"}) {
    Json& flat = sector[key];
    if (!flat.contains("z")) flat["z"] = key == std::string_view("floor") ? 0.0 : 4.0;
    visit(flat);
  }
}

/// The slopes that a sector has.
template <typename Visit>
void forEachSlope(Json& sector, Visit&& visit) {
  for (const char* key : {"slopeFloor", "slopeCeil"})
    if (sector.contains(key)) visit(sector[key]);
}

/// `texture` in its object form, with scale and offset spelled out.
Json spelledOut(const Json& texture) {
  Json result = {{"name", ""}, {"scale", {1.0, 1.0}}, {"offset", {0.0, 0.0}}};
  if (texture.is_object()) {
    result.update(texture);
    return result;
  }
  std::istringstream words(texture.get<std::string>());
  std::string name;
  words >> name;
  result["name"] = name;
  char comma = 0;
  for (const char* key : {"scale", "offset"}) {
    double first = 0;
    double second = 0;
    if (words >> first >> comma >> second) result[key] = {first, second};
  }
  return result;
}

void changePlace(Json& place, const char* x, const char* y, const char* z,
                 const LengthChange& change) {
  const Vec2 p = change.point({place[x].get<double>(), place[y].get<double>()});
  place[x] = p.x;
  place[y] = p.y;
  if (place.contains(z)) place[z] = change.height(place[z].get<double>());
}

void changeCamera(Json& camera, const LengthChange& change) {
  const Vec2 p = change.point({camera[0].get<double>(), camera[1].get<double>()});
  camera[0] = p.x;
  camera[1] = p.y;
  camera[2] = change.height(camera[2].get<double>());
}

void changeVertices(Json& loop, const LengthChange& change) {
  Json& v = loop["v"];
  for (std::size_t i = 0; i + 1 < v.size(); i += 2) {
    const Vec2 p = change.point({v[i].get<double>(), v[i + 1].get<double>()});
    v[i] = p.x;
    v[i + 1] = p.y;
  }
}

void changeTexture(Json& texture, const LengthChange& change) {
  if (!texture.is_object()) return;
  if (texture.contains("along")) texture["along"] = change.length(texture["along"].get<double>());
  if (texture.contains("zref")) texture["zref"] = change.height(texture["zref"].get<double>());
}

/// Heights that are written as differences change with the heights that they lead to.
void changeSlope(Json& slope, double base, double sign, const LengthChange& change) {
  for (Json& z : slope["z"])
    if (!z.is_null())
      z = std::abs(change.height(base + sign * z.get<double>()) - change.height(base));
  if (slope.contains("sidewall")) changeTexture(slope["sidewall"], change);
}

void changeSector(Json& sector, const LengthChange& change) {
  forEachFlat(sector, [](Json&) {});  // spells the heights out
  const double floor = sector["floor"]["z"].get<double>();
  const double ceiling = sector["ceiling"]["z"].get<double>();
  if (sector.contains("slopeFloor")) changeSlope(sector["slopeFloor"], floor, 1, change);
  if (sector.contains("slopeCeil")) changeSlope(sector["slopeCeil"], ceiling, -1, change);
  sector["floor"]["z"] = change.height(floor);
  sector["ceiling"]["z"] = change.height(ceiling);
  forEachLoop(sector, [&](Json& loop) {
    changeVertices(loop, change);
    forEachWall(loop, [&](Json& wall) {
      if (wall.contains("z"))
        wall["z"] = change.height(floor + wall["z"].get<double>()) - change.height(floor);
    });
    forEachTextureOf(loop, [&](Json& texture) { changeTexture(texture, change); });
  });
}

template <typename Visit>
void forEachThing(Json& level, Visit&& visit) {
  if (!level.contains("things")) return;
  for (Json& thing : level["things"]) visit(thing);
}

/// Calls `visit(place)` for what has x, y and mostly z: the player, things and lights.
template <typename Visit>
void forEachPlace(Documents& files, Visit&& visit) {
  if (files.level.contains("player")) visit(files.level["player"]);
  forEachThing(files.level, visit);
  for (Json& light : files.lights["lights"]) visit(light);
}

/// Calls `visit(texture)` for every texture of a level.
template <typename Visit>
void forEachTexture(Json& level, Visit&& visit) {
  forEachSector(level, [&](const std::string&, Json& sector) {
    forEachFlat(sector, [&](Json& flat) {
      if (flat.contains("texture")) visit(flat["texture"]);
    });
    forEachSlope(sector, [&](Json& slope) {
      if (slope.contains("sidewall")) visit(slope["sidewall"]);
    });
    forEachLoop(sector, [&](Json& loop) { forEachTextureOf(loop, visit); });
  });
}

void scaleTexture(Json& texture, double factor) {
  texture = spelledOut(texture);
  for (Json& size : texture["scale"]) size = size.get<double>() * factor;
}

/// Images of skies are measured in turns and tangents, not in metres.
void scaleTextures(Json& level, double factor) {
  forEachSector(level, [&](const std::string&, Json& sector) {
    forEachFlat(sector, [&](Json& flat) {
      if (flat.contains("texture") && !flat.value("parallax", false))
        scaleTexture(flat["texture"], factor);
    });
    forEachSlope(sector, [&](Json& slope) {
      if (slope.contains("sidewall")) scaleTexture(slope["sidewall"], factor);
    });
    forEachLoop(sector, [&](Json& loop) {
      forEachTextureOf(loop, [&](Json& texture) { scaleTexture(texture, factor); });
    });
  });
}

void scaleLight(Json& light, double factor) {
  if (light.contains("falloff")) light["falloff"] = light["falloff"].get<double>() / factor;
  if (light.contains("radius")) light["radius"] = light["radius"].get<double>() * factor;
  if (light.contains("curve"))
    for (Json& point : light["curve"]) point[0] = point[0].get<double>() * factor;
}

/// Of a model's file the lengths stay as they are.
void scaleMesh(Json& thing, double factor) {
  Json& scale = thing["scale"];
  if (scale.is_null()) scale = 1.0;
  if (scale.is_number()) scale = scale.get<double>() * factor;
  if (scale.is_array())
    for (Json& axis : scale) axis = axis.get<double>() * factor;
}

/// Except those sizes that come from images.
void scaleThing(Json& thing, double factor) {
  for (const char* key : {"size", "offset"})
    if (thing.contains(key))
      for (Json& length : thing[key]) length = length.get<double>() * factor;
  for (const char* key : {"radius", "height"})
    if (thing.contains(key)) thing[key] = thing[key].get<double>() * factor;
  if (thing.contains("mesh")) scaleMesh(thing, factor);
}

void turnThings(Json& level, double degrees) {
  forEachThing(level,
               [degrees](Json& thing) { thing["angle"] = thing.value("angle", 0.0) + degrees; });
}

/// The directions of spots and suns; `turned` gives the new angle of an old one.
template <typename Turned>
void turnLights(Json& file, Turned&& turned) {
  const auto turn = [&](Json& light) { light["angle"] = turned(light.value("angle", 0.0)); };
  for (Json& light : file["lights"])
    if (light.contains("spot")) turn(light["spot"]);
  if (file.contains("suns"))
    for (Json& sun : file["suns"]) turn(sun);
}

void turnCameras(Json& level, double degrees) {
  if (level.contains("player") && level["player"].contains("angle"))
    level["player"]["angle"] = level["player"]["angle"].get<double>() + degrees;
  for (Json& shot : level["shots"]) shot["camera"][3] = shot["camera"][3].get<double>() + degrees;
}

/// Gives out a colour at a time, none twice.
class Palette {
 public:
  std::string next() {
    ++count_;
    return fmt::format("#{:06x}", count_ * 0x9E3779U & 0xFFFFFFU);  // odd: a permutation
  }

 private:
  std::uint32_t count_ = 0;
};

void colorFlats(Json& sector, Palette& palette) {
  forEachFlat(sector, [&](Json& flat) {
    if (flat.contains("texture")) flat["texture"] = palette.next();
  });
}

/// Twice the area of a loop; positive for a border wound as it should be.
double windingOf(const Json& v) {
  double twice = 0;
  for (std::size_t i = 0; i < v.size(); i += 2) {
    const std::size_t next = (i + 2) % v.size();
    twice += v[i].get<double>() * v[next + 1].get<double>() -
             v[next].get<double>() * v[i + 1].get<double>();
  }
  return twice;
}

/// `wall` with its images moved on by so many metres.
Json movedOn(Json wall, double metres) {
  Json holder = {{"walls", wall}};
  forEachTextureOf(holder, [&](Json& texture) {
    texture = spelledOut(texture);
    texture["along"] = texture.value("along", 0.0) + metres;
  });
  return holder["walls"];
}

void cutWalls(Json& loop, bool isBorder) {
  const Json v = loop["v"];
  const std::size_t count = v.size() / 2;
  const Json walls = loop["walls"];
  const bool isTurned = (windingOf(v) > 0) != isBorder;  // at load: then p0 is the second vertex
  Json vertices = Json::array();
  Json halves = Json::array();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 a{v[2 * i].get<double>(), v[2 * i + 1].get<double>()};
    const std::size_t next = (i + 1) % count;
    const Vec2 b{v[2 * next].get<double>(), v[2 * next + 1].get<double>()};
    const Vec2 middle = lerp(a, b, 0.5);
    vertices.insert(vertices.end(), {a.x, a.y, middle.x, middle.y});
    const Json& wall = walls.is_object() ? walls : walls[i];
    const Json later = movedOn(wall, length(middle - a));
    halves.push_back(isTurned ? later : wall);
    halves.push_back(isTurned ? wall : later);
  }
  loop["v"] = vertices;
  loop["walls"] = halves;
}

/// A slope keeps its heights at its old vertices; those between follow from its plane.
void cutSlope(Json& slope) {
  Json heights = Json::array();
  for (const Json& z : slope["z"]) {
    heights.push_back(z);
    heights.push_back(nullptr);
  }
  slope["z"] = heights;
}

template <typename NewName>
void renameReference(Json& holder, const char* key, NewName&& newName) {
  if (holder.contains(key)) holder[key] = newName(holder[key].template get<std::string>());
}

template <typename NewName>
void renameFlatPortal(Json& flat, NewName&& newName) {
  if (!flat.contains("next")) return;
  Json& next = flat["next"];
  if (next.is_string()) {
    const auto pair = next.get<std::string>();
    const std::size_t dash = pair.find('-');
    next = Json{{"up", pair.substr(0, dash)}, {"down", pair.substr(dash + 1)}};
  }
  renameReference(next, "up", newName);
  renameReference(next, "down", newName);
}

Json reversed(const Json& values) {
  if (values.is_array()) {
    Json result = values;
    std::reverse(result.begin(), result.end());
    return result;
  }
  std::vector<std::string> keys;
  for (const auto& [key, value] : values.items()) keys.push_back(key);
  Json result = Json::object();
  for (auto key = keys.rbegin(); key != keys.rend(); ++key) result[*key] = values[*key];
  return result;
}

void changeLengths(Documents& files, const LengthChange& change) {
  forEachSector(files.level,
                [&](const std::string&, Json& sector) { changeSector(sector, change); });
  forEachPlace(files, [&](Json& place) { changePlace(place, "x", "y", "z", change); });
  for (Json& shot : files.level["shots"]) changeCamera(shot["camera"], change);
}

}  // namespace

LevelFiles withLengths(const LevelFiles& original, const LengthChange& change) {
  return changed(original, [&](Documents& files) { changeLengths(files, change); });
}

LevelFiles moved(const LevelFiles& original, Vec3 by) {
  return changed(original, [&](Documents& files) {
    changeLengths(files, {.point = [by](Vec2 p) { return p + by.xy(); },
                          .height = [by](double z) { return z + by.z; },
                          .length = [](double length) { return length; }});
    forEachSector(files.level, [](const std::string&, Json& sector) {
      forEachFlat(sector, [](Json& flat) { flat["isRelative"] = true; });
    });
  });
}

LevelFiles scaled(const LevelFiles& original, double factor) {
  return changed(original, [&](Documents& files) {
    const auto times = [factor](double length) { return length * factor; };
    changeLengths(
        files,
        {.point = [factor](Vec2 p) { return factor * p; }, .height = times, .length = times});
    scaleTextures(files.level, factor);
    forEachThing(files.level, [factor](Json& thing) { scaleThing(thing, factor); });
    for (Json& light : files.lights["lights"]) scaleLight(light, factor);
    Json& texel = files.lights["bake"]["texel"];
    texel = texel.get<double>() * factor;
  });
}

LevelFiles turned(const LevelFiles& original, double degrees) {
  return changed(original, [&](Documents& files) {
    const SinCos by = sinCosDegrees(degrees);
    const auto same = [](double length) { return length; };
    changeLengths(files, {.point =
                              [by](Vec2 p) {
                                return p.x * Vec2{by.cos, by.sin} + p.y * Vec2{-by.sin, by.cos};
                              },
                          .height = same,
                          .length = same});
    turnThings(files.level, degrees);
    turnCameras(files.level, degrees);
    turnLights(files.lights, [degrees](double angle) { return angle + degrees; });
  });
}

LevelFiles mirrored(const LevelFiles& original) {
  return changed(original, [&](Documents& files) {
    const auto same = [](double length) { return length; };
    changeLengths(files, {.point =
                              [](Vec2 p) {
                                return Vec2{-p.x, p.y};
                              },
                          .height = same,
                          .length = same});
    for (Json& shot : files.level["shots"])
      shot["camera"][3] = 180 - shot["camera"][3].get<double>();
    turnLights(files.lights, [](double angle) { return 180 - angle; });
  });
}

LevelFiles withWallsCut(const LevelFiles& original) {
  return changed(original, [&](Documents& files) {
    forEachSector(files.level, [](const std::string&, Json& sector) {
      const bool isOnlyLoop = sector["loops"].size() == 1;
      for (auto& [key, loop] : sector["loops"].items())
        cutWalls(loop, isOnlyLoop || key == "border" || loop.value("name", "") == "border");
      forEachSlope(sector, cutSlope);
    });
  });
}

LevelFiles renamed(const LevelFiles& original) {
  return changed(original, [&](Documents& files) {
    const auto newName = [](const std::string& name) {
      return "~" + std::string(name.rbegin(), name.rend()) + "-";
    };
    Json sectors = Json::array();
    forEachSector(files.level, [&](const std::string& name, Json& sector) {
      sector["name"] = newName(name);
      forEachFlat(sector, [&](Json& flat) { renameFlatPortal(flat, newName); });
      forEachLoop(sector, [&](Json& loop) {
        forEachWall(loop, [&](Json& wall) { renameReference(wall, "next", newName); });
      });
      sectors.push_back(sector);
    });
    files.level["sectors"] = sectors;
    forEachPlace(files, [&](Json& place) { renameReference(place, "sector", newName); });
    for (Json& shot : files.level["shots"]) renameReference(shot, "sector", newName);
  });
}

LevelFiles reordered(const LevelFiles& original) {
  return changed(original, [&](Documents& files) {
    files.level["sectors"] = reversed(files.level["sectors"]);
    files.lights["lights"] = reversed(files.lights["lights"]);
  });
}

LevelFiles withPlainFlats(const LevelFiles& original) {
  return changed(original, [&](Documents& files) {
    Palette palette;
    forEachSector(files.level,
                  [&](const std::string&, Json& sector) { colorFlats(sector, palette); });
  });
}

LevelFiles withPlainSidewalls(const LevelFiles& original) {
  return changed(original, [&](Documents& files) {
    Palette palette;
    forEachSector(files.level, [&](const std::string&, Json& sector) {
      forEachSlope(sector, [&](Json& slope) {
        if (slope.contains("sidewall")) slope["sidewall"] = palette.next();
      });
    });
  });
}

LevelFiles withPlainColors(const LevelFiles& original) {
  return changed(original, [&](Documents& files) {
    Palette palette;
    forEachTexture(files.level, [&](Json& texture) { texture = palette.next(); });
  });
}

LevelFiles withoutThings(const LevelFiles& original) {
  return changed(original, [](Documents& files) { files.level.erase("things"); });
}

}  // namespace hearth::extremes
