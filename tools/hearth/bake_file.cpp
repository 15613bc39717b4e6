#include "hearth/bake_file.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>

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

/// All bytes of a regular file: reading from a pipe may wait for ever.
tl::expected<std::string, std::string> bytesOf(const std::filesystem::path& path,
                                               std::uint64_t maxBytes) {
  const auto failure = [&](std::string_view what) {
    return tl::unexpected(fmt::format("{}: {}", path.string(), what));
  };
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return failure("there is no such file");
  if (!std::filesystem::is_regular_file(path, error)) return failure("is not a regular file");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) return failure(error.message());
  if (size > maxBytes)
    return failure(fmt::format("{} bytes are more than {}: raise the limit with {}", size, maxBytes,
                               row(Option::MaxFileBytes).name));
  std::string bytes(size, '\0');
  std::ifstream in(path, std::ios::binary);
  if (!in.read(bytes.data(), static_cast<std::streamsize>(size)))
    return failure("cannot be read: make it readable");
  return bytes;
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
  const double maxBytes =
      values.number(Option::MaxFileBytes).value_or(static_cast<double>(LoadLimits{}.fileBytes));
  const auto bytes = bytesOf(path, static_cast<std::uint64_t>(maxBytes));
  if (!bytes) return tl::unexpected(bytes.error());
  return decodeBake(level, *bytes).map_error([&](const std::string& mistake) {
    return fmt::format("{} {}: bake again with `hearth bake {} -o {}`", path, mistake,
                       shellWord(values.level), shellWord(path));
  });
}

}  // namespace hearth
