#pragma once

#include <optional>
#include <string>

#include "image/image.h"

namespace hearth {

/// Keeps pictures of a walk. Nothing waits for a disk.
class Screenshots {
 public:
  virtual ~Screenshots() = default;

  /// `note` is to be printed beside the file's name.
  virtual void take(const Image& picture, std::string note) = 0;

  /// What has become of the pictures, one at a time: "saved NAME", or what was wrong.
  struct News {
    bool isSaved;
    std::string text;
    std::string note;
  };
  virtual std::optional<News> news() = 0;
  /// Of a picture that may still have to be written; nothing once all are.
  virtual std::optional<News> awaitNews() = 0;
};

}  // namespace hearth
