#include "viewer/overlay/bookmarks_section.h"

#include <imgui/imgui.h>

#include <algorithm>
#include <array>

namespace hearth {

namespace {

constexpr std::size_t kLongestBookmarkName = 64;

bool showMarkButton(const char* label, bool canBePressed) {
  ImGui::BeginDisabled(!canBePressed);
  const bool isPressed = ImGui::SmallButton(label);
  ImGui::EndDisabled();
  ImGui::SameLine();
  return isPressed;
}

}  // namespace

std::optional<BookmarkRequest> BookmarksSection::show(const Bookmarks& bookmarks,
                                                      const BookmarkPermissions& permissions) {
  using What = BookmarkRequest::What;
  std::optional<BookmarkRequest> request;
  std::array<char, kLongestBookmarkName + 1> typed{};
  name_.copy(typed.data(), kLongestBookmarkName);
  const std::string standard = bookmarks.freeName();
  const bool isEntered = ImGui::InputTextWithHint(
      "##name", standard.data(), typed.data(), typed.size(), ImGuiInputTextFlags_EnterReturnsTrue);
  name_ = typed.data();
  ImGui::SameLine();
  if (ImGui::Button("keep this place") || isEntered) {
    request = {What::Add, name_.empty() ? standard : name_};
    name_.clear();
  }
  for (const Bookmark& bookmark : bookmarks.all()) {
    ImGui::PushID(bookmark.name.data());
    if (showMarkButton("go", permissions.canJump)) request = {What::GoTo, bookmark.name};
    if (showMarkButton("write as a shot", permissions.canWriteShots))
      request = {What::WriteShot, bookmark.name};
    if (showMarkButton("forget", true)) request = {What::Remove, bookmark.name};
    ImGui::TextUnformatted(bookmark.name.data());
    ImGui::PopID();
  }
  return request;
}

}  // namespace hearth
