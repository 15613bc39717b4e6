// The text of a lights file as single edits change it, to the byte.

#include "viewer/edit/lights_edit.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace hearth {
namespace {

LightsEdit opened(std::string_view text) {
  auto edit = LightsEdit::open(text, "lights.json");
  if (edit) return *std::move(edit);
  ADD_FAILURE() << edit.error();
  return *LightsEdit::open("[]", "");
}

LightDescription lightAt(Vec3 position) {
  LightDescription light;
  light.source.position = position;
  return light;
}

/// The text after one edit, having seen that it can be undone and redone.
template <typename Edit>
std::string after(std::string_view text, Edit&& edit) {
  LightsEdit lights = opened(text);
  const auto mistake = edit(lights);
  EXPECT_FALSE(mistake) << mistake.value_or("");
  std::string last = lights.bytes();
  if (!lights.canUndo()) return last;
  lights.undo();
  EXPECT_EQ(lights.bytes(), text);
  EXPECT_FALSE(lights.canUndo()) << "an edit is one step";
  lights.redo();
  EXPECT_EQ(lights.bytes(), last);
  return last;
}

template <typename Change>
std::string afterChange(std::string_view text, std::size_t light, Change&& change) {
  return after(text, [&](LightsEdit& lights) {
    LightDescription to = lights.lights().at(light);
    change(to);
    return lights.set(light, to);
  });
}

std::string afterAdd(std::string_view text, const LightDescription& light) {
  return after(text, [&](LightsEdit& lights) { return lights.add(light); });
}

std::string afterRemove(std::string_view text, std::size_t light) {
  return after(text, [&](LightsEdit& lights) { return lights.remove(light); });
}

TEST(LightsEditTest, ChangesOnlyTheNumberThatChanged) {
  EXPECT_EQ(afterChange(R"([ {"x" : 1.50 ,"y":1e1, "z":2.0,"$note":[1,{"x":7}]} ])", 0,
                        [](LightDescription& light) { light.source.position.y = -0.125; }),
            R"([ {"x" : 1.50 ,"y":-0.125, "z":2.0,"$note":[1,{"x":7}]} ])");
}

TEST(LightsEditTest, LeavesTheSpellingOfWhatIsTheSame) {
  const std::string text = R"([{"x":1.50,"y":1e1,"z":-0,"color":"#FFffFF"}])";
  EXPECT_EQ(afterChange(text, 0,
                        [](LightDescription& light) {
                          light.source.position = {1.5, 10, 0};
                          light.source.intensity = 255;  // which it is by default
                        }),
            text);
}

TEST(LightsEditTest, AddsAKeyInTheMannerOfTheOthers) {
  const auto brighten = [](LightDescription& light) {
    light.source.intensity = 90;
    light.source.color[1] = 16;
  };
  EXPECT_EQ(afterChange(R"([{"x":1,"y":2,"z":3}])", 0, brighten),
            R"([{"x":1,"y":2,"z":3,"intensity":90,"color":"#ff10ff"}])");
  EXPECT_EQ(afterChange("[\r\n  {\r\n    \"z\" : 1,\r\n    \"y\" : 2,\r\n    \"x\" : 3,\r\n"
                        "    \"//\" : \"lamp\"\r\n  }\r\n]\r\n",
                        0, brighten),
            "[\r\n  {\r\n    \"z\" : 1,\r\n    \"y\" : 2,\r\n    \"x\" : 3,\r\n"
            "    \"intensity\" : 90,\r\n    \"color\" : \"#ff10ff\",\r\n"
            "    \"//\" : \"lamp\"\r\n  }\r\n]\r\n");
}

TEST(LightsEditTest, FindsKeysThatAreSpelledWithEscapes) {
  EXPECT_EQ(afterChange(R"([{"\u0078":1,"y":2,"z":3}])", 0,
                        [](LightDescription& light) { light.source.position.x = 5; }),
            R"([{"\u0078":5,"y":2,"z":3}])");
}

TEST(LightsEditTest, NamesSectorsAndForgetsThem) {
  EXPECT_EQ(afterChange(R"([{"x":1,"y":2,"z":3}])", 0,
                        [](LightDescription& light) {
                          light.sector = NameReference{"a \"b\"", {}};
                        }),
            R"([{"x":1,"y":2,"z":3,"sector":"a \"b\""}])");
  const auto forget = [](LightDescription& light) { light.sector.reset(); };
  EXPECT_EQ(afterChange(R"([{"x":1,"y":2, "z":3, "sector":"a" }])", 0, forget),
            R"([{"x":1,"y":2, "z":3 }])");
  EXPECT_EQ(afterChange(R"([{"sector":"a", "x":1,"y":2, "z":3}])", 0, forget),
            R"([{"x":1,"y":2, "z":3}])");
}

