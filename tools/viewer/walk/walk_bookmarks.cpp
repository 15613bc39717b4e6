#include "viewer/walk/walk_bookmarks.h"

#include <fmt/format.h>

#include <vector>

namespace hearth {

std::string WalkBookmarks::add(const Scene& scene, const std::string& name) {
  const auto added =
      settings_.bookmarks.add(bookmarkOf(scene, session_.walker(), settings_.fov, name));
  return added ? fmt::format("bookmarked as {}", name) : added.error();
}

std::string WalkBookmarks::goToNext(const Scene& scene) {
  const std::vector<Bookmark>& all = settings_.bookmarks.all();
  if (all.empty()) return "there are no bookmarks yet";
  const std::size_t next = next_ % all.size();
  next_ = next + 1;
  return goTo(all[next], scene);
}

std::string WalkBookmarks::goTo(const Bookmark& bookmark, const Scene& scene) {
  if (!canJump()) return "no jumps in a walk that is recorded or replayed";
  const auto walker = walkerAt(scene, bookmark);
  if (!walker) return walker.error();
  session_.continueAt(*walker);
  settings_.fov = bookmark.fov;
  return bookmark.name;
}

std::string WalkBookmarks::grant(const BookmarkRequest& request, const Scene& scene) {
  using What = BookmarkRequest::What;
  if (request.what == What::Add) return add(scene, request.name);
  const Bookmark mark = *settings_.bookmarks.find(request.name);
  if (request.what == What::GoTo) return goTo(mark, scene);
  const bool isRemoved = request.what == What::Remove;
  const auto done =
      isRemoved ? settings_.bookmarks.remove(request.name) : settings_.writeShot(mark);
  if (!done) return done.error();
  return fmt::format("{} {}", isRemoved ? "forgot" : "wrote the shot", request.name);
}

}  // namespace hearth
