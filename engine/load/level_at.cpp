#include <utility>

#include "level/switch_textures.h"
#include "load/level_linker.h"
#include "load/source.h"
#include "math/check.h"

namespace hearth {

namespace {

/// The player of a level whose flats have moved, unless they have closed around it.
std::optional<Player> playerIn(const Scene& scene, const std::optional<Player>& authored) {
  if (!authored) return std::nullopt;
  const auto sector = Locator(scene).locate(authored->eye, authored->sector, PositionOf::Camera);
  return sector ? authored : std::nullopt;
}

}  // namespace

LoadResult levelAt(const LoadedLevel& authored, const LevelSource& source,
                   std::span<const double> shares, const LoadLimits& limits,
                   const FileSource& files) {
  CHECK(shares.size() == source.level.movers.size(), shares.size(), source.level.movers.size());
  Report report;
  const std::vector<Image>& images = authored.textures;
  std::optional<LinkedLevel> linked =
      LevelLinker(report, {files, authored.path, limits})
          .link(descriptionAt(source.level, shares), source.lights, &images);
  LoadResult result;
  result.diagnostics = report.resolve(source.documents);
  if (!linked) return result;
  result.loaded = LoadedLevel{std::move(linked->level), std::move(linked->geometry),
                              authored.textures,        authored.path,
                              authored.lights,          authored.files,
                              authored.decodedImages,   authored.textHash};
  showSwitches(result.loaded->level, shares);
  result.loaded->level.player = playerIn(result.loaded->scene(), authored.level.player);
  return result;
}

}  // namespace hearth
