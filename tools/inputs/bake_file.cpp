#include "inputs/bake_file.h"

#include <fmt/format.h>

#include "files/replace_file.h"
#include "inputs/read_within_limit.h"
#include "light/saved_bake.h"
#include "settings/mover_light.h"
#include "settings/shell_text.h"

namespace hearth {

std::string bytesOf(const Scene& scene, const Bake& bake) {
  return encodeBake(scene, bake.light, bake.settings.texel, optionsOf(bake.settings));
}

tl::expected<void, std::string> writeBakes(const std::string& path, std::string_view bytes) {
  return replaceFile(path, [&](std::ostream& stream) {
    stream.write(bytes.data(), std::ssize(bytes));
    return stream.good();
  });
}

namespace {

/// Whether a bake leaves out some states of the level's movers.
bool areStatesLeftOut(const Level& level, const MoverLightSettings& settings) {
  std::size_t all = 1;
  for (std::size_t i = 0; i < level.movers.size() && all <= settings.states; ++i)
    all *= static_cast<std::size_t>(settings.stages) + 2;
  return all > settings.states;
}

std::string remedyFor(const BakeMistake& mistake, const Level& level, const std::string& path,
                      const OptionValues& values) {
  if (mistake.isTooLarge)
    return fmt::format("raise the limit with {}", row(Option::MaxFileBytes).name);
  std::string remedy =
      fmt::format("bake again with `{} bake {}{} -o {}`", values.program, shellWord(values.level),
                  typedOptions(values, {Option::MoverStages}), shellWord(path));
  if (areStatesLeftOut(level, moverLightFrom(values)))
    remedy += fmt::format(", perhaps with more {}", row(Option::MoverStates).name);
  return remedy;
}

}  // namespace

tl::expected<BakedLight, std::string> readBake(const Scene& scene, const OptionValues& values) {
  const std::string path = *values.text(Option::LightFrom);
  const auto bytes = readWithinLimit(path, values);
  if (!bytes) return tl::unexpected(bytes.error());
  return decodeBake(scene, *bytes, maxFileBytes(values)).map_error([&](const BakeMistake& mistake) {
    return fmt::format("{} {}: {}", path, mistake.what,
                       remedyFor(mistake, scene.level(), path, values));
  });
}

}  // namespace hearth
