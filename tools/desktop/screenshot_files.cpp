#include "desktop/screenshot_files.h"

#include <fmt/format.h>

#include <chrono>
#include <tl/expected.hpp>
#include <utility>

#include "image/image_file.h"

namespace hearth {

namespace {

constexpr int kMaxScreenshots = 100000;  // of one level in one folder

tl::expected<std::string, std::string> writeNew(const std::filesystem::path& folder,
                                                const std::string& stem, const Image& picture) {
  for (int number = 1; number <= kMaxScreenshots; ++number) {
    const std::filesystem::path path = folder / fmt::format("{}-{}.png", stem, number);
    const auto created = createPng(path, picture);
    if (!created) return tl::unexpected(created.error());
    if (*created) return "saved " + path.filename().string();
  }
  return tl::unexpected(fmt::format("{} screenshots are enough", kMaxScreenshots));
}

}  // namespace

void ScreenshotFiles::take(const Image& picture, std::string note) {
  const auto write = [](const std::filesystem::path& folder, const std::string& stem,
                        const Image& image, std::string text) {
    const auto saved = writeNew(folder, stem, image);
    return News{saved.has_value(), saved ? *saved : saved.error(), std::move(text)};
  };
  writing_.push_back(
      std::async(std::launch::async, write, folder_, stem_, picture, std::move(note)));
}

std::optional<Screenshots::News> ScreenshotFiles::news() {
  for (auto it = writing_.begin(); it != writing_.end(); ++it) {
    if (it->wait_for(std::chrono::seconds(0)) != std::future_status::ready) continue;
    News news = it->get();
    writing_.erase(it);
    return news;
  }
  return std::nullopt;
}

std::optional<Screenshots::News> ScreenshotFiles::awaitNews() {
  if (writing_.empty()) return std::nullopt;
  writing_.front().wait();
  return news();
}

}  // namespace hearth
