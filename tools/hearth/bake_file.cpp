#include "hearth/bake_file.h"

#include <fmt/format.h>

#include "hearth/read_bytes.h"
#include "hearth/shell_text.h"
#include "image/replace_file.h"
#include "light/saved_bake.h"

namespace hearth {

namespace {

/// As the options of a bake.
std::string words(const BakeSettings& settings) {
  return fmt::format("--texel {} --samples {} --bounces {} {}", settings.texel,
                     settings.samples ? fmt::to_string(*settings.samples) : "auto",
                     settings.bounces, settings.lambert ? "--lambert" : "--no-lambert");
}

}  // namespace

tl::expected<void, std::string> writeBake(const std::string& path, const Level& level,
                                          const Bake& bake) {
  const std::string bytes =
      encodeBake(level, bake.light, bake.settings.texel, words(bake.settings));
  return replaceFile(path, [&](std::ostream& stream) {
    stream.write(bytes.data(), std::ssize(bytes));
    return stream.good();
  });
}

tl::expected<BakedLight, std::string> readBake(const Level& level, const OptionValues& values) {
  const std::string path = *values.text(Option::LightFrom);
  const auto bytes = readBytes(path, values);
  if (!bytes) return tl::unexpected(bytes.error());
  return decodeBake(level, *bytes).map_error([&](const std::string& mistake) {
    return fmt::format("{} {}: bake again with `hearth bake {} -o {}`", path, mistake,
                       shellWord(values.level), shellWord(path));
  });
}

}  // namespace hearth
