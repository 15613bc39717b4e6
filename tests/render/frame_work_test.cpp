// What a frame does for parts of a level that are not there, or not seen: nothing. And that the
// counters which say so count.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "render/renderer.h"
#include "rooms_behind_a_door.h"
#include "support/baked_room.h"
#include "support/canvas.h"
#include "support/in_tree.h"
#include "support/level_text.h"

namespace hearth {
namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 200;
/// In which the east wall of `hall` shows: 8 m of it at 7 m, of a field of view of 90 degrees.
constexpr int kEastColumns = 182;

const std::string kSolid = "{'texture':'#808080'}";

struct Work {
  FrameStats found;
  PaintStats painted;
  Image picture;
};

/// Of a frame in the first sector, 1 m from the middle of its west wall.
Work workOf(const test::BakedRoom& room, LightMode mode = LightMode::Both, int threads = 1) {
  const std::vector<Image> textures(room.level().textures.size(), Image(1, 1, {200, 150, 100}));
  FrameScratch scratch;
  Workers workers(threads);
  test::Canvas picture(kWidth, kHeight);
  Renderer(room.scene(), textures, room.light())
      .draw({SectorId(0), {1, 0, 1.6}, 0, 0, 90, kWidth, kHeight}, mode, scratch, picture,
            &workers);
  return {scratch.found(), scratch.painted, picture.image()};
}

test::BakedRoom levelOf(const std::string& sectors, std::string_view lights = "[]") {
  return {"{'light':0.3,'sectors':{" + sectors + "}}", lights};
}

/// 8 m by 8, with an east wall to choose.
std::string hall(const std::string& east = kSolid, std::string_view more = "") {
  return test::sectorText("hall", "0,-4, 8,-4, 8,4, 0,4", 0, 3,
                          fmt::format("[{0},{1},{0},{0}]", kSolid, east), more);
}

/// East of it, as wide.
std::string annex(std::string_view more = "") {
  return test::sectorText("annex", "8,-4, 12,-4, 12,4, 8,4", 0, 3,
                          fmt::format("[{0},{0},{0},{{'next':'hall'}}]", kSolid), more);
}

const std::string kToAnnex = "{'next':'annex'}";
const std::string kLamp = "[{'x':4,'y':0,'z':2,'falloff':0.5}]";

TEST(FrameWork, forSlopesIsNoneWithoutThem) {
  const Work work = workOf(levelOf(hall(kToAnnex) + "," + annex()));
  EXPECT_EQ(work.found.slopeColumns, 0U);
  EXPECT_EQ(work.painted.slopeSpans, 0U);
}

TEST(FrameWork, forSlopesIsCountedWhereTheyRiseAndWhereTheyShow) {
  const Work work = workOf(levelOf(hall(kSolid, ",'slopeFloor':{'z':[0,1,1,0]}")));
  EXPECT_EQ(work.found.wallColumns, std::size_t{kWidth});
  EXPECT_EQ(work.found.slopeColumns, std::size_t{kWidth - kEastColumns}) << "it is level there";
  EXPECT_EQ(work.painted.slopeSpans, std::size_t{kWidth}) << "the floor of every column";
}

TEST(FrameWork, forSlopesIsCountedOnSidewalls) {
  const Work work = workOf(levelOf(hall(kToAnnex) + "," +
                                   annex(",'slopeFloor':{'z':[1,0,0,1],'sidewall':"
                                         "'#404040'}")));
  EXPECT_EQ(work.painted.slopeSpans, std::size_t{kEastColumns}) << "the slope is out of sight";
}

TEST(FrameWork, forStacksIsThatOfTheirColumns) {
  EXPECT_EQ(workOf(levelOf(hall(kToAnnex) + "," + annex())).found.stackColumns, 0U);
  const std::string stack = fmt::format("{{'walls':[{{'z':1,'texture':'#404040'}},{0}]}}", kSolid);
  EXPECT_EQ(workOf(levelOf(hall(stack))).found.stackColumns, std::size_t{kEastColumns});
}

/// The same hall and annex, with things in the annex.
test::BakedRoom withThings(const std::string& things, const std::string& east = kToAnnex) {
  return {"{'light':0.3,'sectors':{" + hall(east) + "," + annex() + "},'things':[" + things + "]}",
          "[]"};
}

const std::string kInAnnex = "'x':10,'y':0,'sector':'annex'";

TEST(FrameWork, forThingsIsNoneWithoutThem) {
  const Work work = workOf(withThings(""));
  EXPECT_EQ(work.found.sprites, 0U);
  EXPECT_EQ(work.found.faces, 0U);
  EXPECT_EQ(work.found.maskedSpans, 0U);
}

TEST(FrameWork, forThingsIsCountedWhereTheyAreInView) {
  const std::string sprite = "{'sprite':'#ff0000','size':[1,1]," + kInAnnex + "}";
  const std::string crate =
      "{'mesh':'" + test::inTree("levels/models/crate.obj").string() + "'," + kInAnnex + "}";
  const Work seen = workOf(withThings(sprite + "," + crate));
  EXPECT_EQ(seen.found.sprites, 1U);
  EXPECT_GT(seen.found.faces, 0U);
  EXPECT_GT(seen.found.maskedSpans, 0U);
  const Work behindWall = workOf(withThings(sprite + "," + crate, kSolid));
  EXPECT_EQ(behindWall.found.sprites, 0U);
  EXPECT_EQ(behindWall.found.faces, 0U);
  EXPECT_EQ(behindWall.found, workOf(withThings("", kSolid)).found);
  EXPECT_EQ(behindWall.painted, workOf(withThings("", kSolid)).painted);
}

TEST(FrameWork, forWindowsIsThatOfTheirOwnColumns) {
  EXPECT_EQ(workOf(levelOf(hall())).found.windows, std::size_t{kWidth});
  // A door of 1 m at 7 m: 160 / 7 columns about the middle.
  const std::string door =
      test::sectorText("hall", "0,-4, 8,-4, 8,-0.5, 8,0.5, 8,4, 0,4", 0, 3,
                       fmt::format("[{0},{0},{{'next':'closet'}},{0},{0},{0}]", kSolid));
  const std::string closet =
      test::sectorText("closet", "8,-0.5, 9,-0.5, 9,0.5, 8,0.5", 0, 3,
                       fmt::format("[{0},{0},{0},{{'next':'hall'}}]", kSolid));
  const Work work = workOf(levelOf(door + "," + closet));
  EXPECT_EQ(work.found.viewports, 2);
  EXPECT_EQ(work.found.windows, std::size_t{kWidth + 22});
}

TEST(FrameWork, forLightIsNoneWithoutIt) {
  const test::BakedRoom dark = levelOf(hall());
  EXPECT_EQ(dark.light().stats.bytes, 0);
  const Work work = workOf(dark);
  EXPECT_EQ(work.painted.lightmapSpans, 0U);
  EXPECT_EQ(work.painted.lightmapPixels, 0U);
}

TEST(FrameWork, forLightIsCountedByThePixel) {
  const test::BakedRoom lit = levelOf(hall(), kLamp);
  EXPECT_GT(lit.light().stats.bytes, 0);
  const Work work = workOf(lit);
  EXPECT_EQ(work.painted.lightmapSpans, work.found.spans);
  EXPECT_EQ(work.painted.lightmapPixels, std::size_t{kWidth} * kHeight);
  EXPECT_EQ(workOf(lit, LightMode::None).painted.lightmapPixels, 0U) << "textures alone";
}

TEST(FrameWork, forLightIsOfThreeChannelsOnlyWhereColorArrives) {
  EXPECT_EQ(workOf(levelOf(hall(), kLamp)).painted.coloredSpans, 0U);
  const Work work =
      workOf(levelOf(hall(), "[{'x':4,'y':0,'z':2,'falloff':0.5,'color':'#ff8000'}]"));
  EXPECT_EQ(work.painted.coloredSpans, work.found.spans);
}

TEST(FrameWork, forEvenLightIsThatOfNone) {
  const test::BakedRoom room = levelOf(hall(kToAnnex) + "," + annex(),
                                       "[{'x':4,'y':0,'z':2,'intensity':77,'color':'#ff8000'}]");
  EXPECT_EQ(room.light().stats.bytes,
            3 * static_cast<std::int64_t>(room.light().stats.litSurfaces));
  EXPECT_EQ(workOf(room).painted.lightmapSpans, 0U);
}

TEST(FrameWork, forEvenLightShowsTheSameAsThatOfAllItsTexels) {
  for (const std::string_view color : {"#ffffff", "#ff8000"}) {
    const LoadedLevel loaded =
        test::levelFrom("{'light':0.3,'sectors':{" + hall() + "}}",
                        fmt::format("[{{'x':4,'y':0,'z':2,'intensity':77,'color':'{}'}}]", color));
    const BakedLight even = bake(loaded.scene(), loaded.level.bake, 1);
    for (const auto& map : even.lightmaps) EXPECT_TRUE(map.value().isUniform());
    const BakedLight whole = test::withAllTexels(even);
    const Camera camera{SectorId(0), {1, 0, 1.6}, 20, 0, 90, kWidth, kHeight};
    for (const LightMode mode : {LightMode::Both, LightMode::Only})
      EXPECT_EQ(Renderer(loaded.scene(), loaded.textures, even).draw(camera, mode),
                Renderer(loaded.scene(), loaded.textures, whole).draw(camera, mode))
          << color;
  }
}

TEST(FrameWork, inColumnsIsTheSameForAnyNumberOfThreads) {
  const test::BakedRoom room = levelOf(hall(kToAnnex) + "," + annex(), kLamp);
  const Work one = workOf(room);
  for (const int threads : {2, 7}) {
    Work many = workOf(room, LightMode::Both, threads);
    EXPECT_EQ(many.painted, one.painted);
    // Each thread looks at the sectors that its own columns see.
    EXPECT_GE(many.found.viewports, one.found.viewports);
    EXPECT_GE(many.found.segments, one.found.segments);
    many.found.viewports = one.found.viewports;
    many.found.segments = one.found.segments;
    EXPECT_EQ(many.found, one.found);
  }
}

TEST(FrameWork, doesNotGrowWithSectorsThatAreNotSeen) {
  const Work one = workOf({test::roomsBehindADoor(1), "[]"});
  const Work thousand = workOf({test::roomsBehindADoor(1000), "[]"});
  EXPECT_EQ(one.found.viewports, 1);
  EXPECT_EQ(thousand.found, one.found);
  EXPECT_EQ(thousand.painted, one.painted);
  EXPECT_EQ(thousand.picture, one.picture);
}

}  // namespace
}  // namespace hearth
