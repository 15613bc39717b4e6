#include "import/doom/things.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "import/doom/pieces.h"
#include "import/doom/thing_types.h"
#include "math/vec.h"

namespace hearth::doom {

namespace {

using Json = nlohmann::ordered_json;

/// Where the image of a type is, in metres.
struct ImagePlace {
  double width;
  double height;
  double right;  ///< from the thing to the image's middle
  double up;     ///< from the thing to its lower edge
};

/// Doom draws over the floor what of an image lies below it, and over the ceiling what lies above;
/// in Hearth both hide that. So the image of a thing that stands is raised onto the floor, and that
/// of one that hangs lowered to the ceiling, as far as need be.
ImagePlace imagePlaceOf(const SpriteCanvas& canvas, const ThingType& type) {
  const auto [width, height] = canvas.size();
  const int up =
      type.hangs ? std::min(canvas.bottom, type.height - height) : std::max(canvas.bottom, 0);
  return {width * kUnit, height * kUnit, (canvas.right - canvas.left) * kUnit / 2, up * kUnit};
}

/// A frame as levels have it.
Json frameJson(const std::vector<std::string>& views) {
  return views.size() == 1 ? Json(views.front()) : Json(views);
}

/// Doom turns things to the eighths of a turn.
int eighthOf(int degrees) { return degrees / 45 * 45; }

class Placer {
 public:
  Placer(const GroundPlan& plan, Sprites& sprites, const ThingSettings& settings,
         Findings& findings)
      : plan_(plan),
        sprites_(sprites),
        settings_(settings),
        imagesLeft_(settings.maxImages),
        findings_(findings) {}

  Json things() {
    const std::vector<Thing>& all = plan_.map().things;
    for (std::size_t i = 0; i < all.size() && !isFull_; ++i)
      if (isThere(all[i], settings_.game)) place(i, all[i]);
    for (const auto& [reason, dropped] : dropped_)
      findings_.push_back({Outcome::Dropped, Part::Thing, dropped.first, textOf(reason, dropped)});
    return std::move(things_);
  }

 private:
  struct Dropped {
    std::size_t first;  ///< thing
    std::size_t others = 0;
  };

  void place(std::size_t number, const Thing& thing) {
    const ThingType* type = findThingType(thing.type);
    if (!type) return drop(number, fmt::format("its type, {}, is unknown", thing.type));
    if (*type->sprite == '\0' || (type->isMonster && !settings_.hasMonsters)) return;
    const auto region = plan_.regionAt(placeOf(thing.x, thing.y));
    if (!region) return drop(number, "it stands in no sector");
    const auto& look = lookOf(*type);
    if (!look) return drop(number, look.error());
    if (look->countImages() > imagesLeft_) return stop(number);
    imagesLeft_ -= look->countImages();
    things_.push_back(thingJson(thing, *type, *look, *region));
  }

  const tl::expected<SpriteLook, std::string>& lookOf(const ThingType& type) {
    const auto known = looks_.find(type.number);
    if (known != looks_.end()) return known->second;
    return looks_.emplace(type.number, sprites_.lookOf(type)).first->second;
  }

  Json thingJson(const Thing& thing, const ThingType& type, const SpriteLook& look,
                 std::uint32_t region) const {
    const ImagePlace image = imagePlaceOf(look.canvas, type);
    const Vec2 place = placeOf(thing.x, thing.y);
    Json json{{"name", type.name}};
    addImages(look, json);
    json["x"] = place.x;
    json["y"] = place.y;
    if (type.hangs) json["z"] = hangingHeight(plan_.lastingSpaceOf(region), type);
    json["sector"] = plan_.nameOf(region);
    if (look.hasSides()) json["angle"] = angleOf(eighthOf(thing.angle));
    json["size"] = {image.width, image.height};
    if (image.right != 0 || image.up != 0) json["offset"] = {image.right, image.up};
    if (look.isBright) json["bright"] = true;
    if (type.isSolid) addBody(type, image, json);
    return json;
  }

  static void addImages(const SpriteLook& look, Json& json) {
    if (look.frames.size() == 1) {
      json["sprite"] = frameJson(look.frames.front());
      return;
    }
    for (const auto& views : look.frames) json["frames"].push_back(frameJson(views));
    json["fps"] = std::round(look.framesPerSecond * 1000) / 1000;
  }

  /// Not below the floor, where a sector is too low.
  static double hangingHeight(const Space& space, const ThingType& type) {
    return std::max(space.floor, space.ceiling - type.height * kUnit);
  }

  /// No player of Doom gets over a solid thing, however low it is said to be: so what stands is as
  /// high as it looks.
  static void addBody(const ThingType& type, const ImagePlace& image, Json& json) {
    const double height = type.height * kUnit;
    json["radius"] = type.radius * kUnit;
    json["height"] = type.hangs ? height : std::max(height, image.up + image.height);
  }

  void drop(std::size_t number, const std::string& reason) {
    const auto [known, isFirst] = dropped_.emplace(reason, Dropped{number});
    if (!isFirst) ++known->second.others;
  }

  static std::string textOf(const std::string& reason, const Dropped& dropped) {
    if (dropped.others == 0) return reason;
    return fmt::format("{}; {} other thing{} dropped for that", reason, dropped.others,
                       dropped.others == 1 ? " is" : "s are");
  }

  void stop(std::size_t number) {
    isFull_ = true;
    findings_.push_back({Outcome::Dropped, Part::Thing, number,
                         fmt::format("its sprite and those of what follows: with it, sprites have "
                                     "more than {} images",
                                     settings_.maxImages)});
  }

  const GroundPlan& plan_;
  Sprites& sprites_;
  ThingSettings settings_;
  std::size_t imagesLeft_;
  Findings& findings_;
  std::map<std::uint16_t, tl::expected<SpriteLook, std::string>> looks_;  ///< by type
  std::map<std::string, Dropped> dropped_;                                ///< by the reason
  bool isFull_ = false;
  Json things_ = Json::array();
};

}  // namespace

Json spritesJson(const GroundPlan& plan, Sprites& sprites, const ThingSettings& settings,
                 Findings& findings) {
  return Placer(plan, sprites, settings, findings).things();
}

Json allThingsJson(const Map& map) {
  Json things = Json::array();
  for (const Thing& thing : map.things) {
    const Vec2 place = placeOf(thing.x, thing.y);
    things.push_back({{"type", thing.type},
                      {"x", place.x},
                      {"y", place.y},
                      {"angle", angleOf(thing.angle)},
                      {"flags", thing.flags}});
  }
  return things;
}

}  // namespace hearth::doom
