// Where the files have what is pointed at.

#include "viewer/inspect/places.h"

#include <gtest/gtest.h>

#include <string>

#include "loaded.h"
#include "support/level_text.h"

namespace hearth {
namespace {

constexpr std::string_view kLevel = R"({ 'light': 0, 'sectors': {
 'low': { 'floor': {'texture': '#000001'}, 'ceiling': {'z': 4, 'texture': '#000002'}, 'loops': {
  'border': { 'v': [0,0, 4,0, 4,4, 0,4], 'walls': [
   {'texture': '#000003'},
   {'walls': [
     {'z': 1, 'texture': '#000004'},
     {'next': 'high', 'lower': {'name': '#000005'}, 'upper': '#000006'}]},
   {'texture': '#000007'},
   {'next': 'ramp'}]}}},
 'high': { 'floor': {'z': 2, 'texture': '#000008'}, 'ceiling': {'z': 3, 'texture': '#000009'}, 'loops': {
  'border': { 'v': [4,0, 8,0, 8,4, 4,4], 'walls': [
   {'texture': '#00000a'}, {'texture': '#00000b'}, {'texture': '#00000c'},
   {'next': 'low', 'middle': '#00000d'}]}}},
 'ramp': { 'floor': {'texture': '#00000e'}, 'ceiling': {'texture': '#00000f'},
  'slopeFloor': {'z': [2,1,1,2], 'sidewall': '#000010'}, 'loops': {
  'border': { 'v': [-4,0, 0,0, 0,4, -4,4], 'walls': [
   {'texture': '#000011'}, {'next': 'low'}, {'texture': '#000012'}, {'texture': '#000013'}]}}}
}})";

class PlacesTest : public testing::Test {
 protected:
  const Level& level() const { return sourced_.result.loaded->level; }
  TruthHit hit(const std::string& sector, Vec3 eye, Vec3 direction) const {
    return *trace(level(), sectorNamed(level(), sector), eye, direction, RayKind::Look);
  }
  /// Without the file's folder.
  static std::string inFile(const std::string& place) {
    return place.substr(place.rfind('/', place.find(' ')) + 1);
  }
  std::string surface(const TruthHit& at) const {
    return inFile(placeOfSurface(sourced_.source, level(), at));
  }
  std::string texture(const TruthHit& at) const {
    return inFile(placeOfTexture(sourced_.source, level(), at));
  }

  SourcedResult sourced_ =
      test::levelWithSourceFrom(kLevel, "[\n{'x':1,'y':1,'z':1},\n{'x':2,'y':1,'z':1}]");
};

TEST_F(PlacesTest, AreThoseOfWallsAndPartsOfStacks) {
  const TruthHit solid = hit("low", {2, 2, 0.5}, {1, 0, 0});
  EXPECT_EQ(surface(solid), "level.json:6 /sectors/low/loops/border/walls/1/walls/0");
  EXPECT_EQ(texture(solid), "level.json:6 /sectors/low/loops/border/walls/1/walls/0/texture");
  const TruthHit lower = hit("low", {2, 2, 1.5}, {1, 0, 0});
  EXPECT_EQ(surface(lower), "level.json:7 /sectors/low/loops/border/walls/1/walls/1");
  EXPECT_EQ(texture(lower), "level.json:7 /sectors/low/loops/border/walls/1/walls/1/lower/name");
  const TruthHit upper = hit("low", {2, 2, 3.5}, {1, 0, 0});
  EXPECT_EQ(texture(upper), "level.json:7 /sectors/low/loops/border/walls/1/walls/1/upper");
  const TruthHit middle = hit("high", {6, 2, 2.5}, {-1, 0, 0});
  EXPECT_EQ(texture(middle), "level.json:13 /sectors/high/loops/border/walls/3/middle");
}

TEST_F(PlacesTest, AreThoseOfFlatsAndSlopes) {
  const TruthHit ceiling = hit("low", {2, 2, 1}, {0, 0, 1});
  EXPECT_EQ(texture(ceiling), "level.json:2 /sectors/low/ceiling/texture");
  const TruthHit slope = hit("ramp", {-2, 2, 3}, {0, 0, -1});
  EXPECT_EQ(surface(slope), "level.json:15 /sectors/ramp/slopeFloor/z");
  EXPECT_EQ(texture(slope), "level.json:14 /sectors/ramp/floor/texture");
  const TruthHit sidewall = hit("low", {2, 2, 0.5}, {-1, 0, 0});
  EXPECT_EQ(surface(sidewall), "level.json:15 /sectors/ramp/slopeFloor/z");
  EXPECT_EQ(texture(sidewall), "level.json:15 /sectors/ramp/slopeFloor/sidewall");
}

TEST_F(PlacesTest, AreThoseOfSectorsAndLights) {
  EXPECT_EQ(inFile(placeOfSector(sourced_.source, sectorNamed(level(), "high"))),
            "level.json:10 /sectors/high");
  EXPECT_EQ(inFile(placeOfLight(sourced_.source, 1)), "level.lights.json:3 /1");
}

}  // namespace
}  // namespace hearth
