#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "light/rebake.h"
#include "load/load.h"
#include "random_levels/random_level.h"
#include "same_bakes.h"

namespace hearth {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kThreads = 2;

/// A number of the sequence that an author's whims follow: the same on every machine.
class Whims {
 public:
  explicit Whims(std::uint64_t seed) : state_(seed) {}

  std::size_t below(std::size_t count) {
    // Knuth's MMIX generator; the upper bits are the better ones.
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return (state_ >> 33) % count;
  }
  double numberBelow(std::size_t count) { return static_cast<double>(below(count)); }

 private:
  std::uint64_t state_;
};

/// All numbers of a JSON value under a key of some name.
void collect(Json& value, const std::string& key, std::vector<Json*>& found) {
  if (!value.is_structured()) return;
  for (auto& [name, member] : value.items()) {
    if (name == key && (member.is_number() || key == "v")) found.push_back(&member);
    collect(member, key, found);
  }
}

/// The files of a level that is being edited.
class Draft {
 public:
  explicit Draft(std::uint64_t seed)
      : folder_(std::filesystem::temp_directory_path() /
                fmt::format("hearth-rebake-{}", ::getpid())),
        whims_(seed) {
    const RandomLevel random = makeRandomLevel(seed);
    level_ = Json::parse(random.levelJson);
    lights_ = Json::parse(random.lightsJson);
    name_ = random.name;
    mayShine_ = seed % 4 == 0;
    EXPECT_TRUE(writeRandomLevelTextures(folder_ / "textures"));
  }
  ~Draft() { std::filesystem::remove_all(folder_); }
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;

  /// What is in the files now; none where that is no level.
  std::optional<LoadedLevel> load() const {
    std::ofstream(folder_ / (name_ + ".json")) << level_;
    std::ofstream(folder_ / (name_ + ".lights.json")) << lights_;
    return loadLevel(folder_ / (name_ + ".json")).loaded;
  }

  /// Changes something, and gives the level that it has become.
  LoadedLevel edited() {
    while (true) {
      const auto before = std::pair(level_, lights_);
      edit();
      if (before != std::pair(level_, lights_))
        if (auto loaded = load()) return *std::move(loaded);
      std::tie(level_, lights_) = before;  // legal levels only
    }
  }

 private:
  void edit() {
    switch (whims_.below(12)) {
      case 0:
        return moveVertex();
      case 1:
      case 2:
        return moveHeight();
      case 3:
        return changeLight("intensity", 60.0 + 20.0 * whims_.numberBelow(10));
      case 4:
        return changeLight("color", whims_.below(2) ? "#ff8040" : "#ffffff");
      case 5:
        return changeLight("radius", 0.1 * whims_.numberBelow(3));
      case 6:
        return turnLight();
      case 7:
        return moveLight();
      case 8:
        return turnSun();
      case 9:
        return changeSky();
      case 10:
        return changeEmitter();
      default:
        return addOrDropLight();
    }
  }

  double nudge() { return 0.125 * (whims_.numberBelow(9) - 4); }

  /// In all sectors that have it.
  void moveVertex() {
    std::vector<Json*> outlines;
    collect(level_["sectors"], "v", outlines);
    const Json& outline = *outlines[whims_.below(outlines.size())];
    const std::size_t at = 2 * whims_.below(outline.size() / 2);
    const Json x = outline[at];
    const Json y = outline[at + 1];
    const double newX = x.get<double>() + nudge();
    const double newY = y.get<double>() + nudge();
    for (Json* other : outlines)
      for (std::size_t i = 0; i + 1 < other->size(); i += 2)
        if ((*other)[i] == x && (*other)[i + 1] == y) {
          (*other)[i] = newX;
          (*other)[i + 1] = newY;
        }
  }

  void moveHeight() {
    std::vector<Json*> heights;
    collect(level_["sectors"], "z", heights);
    Json& height = *heights[whims_.below(heights.size())];
    height = height.get<double>() + nudge();
  }

