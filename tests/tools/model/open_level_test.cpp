// A model that is looked at alone: the level that is made for it, and how it looks.

#include "model/open_level.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "image/image_file.h"
#include "light/bakery.h"
#include "model/model_air.h"
#include "model/orbit_view.h"
#include "opened_model.h"
#include "render/renderer.h"
#include "support/memory_files.h"
#include "support/temporary_folder.h"

namespace hearth {
namespace {

namespace fs = std::filesystem;

using test::boxModel;
using test::listed;
using test::opened;

constexpr ImageSize kSize = {96, 60};

Camera cameraOf(const Level& level, const OrbitView& view, ImageSize size = kSize) {
  return {level.meshes.front().sector,
          view.eye(),
          view.angle,
          view.pitch,
          kModelFov,
          size.width,
          size.height,
          0};
}

/// Texels do not matter here: with fewer of them the tests take less time.
BakedLight coarseLight(const LoadedLevel& loaded) {
  BakeSettings settings = loaded.level.bake;
  settings.texel *= 8;
  return bake(loaded.scene(), settings, 1);
}

/// A model with its light.
class LitModel {
 public:
  explicit LitModel(const LoadedLevel& loaded)
      : light_(coarseLight(loaded)), renderer_(loaded.scene(), loaded.textures, light_) {}

  Image draw(const Camera& camera, LightMode mode = LightMode::Both) const {
    return renderer_.draw(camera, mode);
  }

 private:
  BakedLight light_;
  Renderer renderer_;
};

Image drawn(const LoadedLevel& loaded, const Camera& camera, LightMode mode = LightMode::Both) {
  return LitModel(loaded).draw(camera, mode);
}

Image fromFront(const LoadedLevel& loaded, LightMode mode = LightMode::Both) {
  return drawn(loaded, cameraOf(loaded.level, frontView(loaded.level.meshFaces, kModelFov, kSize)),
               mode);
}

// --- What it becomes -----------------------------------------------------------------------------

TEST(ModelAlone, IsAFileWhoseNameEndsInObj) {
  EXPECT_TRUE(isModel("crate.obj"));
  EXPECT_TRUE(isModel("a.b/CRATE.OBJ"));
  EXPECT_FALSE(isModel("crate.json"));
  EXPECT_FALSE(isModel("obj"));
  EXPECT_FALSE(isModel("models.obj/crate"));
}

TEST(ModelAlone, StandsWithItsOriginAtThatOfItsLevelAndItsAxesAsMeshesDo) {
  const OpenedLevel level = opened("v 1 2 3\nv 4 2 3\nv 1 5 3\nf 1 2 3\n");
  ASSERT_TRUE(level.result.loaded) << listed(level);
  const Level& made = level.result.loaded->level;
  EXPECT_EQ(made.meshes.front().position, (Vec3{0, 0, 0}));
  EXPECT_EQ(made.meshFaces.front().corners[0], (Vec3{1, 3, 2}));
  EXPECT_EQ(boxOf(made.meshFaces), (Box3{{1, 3, 2}, {4, 3, 5}}));
  EXPECT_EQ(made.name, "crate.obj");
}

TEST(ModelAlone, NamesItselfAndItsFiles) {
  const OpenedLevel level =
      opened("mtllib crate.mtl\nusemtl wood\n" + boxModel(1), "newmtl wood\nKd 1 0 0\n");
  ASSERT_TRUE(level.result.loaded) << listed(level);
  EXPECT_EQ(level.result.loaded->path, "models/crate.obj");
  EXPECT_EQ(level.result.loaded->files,
            (std::vector<fs::path>{"models/crate.obj", "models/crate.mtl"}));
}

TEST(ModelAlone, CountsWhatItsFileHolds) {
  const OpenedLevel level =
      opened("mtllib crate.mtl\nusemtl wood\n" + boxModel(2) + "v 9 9 9\nusemtl steel\nf 1 2 3\n",
             "newmtl wood\nKd 1 0 0\nnewmtl steel\nKd 0 0 1\nnewmtl unused\nKd 0 1 0\n");
  ASSERT_TRUE(level.model) << listed(level);
  EXPECT_EQ(*level.model, (ModelFigures{.vertices = 9,
                                        .faces = 7,
                                        .triangles = 13,
                                        .materials = 2,
                                        .images = 0,
                                        .box = {{-1, -1, 0}, {1, 1, 2}}}));
}

TEST(ModelAlone, IsNotALevelFile) {
  test::MemoryFiles files;
  files.add("room.json",
            R"({"light": 1, "sectors": {"a": {"floor": {"texture": "#808080"},
            "ceiling": {"texture": "#808080"}, "loops": {"border": {"v": [0,0, 4,0, 4,4, 0,4],
            "walls": {"texture": "#808080"}}}}}})");
  const OpenedLevel level = openLevel("room.json", {}, {}, files);
  EXPECT_TRUE(level.result.loaded) << listed(level);
  EXPECT_FALSE(level.model);
  EXPECT_EQ(level.source.documents.front().file, "room.json");
}

