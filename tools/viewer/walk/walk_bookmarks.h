#pragma once

#include <string>

#include "level/scene.h"
#include "viewer/overlay/bookmarks_section.h"
#include "viewer/walk/walk_session.h"
#include "viewer/walk/walk_settings.h"

namespace hearth {

/// Keeps places of a walk, and takes the player back to them. Each function returns a message about
/// what it did.
class WalkBookmarks {
 public:
  /// Both must outlive it. The bookmarks, and the field of view that goes with them, are those of
  /// the settings.
  WalkBookmarks(WalkSession& session, WalkSettings& settings)
      : session_(session), settings_(settings) {}

  /// From now on there are no jumps: a recording with jumps would end elsewhere.
  void forbidJumps() { mayJump_ = false; }
  bool canJump() const { return mayJump_ && !session_.isRecording(); }

  std::string add(const Scene& scene, const std::string& name);
  std::string addHere(const Scene& scene) { return add(scene, settings_.bookmarks.freeName()); }
  /// Jumps to one after the other.
  std::string goToNext(const Scene& scene);
  std::string grant(const BookmarkRequest& request, const Scene& scene);

 private:
  std::string goTo(const Bookmark& bookmark, const Scene& scene);

  WalkSession& session_;
  WalkSettings& settings_;
  bool mayJump_ = true;
  std::size_t next_ = 0;
};

}  // namespace hearth
