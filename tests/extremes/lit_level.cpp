#include "lit_level.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "image/compare.h"

namespace hearth::extremes {

namespace {

/// The surfaces that a sector's air ends at, in the order of the level.
std::vector<SurfaceId> surfacesOf(const Scene& scene, SectorId sector) {
  std::vector<SurfaceId> surfaces;
  for (const SurfaceId id : scene.shownSurfaces())
    if (scene[id].sector == sector) surfaces.push_back(id);
  return surfaces;
}

/// Where and by how much the first texel that is not the same differs; empty when all are the same.
std::string differenceOf(const Lightmap& expected, const Lightmap& actual) {
  if (expected.rect != actual.rect) return "another rectangle of texels";
  if (expected.channels != actual.channels) return "another number of channels";
  const TexelRect& rect = expected.rect;
  for (int j = rect.j0; j < rect.j0 + rect.height; ++j)
    for (int i = rect.i0; i < rect.i0 + rect.width; ++i)
      for (int channel = 0; channel < expected.channels; ++channel)
        if (expected.at(i, j, channel) != actual.at(i, j, channel))
          return fmt::format("{} instead of {} at texel {},{} of {},{}+{}x{}",
                             actual.at(i, j, channel), expected.at(i, j, channel), i, j, rect.i0,
                             rect.j0, rect.width, rect.height);
  return "";
}

void expectSameLightmap(const std::optional<Lightmap>& expected,
                        const std::optional<Lightmap>& actual, const std::string& where) {
  ASSERT_EQ(expected.has_value(), actual.has_value()) << where;
  if (!expected) return;
  EXPECT_EQ(differenceOf(*expected, *actual), "") << where;
}

}  // namespace

void expectSamePictures(const LitLevel& expected, const LitLevel& actual) {
  ASSERT_EQ(expected.level().shots.size(), actual.level().shots.size());
  for (std::size_t shot = 0; shot < expected.level().shots.size(); ++shot)
    for (const LightMode mode : {LightMode::None, LightMode::Only, LightMode::Both}) {
      const PictureDifference difference =
          compare(expected.look(shot, mode), actual.look(shot, mode));
      EXPECT_EQ(difference.differing, 0)
          << expected.level().name << ", " << expected.level().shots[shot].name << ", mode "
          << static_cast<int>(mode) << ": by up to " << difference.largest;
    }
}

void expectSameLight(const LitLevel& expected, const LitLevel& actual,
                     const std::function<SectorId(SectorId)>& actualSector) {
  for (std::size_t i = 0; i < expected.level().sectors.size(); ++i) {
    const std::vector<SurfaceId> some = surfacesOf(expected.scene(), SectorId(i));
    const std::vector<SurfaceId> others = surfacesOf(actual.scene(), actualSector(SectorId(i)));
    ASSERT_EQ(some.size(), others.size()) << expected.level().sectors[i].name;
    for (std::size_t k = 0; k < some.size(); ++k)
      expectSameLightmap(
          expected.light().lightmaps[some[k].index()], actual.light().lightmaps[others[k].index()],
          fmt::format("{}, {} {} of sector {}", expected.level().name,
                      name(expected.level()[some[k]].kind), k, expected.level().sectors[i].name));
  }
}

}  // namespace hearth::extremes