// --- What it looks like --------------------------------------------------------------------------

/// Pixels of a picture that are not sky.
struct Shown {
  int left, top, right, bottom;  ///< half-open
};
Shown shownIn(const Image& picture) {
  const Rgb sky = picture.at(0, 0);
  Shown shown{picture.width(), picture.height(), 0, 0};
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
      if (picture.at(x, y) != sky)
        shown = {std::min(shown.left, x), std::min(shown.top, y), std::max(shown.right, x + 1),
                 std::max(shown.bottom, y + 1)};
  return shown;
}

TEST(ModelAlone, FillsMostOfThePictureWhateverItsSize) {
  for (const double size : {2e-5, 1e-3, 1.0, 1e3, 1e5}) {
    const OpenedLevel level = opened(boxModel(size));
    ASSERT_EQ(listed(level), "") << size;
    const auto [left, top, right, bottom] = shownIn(fromFront(*level.result.loaded));
    EXPECT_GT(left, 0) << size;
    EXPECT_GT(top, 0) << size;
    EXPECT_LT(right, kSize.width) << size;
    EXPECT_LT(bottom, kSize.height) << size;
    EXPECT_GE(bottom - top, kSize.height * 3 / 4) << size;
  }
}

TEST(ModelAlone, LooksTheSameInEverySize) {
  const auto picture = [](double size) { return fromFront(*opened(boxModel(size)).result.loaded); };
  const Image metre = picture(1);
  for (const double size : {1e-3, 1e3}) {
    const Image other = picture(size);
    int most = 0;
    for (int y = 0; y < kSize.height; ++y)
      for (int x = 0; x < kSize.width; ++x)
        most = std::max(most, std::abs(other.at(x, y).r - metre.at(x, y).r));
    EXPECT_LE(most, 1) << size;
  }
}

TEST(ModelAlone, FillsThePictureWhereverItsOriginIs) {
  const OpenedLevel level = opened(boxModel(1, 5000));
  ASSERT_EQ(listed(level), "");
  const Shown shown = shownIn(fromFront(*level.result.loaded));
  EXPECT_GE(shown.bottom - shown.top, kSize.height * 3 / 4);
}

TEST(ModelAlone, FillsWideAndHighPicturesToo) {
  const OpenedLevel level = opened(boxModel(1));
  for (const ImageSize size : {ImageSize{200, 40}, {40, 200}}) {
    const OrbitView view = frontView(level.result.loaded->level.meshFaces, kModelFov, size);
    const Image picture =
        drawn(*level.result.loaded, cameraOf(level.result.loaded->level, view, size));
    const auto [left, top, right, bottom] = shownIn(picture);
    EXPECT_GT(std::min({left, top, size.width - right, size.height - bottom}), 0);
    EXPECT_GE(std::max(1.0 * (right - left) / size.width, 1.0 * (bottom - top) / size.height),
              0.75);
  }
}

TEST(ModelAlone, ShowsItsFrontWithItsRightToTheRightAndItsTopFromAbove) {
  const std::string colors =
      "newmtl red\nKd 1 0 0\nnewmtl green\nKd 0 1 0\nnewmtl blue\nKd 0 0 1\n";
  const OpenedLevel level = opened(
      "mtllib crate.mtl\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nv -1 0 1\nv -1 1 1\nv -1 1 0\nv 1 1 "
      "0\n"
      "usemtl red\nf 1 2 3 4\nusemtl green\nf 5 1 4 6\nusemtl blue\nf 6 3 8 7\n",
      colors);
  ASSERT_TRUE(level.result.loaded) << listed(level);
  const Image picture = fromFront(*level.result.loaded, LightMode::None);
  const auto [left, top, right, bottom] = shownIn(picture);
  EXPECT_EQ(picture.at(right - 4, bottom - 4), (Rgb{255, 0, 0})) << "at +x";
  EXPECT_EQ(picture.at(left + 4, bottom - 4), (Rgb{0, 255, 0})) << "at -x";
  EXPECT_EQ(picture.at((left + right) / 2, top + 1), (Rgb{0, 0, 255})) << "the top";
}

