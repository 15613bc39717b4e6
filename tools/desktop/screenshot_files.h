#pragma once

#include <filesystem>
#include <future>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "viewer/host/screenshots.h"

namespace hearth {

/// Writes pictures as `hearth-LEVEL-1.png`, `-2` and so on, the first that is free: never over a
/// file. Threads of its own write.
class ScreenshotFiles : public Screenshots {
 public:
  ScreenshotFiles(std::filesystem::path folder, const std::string& level)
      : folder_(std::move(folder)), stem_("hearth-" + level) {}

  void take(const Image& picture, std::string note) override;
  std::optional<News> news() override;
  std::optional<News> awaitNews() override;

 private:
  std::filesystem::path folder_;
  std::string stem_;
  std::vector<std::future<News>> writing_;
};

}  // namespace hearth
