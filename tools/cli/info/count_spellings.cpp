#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/info/format_features.h"

namespace hearth {

namespace {

using nlohmann::json;

/// Keys starting with `$` or `//` say nothing, whatever they hold.
bool isComment(const std::string& key) { return key.starts_with('$') || key.starts_with("//"); }

/// The members of an object or the elements of an array, comments left out.
template <typename Visit>
void forEachChild(const json& parent, Visit&& visit) {
  for (const auto& [key, value] : parent.items())
    if (!parent.is_object() || !isComment(key)) visit(value);
}

/// Counts the spellings of one level.
class SpellingCounter {
 public:
  explicit SpellingCounter(FeatureCounts& counts) : counts_(counts) {}

  void countLevel(const json& level) {
    addIf(level.contains("light"), FormatFeature::LevelLight);
    if (level.contains("player")) {
      counts_.add(FormatFeature::Player);
      countPosition(level["player"]);
    }
    if (level.contains("shots"))
      forEachChild(level["shots"], [&](const json& shot) {
        counts_.add(FormatFeature::Shot);
        countPosition(shot);
      });
    if (level.contains("things"))
      forEachChild(level["things"], [&](const json& thing) {
        countPosition(thing);
        if (!thing.contains("mesh"))
          countImages(thing.contains("frames") ? thing["frames"] : thing.at("sprite"));
      });
    if (level.contains("sectors"))
      forEachChild(level["sectors"], [&](const json& sector) { countSector(sector); });
    if (level.contains("movers"))
      forEachChild(level["movers"], [&](const json&) { counts_.add(FormatFeature::Mover); });
    if (level.contains("grid")) {
      counts_.add(FormatFeature::Grid);
      forEachChild(level["grid"].at("legend"), [&](const json& entry) { countEntry(entry); });
    }
  }

  void countLights(const json& file) {
    addIf(file.is_object() && file.contains("bake"), FormatFeature::BakeSettings);
    const json none = json::array();
    const json& lights = file.is_array() ? file : file.value("lights", none);
    forEachChild(lights, [&](const json& light) {
      counts_.add(FormatFeature::Light);
      countPosition(light);
      addIf(light.contains("falloff"), FormatFeature::LightFalloff);
      addIf(light.contains("curve"), FormatFeature::LightCurve);
      addIf(light.contains("color"), FormatFeature::LightColor);
      addIf(light.contains("radius"), FormatFeature::LightRadius);
      addIf(light.contains("spot"), FormatFeature::LightSpot);
    });
    if (file.is_object() && file.contains("suns"))
      forEachChild(file["suns"], [&](const json&) { counts_.add(FormatFeature::Sun); });
    addIf(file.is_object() && file.contains("sky"), FormatFeature::LightOfSky);
    if (file.is_object() && file.contains("emit"))
      forEachChild(file["emit"], [&](const json&) { counts_.add(FormatFeature::Emitter); });
  }

 private:
  void addIf(bool holds, FormatFeature feature) {
    if (holds) counts_.add(feature);
  }

  void countPosition(const json& holder) {
    counts_.add(holder.contains("sector") ? FormatFeature::PositionWithSector
                                          : FormatFeature::PositionWithoutSector);
  }

  /// A name, or a list of names and of such lists.
  void countImages(const json& images) {
    if (images.is_array()) {
      for (const json& image : images) countImages(image);
    } else {
      addIf(images.get<std::string>().starts_with('#'), FormatFeature::PlainColour);
    }
  }

  void countSector(const json& sector) {
    countAir(sector);
    for (const char* slope : {"slopeFloor", "slopeCeil"})
      if (sector.contains(slope)) countSlope(sector[slope]);
    forEachChild(sector.at("loops"), [&](const json& loop) {
      const json& walls = loop.at("walls");
      addIf(walls.is_object(), FormatFeature::OneWallForLoop);
      if (walls.is_object())
        countWall(walls);
      else
        forEachChild(walls, [&](const json& wall) { countWall(wall); });
    });
  }

