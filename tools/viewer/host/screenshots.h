#pragma once

#include <optional>
#include <string>

#include "image/image.h"

namespace hearth {

/// Keeps pictures of a walk. Nothing waits for a disk.
class Screenshots {
 public:
  virtual ~Screenshots() = default;

  /// `note` is printed beside the file's name.
  virtual void take(const Image& picture, std::string note) = 0;

  /// News of the pictures, one at a time: "saved NAME", or what went wrong.
  struct News {
    bool isSaved;
    std::string text;
    std::string note;
  };
  virtual std::optional<News> news() = 0;
  /// Waits for news of a picture that is still being written; none once all are written.
  virtual std::optional<News> awaitNews() = 0;
};

}  // namespace hearth
