#pragma once

#include <optional>
#include <string>

#include "viewer/preferences/bookmarks.h"

namespace hearth {

/// What is asked of a bookmark, by its name.
struct BookmarkWish {
  enum class What { Add, GoTo, WriteShot, Remove };
  What what;
  std::string name;
};

/// Which of these wishes the walk grants.
struct BookmarkRights {
  bool canJump = false;
  bool canWriteShots = false;
};

/// A section of the overlay.
class BookmarksSection {
 public:
  std::optional<BookmarkWish> show(const Bookmarks& bookmarks, const BookmarkRights& rights);

 private:
  std::string name_;  ///< as it is typed, for the next one
};

}  // namespace hearth
