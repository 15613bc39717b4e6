#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "desktop/background_baker.h"
#include "desktop/file_watch.h"
#include "load/source.h"
#include "settings/options.h"
#include "viewer/host/window_host.h"
#include "viewer/walk/walk_loop.h"
#include "viewer/walk/walk_session.h"

namespace hearth {

/// Lights the level of a walk, also where its movers come to rest. It can reload the level while
/// its files are edited: whenever one of them is saved, the level is loaded anew, and shows once it
/// is lit. A level with mistakes does not show; the mistakes stand over the last good version until
/// they are mended.
class LiveLevel {
 public:
  enum class Reload { No, Yes };

  /// Lights `loaded`, meanwhile. Without `reload`, level and settings of its light stay.
  LiveLevel(const OptionValues& values, const std::shared_ptr<const LoadedLevel>& loaded,
            std::shared_ptr<const LevelSource> source, Reload reload = Reload::Yes,
            std::chrono::milliseconds nextFile = BackgroundBaker::kNextFile);

  /// The light of the level as it was given, perhaps a draft. `wait` is called again and again.
  tl::expected<std::shared_ptr<const LitLevel>, std::string> awaitFirst(
      const std::function<void()>& wait);
  /// From now on draws by other options, at once; and bakes by them, if it may reload.
  void setOptions(const OptionValues& values);
  /// The last that was given out.
  const std::shared_ptr<const LitLevel>& shown() const { return shown_; }

  /// Call it between two frames.
  void update(WalkLoop& loop, WalkSession& session, WindowHost& outside);

 private:
  void reload(const FileWatch::Changes& changes, LightsEditor* lights);
  bool hasOtherLights(LightsEditor& lights);
  void take(const LevelNews& news, WalkLoop& loop, WalkSession& session);
  static bool continueIn(const LitLevel& next, WalkSession& session);
  void wantLight(const WalkLoop& loop);
  void watch(const LoadedLevel& loaded);

  Reload reload_;
  FileWatch watch_;
  std::vector<std::filesystem::path> watched_;  ///< files
  std::size_t lightsFile_ = 0;                  ///< among them
  BackgroundBaker baker_;
  std::vector<std::vector<double>> wanted_;  ///< states of movers, of the baker
  DrawSettings draw_;
  std::shared_ptr<const LitLevel> shown_;
  std::vector<std::string> mistakes_;           ///< of the version that was saved last
  std::optional<std::filesystem::path> saved_;  ///< and is not shown yet
  std::string report_;                          ///< to be printed once the next frame is shown
};

/// The place of a walker of one version of a level in another version: the same place, if a sector
/// contains it (one of the same name before others); else the player's start. None if there is no
/// such place.
std::optional<Walker> carriedOver(const Scene& from, const Walker& walker, const Scene& to);

}  // namespace hearth
