// Which spans are painted together, and in what order.

#include "render/span_groups.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

#include "load/load.h"
#include "render/renderer.h"
#include "render/visibility.h"
#include "support/in_tree.h"

namespace hearth {
namespace {

using ::testing::ElementsAre;

constexpr SurfaceId kWall(0);
constexpr SurfaceId kFloor(1);

/// Visits the groups of a strip with one function for either kind.
template <typename... Uses>
struct EitherKind : Uses... {
  using Uses::operator()...;
};
template <typename... Uses>
EitherKind(Uses...) -> EitherKind<Uses...>;

/// The same rows in lanes [laneBegin, laneEnd).
LaneRowRanges rowsIn(std::size_t laneBegin, std::size_t laneEnd, int begin, int end) {
  LaneRowRanges rows;
  for (std::size_t lane = laneBegin; lane < laneEnd; ++lane) {
    rows.begin[lane] = begin;
    rows.end[lane] = end;
  }
  return rows;
}

std::vector<LaneSet> lanesOf(const SpanGroups& groups, int strip) {
  std::vector<LaneSet> lanes;
  groups.forEach(strip, EitherKind{[&](const SpanGroup& group) { lanes.push_back(group.lanes); },
                                   [&](const FaceGroup&) { lanes.push_back(0); }});
  return lanes;
}

class Groups : public ::testing::Test {
 protected:
  Groups() { groups_.clear(3, 2); }

