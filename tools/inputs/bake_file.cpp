#include "inputs/bake_file.h"

#include <fmt/format.h>

#include "files/replace_file.h"
#include "inputs/read_within_limit.h"
#include "light/saved_bake.h"
#include "settings/shell_text.h"

namespace hearth {

tl::expected<void, std::string> writeBake(const std::string& path, const Scene& scene,
                                          const Bake& bake) {
  const std::string bytes =
      encodeBake(scene, bake.light, bake.settings.texel, optionsOf(bake.settings));
  return replaceFile(path, [&](std::ostream& stream) {
    stream.write(bytes.data(), std::ssize(bytes));
    return stream.good();
  });
}

tl::expected<BakedLight, std::string> readBake(const Scene& scene, const OptionValues& values) {
  const std::string path = *values.text(Option::LightFrom);
  const auto bytes = readWithinLimit(path, values);
  if (!bytes) return tl::unexpected(bytes.error());
  return decodeBake(scene, *bytes, maxFileBytes(values)).map_error([&](const BakeMistake& mistake) {
    const std::string remedy =
        mistake.isTooLarge ? fmt::format("raise the limit with {}", row(Option::MaxFileBytes).name)
                           : fmt::format("bake again with `{} bake {} -o {}`", values.program,
                                         shellWord(values.level), shellWord(path));
    return fmt::format("{} {}: {}", path, mistake.what, remedy);
  });
}

}  // namespace hearth
