#pragma once

#include <filesystem>
#include <future>
#include <optional>
#include <string>
#include <vector>

#include "image/image.h"

namespace hearth {

/// Writes pictures as `hearth-LEVEL-1.png`, `-2` and so on, the first that is free: never over a
/// file. Threads of its own write, so that nothing waits for a disk.
class Screenshots {
 public:
  Screenshots(std::filesystem::path folder, const std::string& level)
      : folder_(std::move(folder)), stem_("hearth-" + level) {}

  /// `note` is to be printed beside the file's name.
  void take(const Image& picture, std::string note);

  /// What has become of the pictures, one at a time: "saved NAME", or what was wrong.
  struct News {
    bool isSaved;
    std::string text;
    std::string note;
  };
  std::optional<News> news();
  /// Of a picture that may still have to be written; nothing once all are.
  std::optional<News> awaitNews();

 private:
  std::filesystem::path folder_;
  std::string stem_;
  std::vector<std::future<News>> writing_;
};

}  // namespace hearth