  SpanGroups groups_{SpanGroups::Order::Any};
};

TEST_F(Groups, joinSpansOfASurfaceInAStrip) {
  groups_.add(kWall, 3, rowsIn(0, 2, 5, 10));
  groups_.add(kFloor, 3, rowsIn(0, 8, 10, 12));
  groups_.add(kWall, 3, rowsIn(2, 5, 7, 14));
  groups_.add(kWall, 4, rowsIn(5, 8, 5, 10));
  EXPECT_THAT(lanesOf(groups_, 3), ElementsAre(0b11111111, 0b00011111));
  EXPECT_THAT(lanesOf(groups_, 4), ElementsAre(0b11100000));
  EXPECT_EQ(groups_.pixelsOf(3), 2U * 5 + 8 * 2 + 3 * 7);
  EXPECT_EQ(groups_.spans(), 2U + 8 + 3 + 3);
}

TEST_F(Groups, countMorePixelsThanAnIntHolds) {
  for (int i = 0; i < 3; ++i) groups_.add(kWall, 3, rowsIn(0, 8, 0, 1 << 27));
  EXPECT_EQ(groups_.pixelsOf(3), 3 * (std::size_t{1} << 30));
}

TEST_F(Groups, holdOneSpanOfAColumnAtMost) {
  groups_.add(kWall, 3, rowsIn(0, 4, 5, 10));
  groups_.add(kWall, 3, rowsIn(3, 5, 9, 12));
  EXPECT_THAT(lanesOf(groups_, 3), ElementsAre(0b00011000, 0b00001111));
}

TEST_F(Groups, areNotJoinedAcrossRowsThatNoneOfThemShows) {
  groups_.add(kWall, 3, rowsIn(0, 4, 5, 10));
  groups_.add(kWall, 3, rowsIn(4, 8, 500, 510));
  EXPECT_THAT(lanesOf(groups_, 3), ElementsAre(0b11110000, 0b00001111));
}

TEST_F(Groups, askForTheNumbersOfAllLanesOnce) {
  EXPECT_EQ(groups_.add(kWall, 3, rowsIn(0, 2, 5, 10)).lanes, kAllLanes);
  EXPECT_EQ(groups_.add(kWall, 3, rowsIn(2, 5, 5, 10)).lanes, 0b00011100);
  EXPECT_EQ(groups_.add(kWall, 3, rowsIn(5, 8, 10, 10)).group, nullptr);
}

TEST_F(Groups, ofAnEarlierFrameAreForgotten) {
  groups_.add(kWall, 3, rowsIn(0, 8, 5, 10));
  groups_.clear(3, 2);
  EXPECT_EQ(groups_.spans(), 0U);
  groups_.add(kWall, 3, rowsIn(7, 8, 5, 10));
  EXPECT_THAT(lanesOf(groups_, 3), ElementsAre(0b10000000));
}

/// Masked middle textures are found near to far, and painted far to near.
TEST(GroupsInOrder, visitWhatWasAddedToAPixelLastFirst) {
  std::mt19937 random(1);
  const auto below = [&](std::size_t end) { return random() % end; };
  for (int level = 0; level < 200; ++level) {
    SpanGroups groups(SpanGroups::Order::LastToFirst);
    groups.clear(0, 1);
    for (int i = 0; i < 40; ++i) {
      const std::size_t lane = below(8);
      const int row = static_cast<int>(below(6));
      const auto [group, lanes] = groups.add(
          SurfaceId(below(3)), 0, rowsIn(lane, lane + 1 + below(8 - lane), row, row + 3));
      for (std::size_t k = 0; k < Strip::kColumns; ++k)
        if ((lanes >> k & 1) != 0) group->depth[k] = i;
    }
    std::vector<std::vector<double>> depths(8 * 9, {100});  // by pixel, as visited
    groups.forEach(0, [&](const auto& group) {
      group.forEachSpan([&](const Span& span) {
        for (int row = span.rowBegin; row < span.rowEnd; ++row) {
          std::vector<double>& before = depths[static_cast<std::size_t>(row * 8 + span.column)];
          EXPECT_LT(span.depth, before.back());
          before.push_back(span.depth);
        }
      });
    });
  }
}

/// Else what is farther would be painted over them.
TEST(GroupsInOrder, areNotJoinedAcrossNarrowFaces) {
  const FaceFront front{};
  SpanGroups groups(SpanGroups::Order::LastToFirst);
  groups.clear(3, 2);
  groups.add(kWall, 3, rowsIn(0, 2, 5, 10));
  groups.addFaces(kFloor, 3, std::vector<FaceSpan>{{&front, 5, 4, 9, 1}, {&front, 5, 9, 12, 1}});
  groups.add(kWall, 3, rowsIn(2, 4, 5, 10));
  EXPECT_THAT(lanesOf(groups, 3), ElementsAre(0b00001100, 0, 0b00000011));
  EXPECT_EQ(groups.pixelsOf(3), 2U * 5 + 5 + 3 + 2 * 5);
  EXPECT_EQ(groups.spans(), 2U + 2 + 2);
}

/// What a strip shows, group by group.
using StripGroups = std::vector<std::tuple<SurfaceId, LaneSet, LaneRows, LaneRows>>;

StripGroups groupsOf(const VisibleSpans& found, int strip) {
  StripGroups groups;
  found.forEachGroup(strip, EitherKind{[&](const SpanGroup& group) {
                                         groups.emplace_back(group.surface, group.lanes,
                                                             group.rows.begin, group.rows.end);
                                       },
                                       [&](const FaceGroup& group) {
                                         for (const FaceSpan& span : group.spans)
                                           groups.emplace_back(
                                               group.mesh, static_cast<LaneSet>(1U << span.lane),
                                               LaneRows{span.rowBegin}, LaneRows{span.rowEnd});
                                       }});
  return groups;
}

/// So no pixel depends on how threads divide a picture: light is computed from the first row of a
/// group on, and rounded on the way.
TEST(VisibleGroups, ofAStripDoNotDependOnTheStripsBesideIt) {
  for (const char* const name : {"keep", "tutorial"}) {
    const LoadedLevel loaded =
        loadLevel(test::inTree(fmt::format("levels/{}.json", name))).loaded.value();
    VisibilityScratch whole;
    VisibilityScratch alone;
    for (const Shot& shot : loaded.level.shots) {
      Camera camera = cameraOf(shot);
      camera.width = 643;
      camera.height = 400;
      const Projection projection = projectionFor(loaded.scene(), camera);
      findVisibleSpans(loaded.scene(), camera, projection, whole);
      for (int strip = 0; strip < Strip::countIn(camera.width); ++strip) {
        const ColumnRange columns{strip * Strip::kColumns,
                                  std::min((strip + 1) * Strip::kColumns, camera.width)};
        findVisibleSpans(loaded.scene(), SpriteIndex(), camera, projection, columns, alone);
        EXPECT_EQ(groupsOf(whole.found, strip), groupsOf(alone.found, strip))
            << shot.name << ' ' << strip;
      }
    }
  }
}

}  // namespace
}  // namespace hearth
