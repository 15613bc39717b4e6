#pragma once

#include <string>
#include <tl/expected.hpp>

#include "load/load.h"
#include "viewer/host/storage.h"
#include "viewer/preferences/bookmarks.h"

namespace hearth {

/// Writes a bookmark as the last shot of its level into the level's file. All other bytes of the
/// file stay as they are. Refuses a name that a shot already has, and a file that has changed since
/// it was loaded. Errors are one sentence that begins with the path.
tl::expected<void, std::string> writeShot(Storage& storage, const LoadedLevel& loaded,
                                          const Bookmark& bookmark);

}  // namespace hearth
