#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>

namespace hearth {

struct Page {
  const char* name;
  std::function<void()> show;  ///< by calls of ImGui
};

/// Pages of a panel, of which one shows: below a row of tabs, scrolled by itself.
class Pages {
 public:
  /// Shows that page from now on, by its number.
  void turnTo(std::size_t page) { asked_ = page; }

  /// The same pages each time.
  void show(std::span<const Page> pages);

 private:
  std::size_t shown_ = 0;
  std::optional<std::size_t> asked_;
  int frame_ = 0;  ///< as ImGui counts
};

}  // namespace hearth
