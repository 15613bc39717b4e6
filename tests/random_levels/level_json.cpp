#include "random_levels/level_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace hearth::random_levels {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
  const auto whole = static_cast<std::int64_t>(value);
  return static_cast<double>(whole) == value ? Json(whole) : Json(value);
}

Json number(Um length) { return number(metres(length)); }

Json pairOf(const std::array<double, 2>& values) {
  return Json::array({number(values[0]), number(values[1])});
}

Json textureJson(const TextureUse& use) {
  if (use.isObject) {
    Json json{{"name", use.name}};
    if (use.scale) json["scale"] = pairOf(*use.scale);
    if (use.offset) json["offset"] = pairOf(*use.offset);
    if (use.along) json["along"] = number(*use.along);
    if (use.zref) json["zref"] = number(*use.zref);
    return json;
  }
  std::string text = use.name;
  if (use.scale) text += fmt::format(" {},{}", (*use.scale)[0], (*use.scale)[1]);
  if (use.offset) text += fmt::format(" {},{}", (*use.offset)[0], (*use.offset)[1]);
  return text;
}

class LevelWriter {
 public:
  LevelWriter(const Model& model, const Spelling& spelling) : model_(model), spelling_(spelling) {}

  Json sectors() const {
    Json json = spelling_.hasSectorArray ? Json::array() : Json::object();
    for (const Sector& sector : model_.sectors) {
      if (spelling_.hasSectorArray) {
        json.push_back(sectorJson(sector, Json{{"name", sector.name}}));
      } else {
        json[sector.name] = sectorJson(sector, Json::object());
      }
    }
    return json;
  }

 private:
  Json sectorJson(const Sector& sector, Json json) const {
    if (sector.light) json["light"] = number(*sector.light);
    json["floor"] = flatJson(sector.floor, 0);
    json["ceiling"] = flatJson(sector.ceiling, 4 * kMetre);
    if (sector.floor.wedge) json["slopeFloor"] = slopeJson(sector, *sector.floor.wedge);
    if (sector.ceiling.wedge) json["slopeCeil"] = slopeJson(sector, *sector.ceiling.wedge);
    Json loops = spelling_.hasLoopArrays ? Json::array() : Json::object();
    for (const Loop& loop : sector.loops) {
      if (spelling_.hasLoopArrays) {
        loops.push_back(loopJson(sector, loop, Json{{"name", loop.name}}));
      } else {
        loops[loop.name] = loopJson(sector, loop, Json::object());
      }
    }
    json["loops"] = std::move(loops);
    return json;
  }

  // ---- flats and slopes

  Json flatJson(const Flat& flat, Um defaultZ) const {
    Json json = Json::object();
    if (!spelling_.omitsDefaults || flat.z != defaultZ) json["z"] = number(flat.z);
    if (flat.flatPortal) {
      json["next"] = flatPortalJson(flat);
      return json;
    }
    json["texture"] = textureJson(flat.texture);
    if (flat.isRelative || !spelling_.omitsDefaults) json["isRelative"] = flat.isRelative;
    if (flat.isSky) json["parallax"] = true;
    return json;
  }

  Json flatPortalJson(const Flat& flat) const {
    const FlatPortal& flatPortal = model_.flatPortals[*flat.flatPortal];
    const std::string& up = model_.sectors[flatPortal.up].name;
    const std::string& down = model_.sectors[flatPortal.down].name;
    if (flat.isFlatPortalObject) return {{"up", up}, {"down", down}};
    return up + "-" + down;
  }

  Json slopeJson(const Sector& sector, const Wedge& wedge) const {
    Json heights = Json::array();
    for (const std::size_t i : fileOrder(sector.loops[0])) {
      const Vec2 p = metres(model_.mesh.vertices[sector.loops[0].vertices[i]]);
      const double digits = wedge.isRounded ? 1e4 : 1e9;
      // A foot that is zero but for the last bits must not come out negative.
      const double height = std::max(0.0, std::floor(wedge.at(p) * digits + 0.5) / digits);
      heights.push_back(wedge.nulls.contains(i) ? Json(nullptr) : number(height));
    }
    Json json{{"z", heights}, {"sidewall", textureJson(wedge.sidewall)}};
    if (wedge.isRelative) json["isRelative"] = true;
    return json;
  }