  /// Of a sector, or of an entry of a grid's legend.
  void countAir(const json& air) {
    addIf(air.contains("light"), FormatFeature::SectorLight);
    for (const char* flat : {"floor", "ceiling"})
      if (air.contains(flat)) countFlat(air[flat]);
  }

  void countEntry(const json& entry) {
    countAir(entry);
    for (const char* role : {"wall", "upper", "lower"})
      if (entry.contains(role)) countTexture(entry[role]);
    addIf(entry.contains("walls"), FormatFeature::GridSides);
    if (entry.contains("walls"))
      forEachChild(entry["walls"], [&](const json& texture) { countTexture(texture); });
    addIf(entry.contains("next"), FormatFeature::GridNext);
  }

  void countFlat(const json& flat) {
    addIf(flat.value("isRelative", false), FormatFeature::RelativeFlat);
    if (flat.contains("texture")) countTexture(flat["texture"]);
    if (!flat.contains("next")) return;
    counts_.add(flat["next"].is_string() ? FormatFeature::FlatPortalString
                                         : FormatFeature::FlatPortalObject);
  }

  void countSlope(const json& slope) {
    for (const json& height : slope.at("z"))
      addIf(height.is_null(), FormatFeature::NullSlopeHeight);
    if (!slope.contains("sidewall")) return;
    countTexture(slope["sidewall"]);
    counts_.add(slope.value("isRelative", false) ? FormatFeature::RelativeSidewall
                                                 : FormatFeature::AbsoluteSidewall);
  }

  void countWall(const json& wall) {
    addIf(wall.contains("use") || wall.contains("cross"), FormatFeature::WallThatStarts);
    addIf(wall.contains("on"), FormatFeature::SwitchTexture);
    for (const char* role : {"texture", "upper", "lower", "middle"})
      if (wall.contains(role)) countTexture(wall[role]);
    if (wall.contains("walls"))
      countStack(wall["walls"]);
    else if (wall.contains("next"))
      countPortal(wall);
    else
      counts_.add(FormatFeature::SolidWall);
  }

  void countPortal(const json& wall) {
    addIf(wall.contains("middle"), FormatFeature::MiddleTexture);
    if (wall.contains("texture"))
      counts_.add(FormatFeature::PortalWithTexture);
    else if (wall.contains("upper") || wall.contains("lower"))
      counts_.add(FormatFeature::PortalWithSteps);
    else
      counts_.add(FormatFeature::PortalWithoutTexture);
  }

  void countStack(const json& subWalls) {
    counts_.add(FormatFeature::Stack);
    addIf(subWalls.size() >= 3, FormatFeature::StackOfThree);
    int portals = 0;
    for (const json& subWall : subWalls) {
      countWall(subWall);
      if (subWall.contains("next")) ++portals;
    }
    addIf(portals >= 2, FormatFeature::StackWithTwoPortals);
  }

  void countTexture(const json& texture) {
    addIf(texture.is_object(), FormatFeature::TextureObject);
    const std::string text =
        texture.is_object() ? texture.value("name", "") : texture.get<std::string>();
    addIf(text.starts_with('#'), FormatFeature::PlainColour);
    // "name su,sv ou,ov": each part is set off by a blank.
    const auto blanks = std::ranges::count(text, ' ');
    addIf(blanks >= 1 || texture.contains("scale"), FormatFeature::TextureScale);
    addIf(blanks >= 2 || texture.contains("offset"), FormatFeature::TextureOffset);
    addIf(texture.contains("along"), FormatFeature::TextureAlong);
    addIf(texture.contains("zref"), FormatFeature::TextureZref);
  }

  FeatureCounts& counts_;
};

json parsed(std::string_view text) { return json::parse(text, nullptr, false); }

}  // namespace

void countSpellings(std::span<const std::string_view> texts, FeatureCounts& counts) {
  SpellingCounter counter(counts);
  counter.countLevel(parsed(texts[0]));
  if (texts.size() > 1) counter.countLights(parsed(texts[1]));
}

}  // namespace hearth