  Json& lightList() { return lights_.contains("lights") ? lights_["lights"] : lights_; }
  Json* anyLight() {
    Json& list = lightList();
    return list.empty() ? nullptr : &list[whims_.below(list.size())];
  }

  void changeLight(const char* key, const Json& value) {
    if (Json* light = anyLight()) (*light)[key] = value;
  }

  void moveLight() {
    if (Json* light = anyLight())
      for (const char* axis : {"x", "y", "z"})
        if (light->contains(axis)) (*light)[axis] = (*light)[axis].get<double>() + nudge();
  }

  /// A light of all around becomes a spot.
  void turnLight() {
    Json* light = anyLight();
    if (!light) return;
    Json& spot = (*light)["spot"];
    if (spot.is_null()) spot = {{"inner", 20}, {"outer", 60}};
    spot["angle"] = 45.0 * whims_.numberBelow(8);
    spot["pitch"] = 45.0 * (whims_.numberBelow(5) - 2);
  }

  /// Of a level that has none it rises. An array of lights has no suns.
  void turnSun() {
    if (!lights_.contains("lights")) return;
    Json& suns = lights_["suns"];
    if (suns.empty()) suns = Json::array({Json::object()});
    suns[0]["angle"] = 15 * whims_.numberBelow(24);
    suns[0]["pitch"] = 1 + 11 * whims_.numberBelow(9);
    suns[0]["size"] = whims_.below(3) == 0 ? 6 : 0;
  }

  void changeSky() {
    if (!lights_.contains("lights")) return;
    lights_["sky"]["intensity"] = 50.0 * whims_.numberBelow(4);
    if (whims_.below(2)) lights_["sky"]["color"] = "#a0c0ff";
  }

  /// In some levels: areas are found together, so each such edit asks for the sky, too.
  void changeEmitter() {
    if (!lights_.contains("lights") || !mayShine_) return;
    const std::string texture(kRandomLevelTextures[whims_.below(2)].name);
    lights_["emit"][texture]["intensity"] = 60.0 * whims_.numberBelow(4);
  }

  void addOrDropLight() {
    Json& list = lightList();
    if (whims_.below(2) && list.size() > 1)
      list.erase(whims_.below(list.size()));
    else if (Json* light = anyLight())
      list.insert(list.begin(), Json(*light));
  }

  std::filesystem::path folder_;
  Whims whims_;
  bool mayShine_;
  std::string name_;
  Json level_;
  Json lights_;
};

/// In every way of sampling; of many rays to a ball, which take their time, few.
BakeSettings settingsFor(const Level& level, std::uint64_t seed) {
  BakeSettings settings = level.bake;
  settings.softSamples = 4;
  if (seed % 3 == 0) settings.samples.reset();
  return settings;
}

std::int64_t allTexelLights(const Scene& scene, const BakeSettings& settings) {
  LightMemory none;
  return Rebake(none, scene, settings, kThreads).texelLightsLeft();
}

TEST(Rebake, IsTheFullBakeAfterEachOfManyEdits) {
  std::int64_t left = 0;
  std::int64_t all = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Draft draft(seed);
    LightMemory memory;
    for (int edit = 0; edit < 20; ++edit) {
      SCOPED_TRACE(fmt::format("level {}, edit {}", seed, edit));
      const LoadedLevel loaded = draft.edited();
      const Scene scene = loaded.scene();
      const BakeSettings settings = settingsFor(loaded.level, seed);
      Rebake rebake(memory, scene, settings, kThreads);
      left += rebake.texelLightsLeft();
      all += allTexelLights(scene, settings);
      const auto light = rebake.finish();
      ASSERT_TRUE(light);
      test::expectSame(scene, *light, bake(scene, settings, kThreads));
      if (HasFailure()) return;
    }
  }
  fmt::print("asked for {} of {} texel-lights\n", left, all);
  EXPECT_LT(left, all / 2);
}

}  // namespace
}  // namespace hearth
