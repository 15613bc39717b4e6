#pragma once

#include <gtest/gtest.h>

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "desktop/disk.h"
#include "desktop/screenshot_files.h"
#include "light/bakery.h"
#include "loaded.h"
#include "stage.h"
#include "viewer/walk/walk_loop.h"

namespace hearth::test {

/// A level with its light.
struct Place {
  explicit Place(const std::string& path) : Place(hearth::loaded(path)) {}
  explicit Place(LoadedLevel level)
      : loaded(std::move(level)), light(bake(loaded.scene(), loaded.level.bake, 2)) {}

  LoadedLevel loaded;
  BakedLight light;
};

inline const Place& rooms() {
  static const Place place("tests/levels/rooms.json");
  return place;
}

/// One walk on a stage, from where the level's player stands.
class StagedWalk {
 public:
  explicit StagedWalk(const WalkSettings& settings = {}, const Place& place = rooms(),
                      WalkSession::Record record = WalkSession::Record::Yes,
                      Workers* workers = nullptr)
      : place_(place),
        renderer_(place.loaded.scene(), place.loaded.textures, place.light),
        start_(walkerAt(scene(), level().player->sector, level().player->eye, level().player->angle,
                        0)),
        session_(MovingLevel(scene()), start_, record),
        screenshots_(testing::TempDir(), "walk"),
        settings_(settings),
        loop_(scene(), renderer_, session_, {stage, disk_, screenshots_, workers}, settings) {
    isOn = loop_.round();  // starts the clock
  }

  /// Rounds of `seconds` each.
  void go(int rounds, double seconds) {
    for (int i = 0; i < rounds && isOn; ++i) {
      stage.now += seconds;
      isOn = loop_.round();
    }
  }
  /// Ticks, one in each round.
  void ticks(int count) { go(count, 1.0 / kTicksPerSecond); }
  /// A round in which no time passes.
  void now() { go(1, 0); }
  void now(const Event& event) {
    stage.events.push_back(event);
    now();
  }

  /// What `hearth shot` would draw where the walker was a tick ago.
  Image drawn(LightMode mode, ImageSize size) const {
    const Eye eye = session_.eye(scene(), 0);
    return renderer_.draw(
        {eye.sector, eye.point, eye.angle, eye.pitch, settings_.fov, size.width, size.height},
        mode);
  }

  const Level& level() const { return place_.loaded.level; }
  Scene scene() const { return place_.loaded.scene(); }
  const Walker& start() const { return start_; }
  const Walker& walker() const { return session_.walker(); }
  const std::vector<WalkInput>& inputs() const { return session_.inputs(); }
  std::span<const double> shares() const { return session_.level().shares(); }
  WalkLoop& loop() { return loop_; }
  /// Goes on in another version of the level, at the same place.
  void continueIn(const Place& place, const Renderer& renderer) {
    session_.continueIn(MovingLevel(place.loaded.scene(), session_.level()), walker());
    loop_.continueIn(place.loaded.scene(), renderer, nullptr);
  }
  Screenshots& screenshots() { return screenshots_; }

  test::Stage stage;
  bool isOn = true;

 private:
  const Place& place_;
  Renderer renderer_;
  Walker start_;
  WalkSession session_;
  Disk disk_;
  ScreenshotFiles screenshots_;
  WalkSettings settings_;
  WalkLoop loop_;
};

}  // namespace hearth::test