TEST(LightsEditTest, WritesCurvesAndPutsIntensityInTheirPlace) {
  const std::string text = R"([{"x":1,"y":2,"z":3,"curve":[ [0,9], [4.0,1] ],"radius":1}])";
  EXPECT_EQ(
      afterChange(text, 0, [](LightDescription& light) { light.source.curve[1].level = 2.5; }),
      R"([{"x":1,"y":2,"z":3,"curve":[[0, 9], [4, 2.5]],"radius":1}])");
  EXPECT_EQ(afterChange(text, 0,
                        [](LightDescription& light) {
                          light.source.curve.clear();
                          light.source.intensity = 9;
                        }),
            R"([{"x":1,"y":2,"z":3,"radius":1,"intensity":9}])");
}

TEST(LightsEditTest, ChangesOneNumberOfASpot) {
  const auto turn = [](LightDescription& light) { light.source.spot = Spot(90, -60, 20, 30); };
  EXPECT_EQ(afterChange(R"([{"x":1,"y":2,"z":3,"spot":{ "//":"lamp", "pitch":-6e1, "inner":2e1,)"
                        R"( "outer":30, "angle":45 }}])",
                        0, turn),
            R"([{"x":1,"y":2,"z":3,"spot":{ "//":"lamp", "pitch":-6e1, "inner":2e1,)"
            R"( "outer":30, "angle":90 }}])");
  EXPECT_EQ(afterChange(R"([{"x":1,"y":2,"z":3,"spot":{"outer":30}}])", 0, turn),
            R"([{"x":1,"y":2,"z":3,"spot":{"outer":30, "angle": 90, "pitch": -60, "inner": 20}}])");
}

TEST(LightsEditTest, MakesASpotAndTakesItOut) {
  const std::string all = R"([{"x":1,"y":2,"z":3}])";
  const std::string cone =
      R"([{"x":1,"y":2,"z":3,"spot":{"angle": 0, "pitch": -90, "inner": 20, "outer": 40.5}}])";
  EXPECT_EQ(
      afterChange(all, 0,
                  [](LightDescription& light) { light.source.spot = Spot(0, -90, 20, 40.5); }),
      cone);
  EXPECT_EQ(afterChange(cone, 0, [](LightDescription& light) { light.source.spot.reset(); }), all);
}

LightDescription sunAt(double angle, double pitch) {
  LightDescription sun;
  sun.source.sun.emplace(angle, pitch, 0);
  return sun;
}

TEST(LightsEditTest, ChangesASunWhichComesAfterTheLights) {
  const std::string text =
      R"({"lights":[{"x":1,"y":2,"z":3}],"suns":[{"angle":10,"pitch":4.50,"size":1}]})";
  EXPECT_EQ(afterChange(text, 1,
                        [](LightDescription& sun) {
                          sun.source.sun.emplace(12.5, 4.5, 2);
                          sun.source.intensity = 90;
                        }),
            R"({"lights":[{"x":1,"y":2,"z":3}],)"
            R"("suns":[{"angle":12.5,"pitch":4.50,"intensity":90,"size":2}]})");
  EXPECT_EQ(afterRemove(text, 1), R"({"lights":[{"x":1,"y":2,"z":3}],"suns":[]})");
}

