// Files of a model that are saved while it is turned.

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <thread>

#include "live_walk.h"
#include "model/open_level.h"
#include "support/temporary_folder.h"

namespace hearth {
namespace {

/// An upright panel of this width that faces the front, red or of another colour of crate.mtl.
std::string panel(double width, const std::string& material = "red") {
  const std::string w = std::to_string(width / 2);
  return "mtllib crate.mtl\nv -" + w + " 0 0\nv " + w + " 0 0\nv " + w + " 1 0\nv -" + w +
         " 1 0\nusemtl " + material + "\nf 1 2 3 4\n";
}

class LiveModel : public test::LiveStage {
 protected:
  void begin() {
    folder_.write("crate.mtl", "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n");
    values_.level = folder_.write("crate.obj", panel(1)).string();
    values_.set(Option::NoCache, "");
    OpenedLevel opened = openLevel(values_.level);
    ASSERT_TRUE(opened.result.loaded);
    const auto loaded = std::make_shared<const LoadedLevel>(*std::move(opened.result.loaded));
    live_ = std::make_unique<LiveLevel>(values_, loaded, nullptr);
    const auto lit = live_->awaitFirst([] { std::this_thread::yield(); });
    ASSERT_TRUE(lit) << lit.error();
    const SectorId air = loaded->level.meshes.front().sector;
    session_ = std::make_unique<WalkSession>(MovingLevel(loaded->scene()),
                                             Walker{.sector = air, .feet = {}, .velocity = {}},
                                             WalkSession::Record::No);
    WalkSettings settings;
    settings.fov = kModelFov;
    settings.options = values_;
    settings.canBake = true;
    settings.model = {*opened.model, {{0, 0, 0.5}, 4, 270, 0}};
    stage_.window = ImageSize{80, 50};
    screenshots_ = std::make_unique<ScreenshotFiles>(folder_.path(), "crate");
    loop_ = std::make_unique<WalkLoop>(loaded->scene(), (*lit)->renderer, *session_,
                                       WalkHost{stage_, disk_, *screenshots_}, settings);
    loop_->round();
  }

  /// Columns of the middle row that the panel takes.
  int width() const {
    int columns = 0;
    const Rgb sky = stage_.shown.at(0, 49);
    for (int x = 0; x < 80; ++x) columns += stage_.shown.at(x, 25) != sky ? 1 : 0;
    return columns;
  }
  Rgb middle() const { return stage_.shown.at(40, 25); }

  test::TemporaryFolder folder_;
};

TEST_F(LiveModel, ShowsWhatWasSavedFromTheSameView) {
  begin();
  const int before = width();
  folder_.write("crate.obj", panel(2));
  ASSERT_TRUE(isTold("crate.obj: shown"));
  EXPECT_NEAR(width(), 2 * before, 2);
  EXPECT_EQ(live_->shown()->model->box, (Box3{{-1, 0, 0}, {1, 0, 1}}));
}

TEST_F(LiveModel, ShowsMaterialsThatWereSaved) {
  begin();
  EXPECT_GT(middle().r, middle().b);
  folder_.write("crate.mtl", "newmtl red\nKd 0 0.2 1\n");
  ASSERT_TRUE(isTold("crate.mtl: shown"));
  EXPECT_LT(middle().r, middle().b);
}

TEST_F(LiveModel, KeepsTheLastGoodModelBehindMistakesUntilTheyAreMended) {
  begin();
  const Image good = stage_.shown;
  folder_.write("crate.obj", "v 0 0\nf 1 2 3\n");
  ASSERT_TRUE(comesTo([&] { return stage_.shown != good; })) << "the message is over it";
  EXPECT_EQ(stage_.shown.at(40, 32), good.at(40, 32));
  folder_.write("crate.obj", panel(1));
  ASSERT_TRUE(comesTo([&] { return stage_.shown == good; }));
}

TEST_F(LiveModel, ShowsAllOfAModelThatHasBecomeTooSmallForTheView) {
  begin();
  std::string small = panel(0.002);
  for (std::size_t at = 0; (at = small.find(" 1 0\n", at)) != std::string::npos; ++at)
    small.replace(at, 3, " 0.001 ");
  folder_.write("crate.obj", small);
  ASSERT_TRUE(isTold("crate.obj: shown"));
  EXPECT_GT(width(), 30);
}

}  // namespace
}  // namespace hearth