  // ---- loops

  /// Numbers of the loop's vertices as the file lists them.
  static std::vector<std::size_t> fileOrder(const Loop& loop) {
    std::vector<std::size_t> order(loop.vertices.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    if (loop.isWoundWrongly) std::reverse(order.begin(), order.end());
    return order;
  }

  Json loopJson(const Sector& sector, const Loop& loop, Json json) const {
    Json coordinates = Json::array();
    Json walls = Json::array();
    const std::vector<std::size_t> order = fileOrder(loop);
    for (std::size_t k = 0; k < order.size(); ++k) {
      const Point p = model_.mesh.vertices[loop.vertices[order[k]]];
      coordinates.push_back(number(p.x));
      coordinates.push_back(number(p.y));
      // Listed backwards, a wall starts at the vertex where it ends.
      const std::size_t wall = loop.isWoundWrongly ? order[(k + 1) % order.size()] : order[k];
      walls.push_back(wallJson(sector, loop.walls[wall]));
    }
    json["v"] = std::move(coordinates);
    json["walls"] = loop.hasOneWall ? walls[0] : walls;
    return json;
  }

  Json wallJson(const Sector& sector, const Wall& wall) const {
    if (wall.pieces.size() == 1) return pieceJson(wall.pieces[0]);
    Json pieces = Json::array();
    for (std::size_t i = 0; i < wall.pieces.size(); ++i) {
      Json piece = pieceJson(wall.pieces[i]);
      if (i + 1 < wall.pieces.size()) piece["z"] = number(wall.pieces[i].top - sector.floor.z);
      pieces.push_back(std::move(piece));
    }
    return {{"walls", pieces}};
  }

  Json pieceJson(const Piece& piece) const {
    if (const auto* solid = std::get_if<SolidPiece>(&piece.kind)) {
      return {{"texture", textureJson(solid->texture)}};
    }
    const auto& portal = std::get<PortalPiece>(piece.kind);
    Json json{{"next", model_.sectors[portal.next].name}};
    if (portal.texture) json["texture"] = textureJson(*portal.texture);
    if (portal.upper) json["upper"] = textureJson(*portal.upper);
    if (portal.lower) json["lower"] = textureJson(*portal.lower);
    if (portal.maskedMiddle) json["middle"] = textureJson(*portal.maskedMiddle);
    return json;
  }

  const Model& model_;
  const Spelling& spelling_;
};

Json shotJson(const RandomView& view) {
  Json json{{"name", view.name},
            {"camera", Json::array({number(view.x), number(view.y), number(view.z),
                                    number(view.angle), number(view.pitch)})},
            {"size", Json::array({view.width, view.height})},
            {"sector", view.sector}};
  if (view.fov != 90) json["fov"] = number(view.fov);
  return json;
}

Json spriteJson(const Model& model, const RandomSprite& sprite) {
  const Vec3 p = sprite.place.position;
  Json json{{"x", number(p.x)}, {"y", number(p.y)}};
  if (sprite.saysHeight) json["z"] = number(p.z);
  if (sprite.namesSector) json["sector"] = model.sectors[sprite.place.sector].name;
  json["sprite"] = sprite.images.size() == 1 ? Json(sprite.images[0]) : Json(sprite.images);
  if (sprite.facing != SpriteFacing::Camera)
    json["facing"] = sprite.facing == SpriteFacing::Angle ? "angle" : "flat";
  if (sprite.angle != 0) json["angle"] = number(sprite.angle);
  if (sprite.size) json["size"] = pairOf(*sprite.size);
  if (sprite.offset) json["offset"] = pairOf(*sprite.offset);
  if (sprite.isBright) json["bright"] = true;
  return json;
}

Json placedModelJson(const Model& model, const PlacedModel& placed, const std::string& file) {
  const Vec3 p = placed.place.position;
  Json json{{"x", number(p.x)}, {"y", number(p.y)}};
  if (placed.saysHeight) json["z"] = number(p.z);
  if (placed.namesSector) json["sector"] = model.sectors[placed.place.sector].name;
  json["mesh"] = fmt::format("textures/{}.obj", file);
  const auto& [x, y, z] = placed.scale;
  if (x != y || y != z)
    json["scale"] = Json::array({number(x), number(y), number(z)});
  else if (x != 1)
    json["scale"] = number(x);
  if (placed.angle != 0) json["angle"] = number(placed.angle);
  if (!placed.texture.empty()) json["texture"] = placed.texture;
  if (placed.isTwoSided) json["twoSided"] = true;
  if (!placed.castsShadow) json["shadow"] = false;
  return json;
}

/// Sprites in their order, and models in theirs, each after as many sprites as it says or more.
Json thingsJson(const Model& model, const std::vector<RandomSprite>& sprites,
                const std::vector<PlacedModel>& placed) {
  const std::vector<ObjModel> files = objModels();
  Json things = Json::array();
  std::size_t next = 0;
  for (std::size_t i = 0; i <= sprites.size(); ++i) {
    for (; next < placed.size() && placed[next].spritesBefore <= i; ++next)
      things.push_back(placedModelJson(model, placed[next], files[placed[next].model].name));
    if (i < sprites.size()) things.push_back(spriteJson(model, sprites[i]));
  }
  return things;
}

Json sunJson(const RandomSun& sun) {
  Json json{{"angle", number(sun.angle)},
            {"pitch", number(sun.pitch)},
            {"intensity", number(sun.intensity)}};
  if (sun.size > 0) json["size"] = number(sun.size);
  if (!sun.color.empty()) json["color"] = sun.color;
  return json;
}

}  // namespace