TEST(LightsEditTest, AddsASunAndTheirListWhereThereIsNone) {
  EXPECT_EQ(afterAdd(R"({"lights":[],"suns":[{"pitch":5,"angle":1}]})", sunAt(-30, 45)),
            R"({"lights":[],"suns":[{"pitch":5,"angle":1},{"angle":-30,"pitch":45}]})");
  EXPECT_EQ(afterAdd(R"({"version":1,"lights":[],"bake":{}})", sunAt(0, 90)),
            R"({"version":1,"lights":[],"suns":[{"angle":0,"pitch":90}],"bake":{}})");
  EXPECT_EQ(afterAdd(R"({"lights": []})", sunAt(0, 90)),
            R"({"lights": [], "suns": [{ "angle": 0, "pitch": 90 }]})");
}

LightDescription skyOf(double intensity) {
  LightDescription sky;
  sky.source.isSky = true;
  sky.source.intensity = intensity;
  return sky;
}

TEST(LightsEditTest, ChangesTheSkyWhichComesLast) {
  const std::string text =
      R"({"lights":[],"suns":[{"angle":1,"pitch":5}],"sky":{"intensity":50},"bake":{}})";
  EXPECT_EQ(afterChange(text, 1,
                        [](LightDescription& sky) {
                          sky.source.intensity = 75;
                          sky.source.color[0] = 0;
                        }),
            R"({"lights":[],"suns":[{"angle":1,"pitch":5}],)"
            R"("sky":{"intensity":75, "color":"#00ffff"},"bake":{}})");
  EXPECT_EQ(afterRemove(text, 1), R"({"lights":[],"suns":[{"angle":1,"pitch":5}],"bake":{}})");
}

TEST(LightsEditTest, KeepsASkyThatHasBecomeDark) {
  EXPECT_EQ(afterChange(R"({"lights":[],"sky":{"intensity":50}})", 0,
                        [](LightDescription& sky) { sky.source.intensity = 0; }),
            R"({"lights":[],"sky":{"intensity":0}})");
}

/// Which other lights never are.
TEST(LightsEditTest, ChangesASkyThatSaysLittle) {
  const auto brightened = [](LightDescription& sky) { sky.source.intensity = 9; };
  EXPECT_EQ(afterChange(R"({"lights":[],"sky":{}})", 0, brightened),
            R"({"lights":[],"sky":{"intensity": 9}})");
  EXPECT_EQ(afterChange(R"({"lights":[],"sky":{"color":"#00ff00"}})", 0, brightened),
            R"({"lights":[],"sky":{"intensity":9, "color":"#00ff00"}})");
  for (const auto& [before, after] :
       {std::pair(R"({"lights":[],"sky":{}})", R"({"lights":[],"sky":{"//": "dusk"}})"),
        std::pair(R"({"lights":[],"sky":{"intensity":9}})",
                  R"({"lights":[],"sky":{"//":"dusk", "intensity":9}})")}) {
    LightsEdit lights = opened(before);
    EXPECT_FALSE(lights.setComment(0, "dusk"));
    EXPECT_EQ(lights.bytes(), after);
    EXPECT_EQ(lights.commentOf(0), "dusk");
  }
}

TEST(LightsEditTest, AddsTheSkyWhereThereIsNone) {
  EXPECT_EQ(afterAdd(R"({"version":1,"lights":[],"suns":[],"bake":{}})", skyOf(100)),
            R"({"version":1,"lights":[],"suns":[],"sky":{ "intensity": 100 },"bake":{}})");
  EXPECT_EQ(afterAdd(R"({"lights": []})", skyOf(100)),
            R"({"lights": [], "sky": { "intensity": 100 }})");
  LightsEdit lights = opened("[]");
  EXPECT_EQ(lights.add(skyOf(100)),
            "the file is an array of lights: write { \"lights\": [...] } to give it a sky");
  EXPECT_EQ(lights.bytes(), "[]");
}

LightDescription emitterOf(const std::string& texture) {
  LightDescription emitter;
  emitter.source.texture = texture;
  emitter.source.intensity = 150;
  return emitter;
}

TEST(LightsEditTest, ChangesAndRemovesEmittersByTheirTextures) {
  const std::string text =
      R"({"lights":[],"sky":{},"emit":{"lava":{"intensity":50},"// glow":"","lamp":{}}})";
  EXPECT_EQ(afterChange(text, 1, [](LightDescription& lava) { lava.source.intensity = 75; }),
            R"({"lights":[],"sky":{},"emit":{"lava":{"intensity":75},"// glow":"","lamp":{}}})");
  EXPECT_EQ(afterChange(text, 2, [](LightDescription& lamp) { lamp.source.color[2] = 0; }),
            R"({"lights":[],"sky":{},"emit":{"lava":{"intensity":50},"// glow":"",)"
            R"("lamp":{"color": "#ffff00"}}})");
  EXPECT_EQ(afterRemove(text, 1), R"({"lights":[],"sky":{},"emit":{"// glow":"","lamp":{}}})");
}

TEST(LightsEditTest, AddsEmittersBehindTheOthers) {
  EXPECT_EQ(afterAdd(R"({"lights": [], "bake": {}})", emitterOf("lava")),
            R"({"lights": [], "emit": { "lava": { "intensity": 150 } }, "bake": {}})");
  EXPECT_EQ(afterAdd(R"({"lights":[],"emit":{"lamp":{}}})", emitterOf("say \"ah\"")),
            R"({"lights":[],"emit":{"lamp":{}, "say \"ah\"":{ "intensity": 150 }}})");
  EXPECT_EQ(afterAdd(R"({"lights":[],"emit":{}})", emitterOf("lava")),
            R"({"lights":[],"emit":{"lava": { "intensity": 150 }}})");
  LightsEdit lights = opened(R"({"lights":[],"emit":{"lava":{}}})");
  EXPECT_EQ(lights.add(emitterOf("lava")), "\"lava\" shines already");
  EXPECT_FALSE(lights.canUndo());
}

TEST(LightsEditTest, RefusesASunInAnArrayOfLights) {
  LightsEdit lights = opened("[]");
  EXPECT_EQ(lights.add(sunAt(0, 90)),
            "the file is an array of lights: write { \"lights\": [...] } to give it suns");
  EXPECT_EQ(lights.bytes(), "[]");
  EXPECT_FALSE(lights.canUndo());
}

TEST(LightsEditTest, AddsALightLikeTheLast) {
  EXPECT_EQ(afterAdd(R"([{"x":1,"y":2,"z":3}])", lightAt({4, 5.125, 1e-3})),
            R"([{"x":1,"y":2,"z":3},{"x":4,"y":5.125,"z":0.001}])");
  EXPECT_EQ(afterAdd("{ \"lights\": [\n  { \"//\": \"a\",\n    \"x\": 1, \"y\": 2, \"z\": 3 },\n\n"
                     "  { \"x\": 1, \"y\": 2, \"z\": 3, \"radius\": 1 }\n] }\n",
                     lightAt({4, 5, 6})),
            "{ \"lights\": [\n  { \"//\": \"a\",\n    \"x\": 1, \"y\": 2, \"z\": 3 },\n\n"
            "  { \"x\": 1, \"y\": 2, \"z\": 3, \"radius\": 1 },\n"
            "  { \"x\": 4, \"y\": 5, \"z\": 6 }\n] }\n");
}

TEST(LightsEditTest, WritesOfAnAddedLightWhatIsNotByDefault) {
  LightDescription light = lightAt({1, 2, 3});
  light.source.falloff = 0.5;
  EXPECT_EQ(afterAdd("[]", light), R"([{"x":1,"y":2,"z":3,"falloff":0.5}])");
}

TEST(LightsEditTest, AddsTheFirstLightInTheMannerOfTheText) {
  const LightDescription light = lightAt({1, 2, 3});
  EXPECT_EQ(afterAdd("[ ]", light), R"([{ "x": 1, "y": 2, "z": 3 }])");
  EXPECT_EQ(afterAdd("[\n]\n", light), "[\n  { \"x\": 1, \"y\": 2, \"z\": 3 }\n]\n");
  EXPECT_EQ(afterAdd("{\r\n\t\"lights\": []\r\n}", light),
            "{\r\n\t\"lights\": [\r\n\t\t{ \"x\": 1, \"y\": 2, \"z\": 3 }\r\n\t]\r\n}");
}

TEST(LightsEditTest, RemovesALightWithOneComma) {
  const std::string text =
      "[\n  {\"x\":1,\"y\":1,\"z\":1},\n  {\"x\":2,\"y\":2,\"z\":2} ,\n  "
      "{\"x\":3,\"y\":3,\"z\":3}\n]";
  EXPECT_EQ(afterRemove(text, 0),
            "[\n  {\"x\":2,\"y\":2,\"z\":2} ,\n  {\"x\":3,\"y\":3,\"z\":3}\n]");
  EXPECT_EQ(afterRemove(text, 1),
            "[\n  {\"x\":1,\"y\":1,\"z\":1},\n  {\"x\":3,\"y\":3,\"z\":3}\n]");
  EXPECT_EQ(afterRemove(text, 2),
            "[\n  {\"x\":1,\"y\":1,\"z\":1},\n  {\"x\":2,\"y\":2,\"z\":2}\n]");
  EXPECT_EQ(afterRemove("[\n  {\"x\":1,\"y\":1,\"z\":1}\n]\n", 0), "[]\n");
}

TEST(LightsEditTest, KeepsAByteOrderMark) {
  EXPECT_EQ(afterRemove("\xEF\xBB\xBF[{\"x\":1,\"y\":1,\"z\":1}]", 0), "\xEF\xBB\xBF[]");
}

TEST(LightsEditTest, KeepsEditsThatAreRefusedOut) {
  const std::string text = R"([{"x":1,"y":2,"z":3}])";
  LightsEdit lights = opened(text);
  LightDescription light = lights.lights().lights[0];
  light.source.radius = -1;
  const auto mistake = lights.set(0, light);
  ASSERT_TRUE(mistake);
  EXPECT_NE(mistake->find("lights.json:1:30: error: "), std::string::npos) << *mistake;
  EXPECT_EQ(lights.bytes(), text);
  EXPECT_EQ(lights.lights().lights[0].source.radius, 0);
  EXPECT_FALSE(lights.canUndo());
}

TEST(LightsEditTest, MakesOneStepOfADrag) {
  const std::string text = R"([{"x":1.0,"y":2.0,"z":3}])";
  LightsEdit lights = opened(text);
  const auto move = [&](double x, double y) {
    LightDescription light = lights.lights().lights[0];
    light.source.position.x = x;
    light.source.position.y = y;
    EXPECT_FALSE(lights.set(0, light));
  };
  lights.beginDrag();
  move(1.5, 2.5);
  EXPECT_FALSE(lights.canUndo());
  move(1.75, 2);
  lights.endDrag();
  EXPECT_EQ(lights.bytes(), R"([{"x":1.75,"y":2.0,"z":3}])") << "y is spelled as it was";
  lights.undo();
  EXPECT_EQ(lights.bytes(), text);
  EXPECT_FALSE(lights.canUndo());

  lights.beginDrag();
  move(4, 4);
  move(1, 2);
  lights.endDrag();
  EXPECT_EQ(lights.bytes(), text);
  EXPECT_FALSE(lights.canUndo()) << "a drag that came back is no step";
}

TEST(LightsEditTest, ForgetsWhatWasUndoneAfterAnotherEdit) {
  LightsEdit lights = opened("[]");
  EXPECT_FALSE(lights.add(lightAt({1, 1, 1})));
  lights.undo();
  EXPECT_TRUE(lights.canRedo());
  EXPECT_FALSE(lights.add(lightAt({2, 2, 2})));
  EXPECT_FALSE(lights.canRedo());
}

TEST(LightsEditTest, OpensNoTextWithMistakes) {
  const auto broken = LightsEdit::open("[\n{\"x\":1}]", "my.json");
  ASSERT_FALSE(broken);
  EXPECT_TRUE(broken.error().starts_with("my.json:2:1: error: ")) << broken.error();
  EXPECT_FALSE(LightsEdit::open("[", "my.json"));
  EXPECT_FALSE(LightsEdit::open("{\"sectors\":{}}", "my.json"));
}

TEST(LightsEditTest, HasTheCommentOfALight) {
  const LightsEdit lights = opened(
      R"([{"//":"lamp, \"A\"","x":1,"y":1,"z":1},{"x":1,"y":1,"z":1,"//":2},{"x":1,"y":1,"z":1}])");
  EXPECT_EQ(lights.commentOf(0), "lamp, \"A\"");
  EXPECT_EQ(lights.commentOf(1), "");
  EXPECT_EQ(lights.commentOf(2), "");
}

std::string afterComment(std::string_view text, const std::string& comment) {
  return after(text, [&](LightsEdit& lights) { return lights.setComment(0, comment); });
}

TEST(LightsEditTest, WritesAndTakesOutComments) {
  EXPECT_EQ(afterComment(R"([{ "x": 1, "//0" :2, "//1": "old", "y": 1, "z": 1 }])", "a \"b\""),
            R"([{ "x": 1, "//0" :2, "//1": "a \"b\"", "y": 1, "z": 1 }])");
  EXPECT_EQ(afterComment("[\n{\"z\" :1,\n \"y\":2, \"x\":3}]", "new"),
            "[\n{\"//\":\"new\",\n \"z\" :1,\n \"y\":2, \"x\":3}]");
  EXPECT_EQ(afterComment(R"([{"//":"a","x":1,"y":1,"z":1}])", ""), R"([{"x":1,"y":1,"z":1}])");
  EXPECT_EQ(afterComment(R"([{"x":1,"y":1,"z":1}])", ""), R"([{"x":1,"y":1,"z":1}])");
}

TEST(LightsEditTest, AddsALightWithItsComment) {
  EXPECT_EQ(after(R"([{"x":1,"y":2,"z":3}])",
                  [](LightsEdit& lights) {
                    return lights.add(lightAt({4, 5, 6}), "in a hall");
                  }),
            R"([{"x":1,"y":2,"z":3},{"//":"in a hall","x":4,"y":5,"z":6}])");
}

TEST(LightsEditTest, PutsACurveInPlaceOfIntensityAndFalloff) {
  EXPECT_EQ(afterChange(R"([{"x":1,"y":2,"z":3,"falloff":1,"radius":1}])", 0,
                        [](LightDescription& light) {
                          light.source.curve = {{0, 9}};
                        }),
            R"([{"x":1,"y":2,"z":3,"radius":1,"curve":[[0, 9]]}])");
}

TEST(LightName, HasTheNumberAndTheComment) {
  LightSource light;
  EXPECT_EQ(lightName(3, light, "lamp posts"), "3 lamp posts");
  EXPECT_EQ(lightName(3, light, ""), "light 3");
  light.sun.emplace(0, 45, 0);
  EXPECT_EQ(lightName(4, light, ""), "sun 4");
  EXPECT_EQ(lightName(5, skyOf(100).source, ""), "sky");
  EXPECT_EQ(lightName(6, emitterOf("lava").source, ""), "emitter lava");
}

TEST(LightsEditTest, RoundsToMillimetres) {
  EXPECT_EQ(toMillimetres(1.23456), 1.235);
  EXPECT_EQ(toMillimetres(-0.0004), 0);
}

}  // namespace
}  // namespace hearth
