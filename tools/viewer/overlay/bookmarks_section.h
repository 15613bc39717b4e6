#pragma once

#include <optional>
#include <string>

#include "viewer/preferences/bookmarks.h"

namespace hearth {

/// What is asked of a bookmark, by its name.
struct BookmarkRequest {
  enum class What { Add, GoTo, WriteShot, Remove };
  What what;
  std::string name;
};

/// Which of these requests the walk grants.
struct BookmarkPermissions {
  bool canJump = false;
  bool canWriteShots = false;
};

/// A section of the overlay.
class BookmarksSection {
 public:
  std::optional<BookmarkRequest> show(const Bookmarks& bookmarks,
                                      const BookmarkPermissions& permissions);

 private:
  std::string name_;  ///< as it is typed, for the next one
};

}  // namespace hearth