std::string levelJson(const Model& model, const std::string& name,
                      const std::vector<RandomView>& views,
                      const std::vector<RandomSprite>& sprites,
                      const std::vector<PlacedModel>& models, const Spelling& spelling) {
  Json level{{"$schema", "level.schema.json"}, {"version", 1}, {"name", name}};
  level["textures"] = "textures";
  if (spelling.namesLightsFile) level["lights"] = name + ".lights.json";
  if (spelling.levelLight) level["light"] = number(*spelling.levelLight);
  const RandomView& start = views.front();
  level["player"] = {{"sector", start.sector},
                     {"x", number(start.x)},
                     {"y", number(start.y)},
                     {"z", number(start.z)},
                     {"angle", number(start.angle)}};
  level["shots"] = Json::array();
  for (const RandomView& view : views) level["shots"].push_back(shotJson(view));
  level["sectors"] = LevelWriter(model, spelling).sectors();
  if (!sprites.empty() || !models.empty()) level["things"] = thingsJson(model, sprites, models);
  return level.dump(1) + "\n";
}

std::string lightsJson(const Model& model, const std::vector<RandomLight>& lights,
                       const FarLights& farLights, const Spelling& spelling) {
  Json list = Json::array();
  for (const RandomLight& light : lights) {
    const Vec3 p = light.place.position;
    Json json{{"x", number(p.x)}, {"y", number(p.y)}, {"z", number(p.z)}};
    if (light.namesSector) json["sector"] = model.sectors[light.place.sector].name;
    if (light.curve.empty()) {
      json["intensity"] = number(light.intensity);
      json["falloff"] = number(light.falloff);
    }
    for (const auto& point : light.curve) json["curve"].push_back(pairOf(point));
    if (!light.color.empty()) json["color"] = light.color;
    if (light.spot)
      json["spot"] = {{"angle", number(light.spot->angle)},
                      {"pitch", number(light.spot->pitch)},
                      {"inner", number(light.spot->inner)},
                      {"outer", number(light.spot->outer)}};
    list.push_back(std::move(json));
  }
  if (spelling.hasLightArray) return list.dump(1) + "\n";
  Json bake{{"texel", number(spelling.texel)}};
  if (spelling.samples != 1) bake["samples"] = spelling.samples;
  if (spelling.lambert) bake["lambert"] = true;
  Json file{{"version", 1}, {"lights", list}, {"bake", bake}};
  for (const RandomSun& sun : farLights.suns) file["suns"].push_back(sunJson(sun));
  if (farLights.sky) {
    file["sky"] = {{"intensity", number(farLights.sky->intensity)}};
    if (!farLights.sky->color.empty()) file["sky"]["color"] = farLights.sky->color;
  }
  return file.dump(1) + "\n";
}

}  // namespace hearth::random_levels
