#include "inputs/part_files.h"

#include <fmt/format.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "files/replace_file.h"
#include "inputs/inputs.h"
#include "inputs/progress.h"
#include "inputs/read_within_limit.h"
#include "settings/settings.h"
#include "settings/shell_text.h"

namespace hearth {

namespace {

/// `K/N` of a part.
std::string words(PartNumber number) { return fmt::format("{}/{}", number.part, number.parts); }

/// The command that bakes a part of the bake that the command line is about.
std::string commandFor(std::string_view part, std::string_view path, const OptionValues& values) {
  const std::vector<Option> options =
      std::vector<Option>{Option::Quality} + settingOptions() + limitOptions();
  return fmt::format("`{} bake {}{} --shard {} -o {}`", values.program, shellWord(values.level),
                     typedOptions(values, options), part, shellWord(path));
}

/// Numbers that rise, as `sbatch --array` takes them: 1,3-5,9.
std::string rangesOf(const std::vector<std::uint32_t>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    if (!text.empty()) text += ',';
    text +=
        last == i ? fmt::format("{}", numbers[i]) : fmt::format("{}-{}", numbers[i], numbers[last]);
    i = last + 1;
  }
  return text;
}

/// What is there of the part that is to be baked. None if it must be baked.
tl::expected<std::optional<PartNumber>, std::string> partThere(const BakeInParts& bake,
                                                               const std::string& path,
                                                               const OptionValues& values) {
  // What else is there cannot be replaced, which writing tells.
  if (std::error_code error; !std::filesystem::is_regular_file(path, error)) return std::nullopt;
  const auto bytes = readWithinLimit(path, values);
  if (!bytes) return tl::unexpected(bytes.error());
  const auto number = partNumberOf(bake, *bytes);
  if (number) return *number;
  fmt::print(stderr, "{}: warning: {}, and is baked again\n", path, number.error());
  return std::nullopt;
}

/// Parts of one bake, as they are found.
class FoundParts {
 public:
  FoundParts(const BakeInParts& bake, const OptionValues& values) : bake_(bake), values_(values) {}

  tl::expected<void, std::string> add(const std::string& path) {
    auto bytes = readWithinLimit(path, values_);
    if (!bytes) return tl::unexpected(bytes.error());
    const auto number = partNumberOf(bake_, *bytes);
    if (!number)
      return tl::unexpected(fmt::format("{} {}: bake it again with {}, or leave it out", path,
                                        number.error(), commandFor("K/N", path, values_)));
    if (paths_.empty()) paths_.resize(number->parts), bytes_.resize(number->parts);
    if (number->parts != paths_.size())
      return tl::unexpected(fmt::format("{} is part {}, but others are of {}: join parts of one N",
                                        path, words(*number), paths_.size()));
    const std::size_t index = number->part - 1;
    if (paths_[index].empty()) {
      paths_[index] = path;
      bytes_[index] = std::move(*bytes);
    } else if (bytes_[index] != *bytes) {
      return tl::unexpected(fmt::format(
          "{} and {} are both part {}, and differ: bake it again with {}", paths_[index], path,
          words(*number), commandFor(words(*number), path, values_)));
    }
    return {};
  }

  tl::expected<BakedLight, std::string> joined() const {
    if (const auto missing = missingParts(); !missing.empty())
      return tl::unexpected(fmt::format(
          "parts {} of {} are missing: bake each with {}", rangesOf(missing), paths_.size(),
          commandFor(fmt::format("K/{}", paths_.size()), "K.part", values_)));
    return joinParts(bake_, bytes_, threadsFrom(values_))
        .map_error([&](const JoinMistake& mistake) {
          const PartNumber number{static_cast<std::uint32_t>(mistake.part) + 1,
                                  static_cast<std::uint32_t>(paths_.size())};
          const std::string& path = paths_[mistake.part];
          return fmt::format("{} {}: remove it, and bake it again with {}", path, mistake.what,
                             commandFor(words(number), path, values_));
        });
  }

 private:
  std::vector<std::uint32_t> missingParts() const {
    std::vector<std::uint32_t> missing;
    for (std::size_t i = 0; i < paths_.size(); ++i)
      if (paths_[i].empty()) missing.push_back(static_cast<std::uint32_t>(i) + 1);
    return missing;
  }

  const BakeInParts& bake_;
  const OptionValues& values_;
  std::vector<std::string> paths_;  ///< by part; empty where it is not found yet
  std::vector<std::string> bytes_;  ///< of these
};

}  // namespace

tl::expected<BakeInParts, std::string> bakeInPartsFor(const Scene& scene,
                                                      const OptionValues& values) {
  return bakeSettingsFor(scene, values).map([&](const BakeSettings& settings) {
    return BakeInParts(scene, settings, optionsOf(settings));
  });
}

tl::expected<PartOutcome, std::string> bakePartFile(const BakeInParts& bake, PartNumber number,
                                                    const OptionValues& values) {
  const std::string path = *values.text(Option::Output);
  const auto there = partThere(bake, path, values);
  if (!there) return tl::unexpected(there.error());
  if (*there == number) return PartOutcome::WasThere;
  if (*there)
    return tl::unexpected(fmt::format("{} is part {} of this bake: give part {} a file of its own",
                                      path, words(**there), words(number)));
  const std::string bytes = [&] {
    BakeProgress progress;
    const ProgressDisplay display(progressStyle(values, ProgressStyle::Lines), progress);
    return bakePart(bake, number, threadsFrom(values), &progress);
  }();
  return replaceFile(path,
                     [&](std::ostream& stream) {
                       stream.write(bytes.data(), std::ssize(bytes));
                       return stream.good();
                     })
      .map([] { return PartOutcome::Baked; });
}

tl::expected<BakedLight, std::string> joinPartFiles(const BakeInParts& bake,
                                                    const OptionValues& values) {
  FoundParts found(bake, values);
  for (const std::string& path : values.texts(Option::Join))
    if (auto added = found.add(path); !added) return tl::unexpected(added.error());
  return found.joined();
}

}  // namespace hearth
