#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace hearth {

struct Tab {
  const char* name;
  std::function<void()> show;  ///< by calls of ImGui
};

/// The tabs of a panel. What the chosen tab shows is below them and scrolls by itself.
class TabBar {
 public:
  /// From now on shows the tab of that name.
  void turnTo(std::string_view name) { requested_ = name; }

  /// Where the tab that was shown is not among them any more, shows another.
  void show(std::span<const Tab> tabs);

 private:
  std::string shown_;
  std::optional<std::string> requested_;
  int frame_ = 0;  ///< as ImGui counts
};

}  // namespace hearth
