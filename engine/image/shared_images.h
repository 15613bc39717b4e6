#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "image/image.h"

namespace hearth {

/// Images that do not change. Copies share them. Moves are copies, so that what was moved from
/// still has its images.
class SharedImages {
 public:
  SharedImages() : SharedImages(std::vector<Image>{}) {}
  explicit SharedImages(std::vector<Image> images)
      : images_(std::make_shared<const std::vector<Image>>(std::move(images))) {}
  SharedImages(const SharedImages&) = default;
  SharedImages& operator=(const SharedImages&) = default;
  ~SharedImages() = default;

  operator const std::vector<Image>&() const { return *images_; }
  const Image& operator[](std::size_t index) const { return (*images_)[index]; }
  std::size_t size() const { return images_->size(); }
  auto begin() const { return images_->begin(); }
  auto end() const { return images_->end(); }

  /// Whether both are copies of the same images.
  bool sharesWith(const SharedImages& other) const { return images_ == other.images_; }

 private:
  std::shared_ptr<const std::vector<Image>> images_;
};

}  // namespace hearth
