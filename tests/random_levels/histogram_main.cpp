// How often each feature occurs among random levels.

#include <fmt/format.h>

#include <charconv>
#include <cstdio>
#include <map>
#include <optional>
#include <span>
#include <string_view>

#include "random_levels/random_level.h"

namespace {

using namespace hearth;

constexpr double kLeastFraction = 0.05;
constexpr int kFoundRare = 1;
constexpr int kBadUsage = 2;

struct Options {
  std::uint64_t count = 2000;
  std::uint64_t seed = 1;
  std::optional<std::filesystem::path> folder;
};

std::optional<std::uint64_t> parseNumber(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<Options> parse(std::span<char* const> arguments) {
  Options options;
  for (std::size_t i = 0; i + 1 < arguments.size(); i += 2) {
    const std::string_view key = arguments[i];
    if (key == "-o") {
      options.folder = arguments[i + 1];
      continue;
    }
    const auto value = parseNumber(arguments[i + 1]);
    if (!value || (key != "--count" && key != "--seed")) return std::nullopt;
    (key == "--count" ? options.count : options.seed) = *value;
  }
  if (arguments.size() % 2 != 0 || options.count == 0) return std::nullopt;
  return options;
}

/// The number of features that too few of the levels have.
int printHistogram(const std::map<Feature, std::uint64_t>& counts, std::uint64_t levels) {
  int rare = 0;
  for (const auto& [feature, name] : kFeatures) {
    const auto found = counts.find(feature);
    const std::uint64_t count = found == counts.end() ? 0 : found->second;
    const double fraction = static_cast<double>(count) / static_cast<double>(levels);
    fmt::print("{:6} {:5.1f} %  {}{}\n", count, 100 * fraction, name,
               fraction < kLeastFraction ? "  <- rare" : "");
    if (fraction < kLeastFraction) ++rare;
  }
  return rare;
}

}  // namespace

int main(int argc, char** argv) {
  const auto options = parse(std::span(argv, static_cast<std::size_t>(argc)).subspan(1));
  if (!options) {
    fmt::print(stderr,
               "usage: random-levels-histogram [--count N] [--seed FIRST] [-o FOLDER]\n"
               "Prints how many of N random levels hold each feature; status 1 if less than 5 % "
               "hold one. With -o, writes the levels and their textures.\n");
    return kBadUsage;
  }
  tl::expected<void, std::string> written;
  if (options->folder) written = writeRandomLevelTextures(*options->folder / "textures");
  std::map<Feature, std::uint64_t> counts;
  for (std::uint64_t i = 0; i < options->count && written; ++i) {
    const RandomLevel level = makeRandomLevel(options->seed + i);
    for (const Feature feature : level.features) ++counts[feature];
    if (options->folder) written = writeRandomLevel(*options->folder, level);
  }
  if (!written) {
    fmt::print(stderr, "{}\n", written.error());
    return kBadUsage;
  }
  return printHistogram(counts, options->count) == 0 ? 0 : kFoundRare;
}
