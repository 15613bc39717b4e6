#include "cli/check/golden_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "image/compare.h"
#include "image/image_file.h"
#include "model/open_level.h"

namespace hearth {

namespace {

std::string figures(const PictureDifference& difference, std::size_t pixels) {
  return fmt::format(
      "{} of {} pixels differ, {} by more than 2 levels, {} by more than 8; largest difference {} "
      "of 255, largest patch {} pixel(s)",
      difference.differing, pixels, difference.over2, difference.over8, difference.largest,
      difference.largestPatch);
}

}  // namespace

GoldenFolders goldenFolders(const std::filesystem::path& level,
                            const std::optional<std::string>& root) {
  const std::filesystem::path parent = root ? std::filesystem::path(*root) : level.parent_path();
  const std::string name = (isModel(level) ? level.filename() : level.stem()).string();
  return {parent / (name + ".golden"), parent / (name + ".failed")};
}

bool isFileName(std::string_view name) {
  const auto isForbidden = [](char c) { return c == '/' || (c >= 0 && c < ' ') || c == 127; };
  return !name.starts_with('.') && std::ranges::none_of(name, isForbidden);
}

std::filesystem::path pictureFile(const std::filesystem::path& folder, std::string_view name,
                                  std::string_view ending) {
  return folder / fmt::format("{}{}", name, ending);
}

Comparison compareWithGolden(const std::filesystem::path& golden, const Image& drawn) {
  std::error_code error;
  if (!std::filesystem::exists(golden, error))
    return {
        Verdict::Missing, fmt::format("there is no {}, --update makes it", golden.string()), {}};
  const auto size = readImageSize(golden);
  if (!size) return {Verdict::Unreadable, size.error(), {}};
  if (*size != ImageSize{drawn.width(), drawn.height()})
    return {Verdict::OtherSize,
            fmt::format("{} has {}x{} pixels, the shot {}x{}", golden.string(), size->width,
                        size->height, drawn.width(), drawn.height()),
            {}};
  auto kept = readImage(golden, std::ssize(drawn.pixels()));
  if (!kept) return {Verdict::Unreadable, kept.error(), {}};
  const PictureDifference difference = compare(*kept, drawn);
  if (difference.differing == 0) return {Verdict::Same, "as kept", {}};
  return {Verdict::Differs, figures(difference, drawn.pixels().size()), std::move(*kept)};
}

std::vector<std::string> staleGoldens(const std::filesystem::path& folder,
                                      const std::vector<Shot>& shots) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string name = entry.path().stem().string();
    const bool isPicture = entry.path().extension() == ".png" && entry.is_regular_file(error);
    if (isPicture && std::ranges::find(shots, name, &Shot::name) == shots.end())
      names.push_back(name);
  }
  std::ranges::sort(names);
  return names;
}

}  // namespace hearth
