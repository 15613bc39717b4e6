#include "load_text.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "support/temporary_folder.h"

namespace hearth {

namespace {

std::string quoted(std::string_view text) {
  std::string result(text);
  std::replace(result.begin(), result.end(), '\'', '"');
  return result;
}

}  // namespace

LoadResult loadText(std::string_view level, std::string_view lights, const LoadLimits& limits) {
  const test::TemporaryFolder folder;
  if (!lights.empty()) folder.write("level.lights.json", quoted(lights));
  return loadLevel(folder.write("level.json", quoted(level)), limits);
}

LoadedLevel loadSectors(std::string_view sectors, std::string_view lights) {
  LoadResult result = loadText("{'light': 0.5, 'sectors': {" + std::string(sectors) + "}}", lights);
  if (result.loaded) return *std::move(result.loaded);
  ADD_FAILURE() << listed(result);
  std::abort();
}

std::string sectorText(std::string_view name, std::string_view vertices, std::string_view walls,
                       std::string_view more) {
  std::string members(more);
  if (!members.empty()) members += ", ";
  if (more.find("'floor'") == std::string_view::npos)
    members += "'floor': {'texture': '#808080'}, ";
  if (more.find("'ceiling'") == std::string_view::npos)
    members += "'ceiling': {'texture': '#404040'}, ";
  return fmt::format("'{}': {{{}'loops': {{'border': {{'v': [{}], 'walls': {}}}}}}}", name, members,
                     vertices, walls);
}

std::string listed(const LoadResult& result) {
  std::string text;
  for (const Diagnostic& diagnostic : result.diagnostics) text += format(diagnostic) + "\n";
  return text;
}

std::size_t countErrors(const LoadResult& result) {
  return static_cast<std::size_t>(
      std::count_if(result.diagnostics.begin(), result.diagnostics.end(),
                    [](const Diagnostic& diagnostic) { return diagnostic.isError; }));
}

std::size_t countWarnings(const LoadResult& result) {
  return result.diagnostics.size() - countErrors(result);
}

const Sector& sectorNamed(const Level& level, std::string_view name) {
  const auto found = std::find_if(level.sectors.begin(), level.sectors.end(),
                                  [&](const Sector& sector) { return sector.name == name; });
  if (found != level.sectors.end()) return *found;
  ADD_FAILURE() << "no sector " << name;
  std::abort();
}

void expectTwins(const Scene& scene) {
  for (const Segment& segment : scene.level().segments)
    for (const WallPiece& piece : scene.piecesOf(segment))
      if (const Opening* opening = std::get_if<Opening>(&piece.content)) {
        const Segment& twin = scene[opening->twin];
        EXPECT_EQ(twin.sector, opening->next);
        EXPECT_EQ(twin.p0, segment.p1) << segment.p0.x << ' ' << segment.p0.y;
        EXPECT_EQ(twin.p1, segment.p0) << segment.p1.x << ' ' << segment.p1.y;
      }
}

}  // namespace hearth