TEST(ModelAlone, IsLitFromTheLeftAndFromAboveAndNowhereBlack) {
  const OpenedLevel level = opened(boxModel(1));
  ASSERT_TRUE(level.result.loaded);
  const LoadedLevel& loaded = *level.result.loaded;
  const LitModel lit(loaded);
  const auto brightness = [&](double angle, double pitch) {
    OrbitView view = frontView(loaded.level.meshFaces, kModelFov, kSize);
    view.angle = angle;
    view.pitch = pitch;
    return static_cast<int>(
        lit.draw(cameraOf(loaded.level, view)).at(kSize.width / 2, kSize.height / 2).r);
  };
  const int front = brightness(270, 0);
  const int right = brightness(180, 0);
  const int left = brightness(0, 0);
  const int back = brightness(90, 0);
  EXPECT_GT(left, right + 20);
  EXPECT_GT(front, back + 20);
  EXPECT_GT(std::min(right, back), 40);
  EXPECT_LT(std::max(front, left), 255);
}

TEST(ModelAlone, HasSkyOfOneColourAllRoundIt) {
  const OpenedLevel level = opened(boxModel(1));
  ASSERT_TRUE(level.result.loaded);
  const LoadedLevel& loaded = *level.result.loaded;
  const LitModel lit(loaded);
  const OrbitView away = frontView(loaded.level.meshFaces, kModelFov, kSize);
  const Rgb sky = lit.draw(cameraOf(loaded.level, away)).at(0, 0);
  for (const double pitch : {-60.0, 0.0, 60.0})
    for (double angle = 0; angle < 180; angle += 30) {
      Camera camera = cameraOf(loaded.level, away);
      camera.angle = angle;  // the model is behind it, or beside it
      camera.pitch = pitch;
      const Image picture = lit.draw(camera);
      EXPECT_EQ(std::ranges::count(picture.pixels(), sky), kSize.width * kSize.height) << angle;
    }
}

TEST(ModelAlone, WearsItsImagesFromItsFolder) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(writePng(folder.path() / "red.png", Image(2, 2, {200, 0, 0})));
  folder.write("crate.mtl", "newmtl paint\nmap_Kd red.png\n");
  folder.write("crate.obj", "mtllib crate.mtl\nusemtl paint\n" + boxModel(1));
  const OpenedLevel level = openLevel(folder.path() / "crate.obj");
  ASSERT_TRUE(level.result.loaded) << listed(level);
  EXPECT_EQ(level.model->images, 1);
  EXPECT_EQ(level.result.loaded->files.back(), folder.path() / "red.png");
  EXPECT_EQ(fromFront(*level.result.loaded, LightMode::None).at(kSize.width / 2, 40),
            (Rgb{200, 0, 0}));
}

/// Files of which the model is saved anew whenever it has been read.
class SavedWhileRead final : public FileSource {
 public:
  SavedWhileRead() { save(); }

  FileKind kindOf(const std::filesystem::path& path) const override { return files_.kindOf(path); }
  tl::expected<std::string, ReadError> read(const std::filesystem::path& path,
                                            std::uint64_t maxBytes) const override {
    auto text = files_.read(path, maxBytes);
    if (path == "crate.obj") save();
    return text;
  }
  tl::expected<std::unique_ptr<std::istream>, ReadError> open(
      const std::filesystem::path& path) const override {
    return files_.open(path);
  }
  std::vector<std::filesystem::path> namesIn(const std::filesystem::path& folder) const override {
    return files_.namesIn(folder);
  }

 private:
  void save() const { files_.add("crate.obj", boxModel(++size_)); }

  mutable test::MemoryFiles files_;
  mutable double size_ = 0;
};

TEST(ModelAlone, IsOneVersionOfAFileThatIsSavedWhileItIsRead) {
  const OpenedLevel level = openLevel("crate.obj", {}, {}, SavedWhileRead());
  ASSERT_TRUE(level.result.loaded) << listed(level);
  EXPECT_EQ(level.model->box, boxOf(level.result.loaded->level.meshFaces));
}

TEST(ModelAlone, HasAShotFromItsFront) {
  const OpenedLevel level = opened(boxModel(3));
  ASSERT_TRUE(level.result.loaded);
  const Level& made = level.result.loaded->level;
  ASSERT_EQ(made.shots.size(), 1);
  const OrbitView front = frontView(made.meshFaces, kModelFov, {320, 200});
  EXPECT_EQ(made.shots[0].name, "front");
  EXPECT_EQ(made.shots[0].eye, front.eye());
  EXPECT_EQ(made.shots[0].fov, kModelFov);
}

}  // namespace
}  // namespace hearth
