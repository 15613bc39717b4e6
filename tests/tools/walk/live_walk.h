#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <thread>

#include "desktop/disk.h"
#include "desktop/live_level.h"
#include "desktop/screenshot_files.h"
#include "settings/settings.h"
#include "stage.h"
#include "support/hall_and_cellar.h"
#include "support/in_tree.h"

namespace hearth::test {

namespace fs = std::filesystem;

inline constexpr std::chrono::seconds kPatience{60};

inline void write(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }

/// A walk on a stage, whose files may be saved meanwhile.
class LiveStage : public testing::Test {
 protected:
  void round() {
    stage_.now += 1.0 / 64;
    loop_->round();
    live_->update(*loop_, *session_, stage_);
  }

  /// Rounds until something is so, or for too long.
  bool comesTo(const std::function<bool()>& condition) {
    const auto end = std::chrono::steady_clock::now() + kPatience;
    while (!condition()) {
      if (std::chrono::steady_clock::now() > end) return false;
      round();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return true;
  }
  /// Also shows what follows.
  bool isTold(const std::string& words) {
    const bool has = comesTo([&] {
      return std::ranges::any_of(stage_.printed, [&](const std::string& line) {
        return line.find(words) != std::string::npos;
      });
    });
    stage_.printed.clear();
    round();
    return has;
  }

  OptionValues values_;
  Stage stage_;
  Disk disk_;
  std::unique_ptr<LiveLevel> live_;
  std::unique_ptr<WalkSession> session_;
  std::unique_ptr<ScreenshotFiles> screenshots_;
  std::unique_ptr<WalkLoop> loop_;
};

/// A walk through a copy of a level, on a stage.
class LiveWalk : public LiveStage {
 protected:
  LiveWalk() : folder_(fs::temp_directory_path() / fmt::format("hearth-live-{}", ::getpid())) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    for (const char* name : {"rooms.json", "rooms.lights.json"})
      fs::copy(test::inTree("tests/levels") / name, folder_);
    values_.level = (folder_ / "rooms.json").string();
    values_.set(Option::NoCache, "");
  }
  ~LiveWalk() override { fs::remove_all(folder_); }

  fs::path levelFile() const { return folder_ / "rooms.json"; }
  fs::path lightsFile() const { return folder_ / "rooms.lights.json"; }

  void begin(std::chrono::milliseconds nextFile = BackgroundBaker::kNextFile) {
    SourcedResult opened = loadLevelWithSource(levelFile());
    ASSERT_TRUE(opened.result.loaded);
    auto loaded = std::make_shared<const LoadedLevel>(*std::move(opened.result.loaded));
    auto source = std::make_shared<const LevelSource>(std::move(opened.source));
    live_ = std::make_unique<LiveLevel>(values_, loaded, source, LiveLevel::Reload::Yes, nextFile);
    const auto lit = live_->awaitFirst([] { std::this_thread::yield(); });
    ASSERT_TRUE(lit) << lit.error();
    const Player& player = *loaded->level.player;
    session_ = std::make_unique<WalkSession>(
        MovingLevel(loaded->scene()),
        walkerAt(loaded->scene(), player.sector, player.eye, player.angle, 0),
        WalkSession::Record::No);
    screenshots_ = std::make_unique<ScreenshotFiles>(folder_, "live");
    const WalkSettings settings{.options = values_, .lightsFile = loaded->lights, .canBake = true};
    loop_ = std::make_unique<WalkLoop>(loaded->scene(), (*lit)->renderer, *session_,
                                       WalkHost{stage_, disk_, *screenshots_}, settings);
    loop_->round();
  }

  bool comesToShowFresh() {
    const Image expected = fresh();
    return comesTo([&] { return stage_.shown == expected; });
  }

  /// A hall with a door in place of the level.
  void writeHall() {
    const auto json = [](std::string text) {
      std::ranges::replace(text, '\'', '"');
      return text;
    };
    write(levelFile(), json(hallAndCellarText()));
    write(lightsFile(), json(std::string(kHallLights)));
  }

  LoadedLevel load() const {
    LoadResult result = loadLevel(levelFile());
    for (const Diagnostic& diagnostic : result.diagnostics) ADD_FAILURE() << format(diagnostic);
    return *std::move(result.loaded);
  }

  /// What the files hold, loaded, baked and drawn afresh from where the walker is.
  Image fresh() const { return fresh(values_); }
  Image fresh(const OptionValues& values) const {
    const LoadedLevel loaded = load();
    const BakedLight light = bake(loaded.scene(), *bakeSettingsFor(loaded.scene(), values), 2);
    const Eye eye = session_->eye(session_->level().scene(), 1);
    return Renderer(loaded.scene(), loaded.textures, light, drawSettingsFrom(values))
        .draw({eye.sector, eye.point, eye.angle, eye.pitch, 90, stage_.window->width,
               stage_.window->height},
              LightMode::Both);
  }

  LoadedLevel loadAt(std::span<const double> shares) const {
    const SourcedResult sourced = loadLevelWithSource(levelFile());
    return *levelAt(*sourced.result.loaded, sourced.source, shares).loaded;
  }

  /// What `fresh` draws of the level with its movers at some shares, in light of its own.
  Image freshAt(const LoadedLevel& moved, const BakedLight& light) const {
    const Eye eye = eyeOf(moved.scene(), session_->walker());
    return Renderer(moved.scene(), moved.textures, light)
        .draw({eye.sector, eye.point, eye.angle, eye.pitch, 90, stage_.window->width,
               stage_.window->height},
              LightMode::Both);
  }

  /// Paints all floors that have a texture.
  void paintFloors(const std::string& texture);
  /// One room instead of all.
  void writeRoom(const std::string& name, double floor);

  fs::path folder_;
};

}  // namespace hearth::test
