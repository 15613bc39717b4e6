#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "folders/temporary_folder.h"
#include "light/bakery.h"
#include "load/load.h"
#include "measure/frame_times.h"
#include "render/renderer.h"

namespace hearth {

/// A level, baked with its own settings.
struct PeerLevel {
  LoadedLevel loaded;
  BakedLight light;
  Renderer renderer;

  explicit PeerLevel(LoadedLevel level);
  PeerLevel(const PeerLevel&) = delete;
  PeerLevel& operator=(const PeerLevel&) = delete;
  /// Without a bake: only the sectors' own light lights it.
  static PeerLevel unlit(LoadedLevel level) { return {std::move(level), Unlit{}}; }

 private:
  struct Unlit {};
  PeerLevel(LoadedLevel level, Unlit);
};

/// The inputs that the rows of the table measure. Each is made when it is first asked for.
class PeerInputs {
 public:
  /// `levels` holds the castle and the tutorial.
  PeerInputs(std::filesystem::path levels, Clock clock);

  const Clock& clock() const { return clock_; }
  /// For files that rows make. The destructor removes it.
  const std::filesystem::path& folder() const { return folder_.path(); }

  std::filesystem::path castleFile() const { return levels_ / "keep.json"; }
  std::filesystem::path tutorialFile() const { return levels_ / "tutorial.json"; }
  /// A map of Freedoom, imported with its doors closed, as play begins. The error says what is
  /// missing.
  tl::expected<std::filesystem::path, std::string> freedoomFile(const std::string& map);

  /// The level of a file, baked. The error says what is wrong with the file.
  tl::expected<const PeerLevel*, std::string> level(const std::filesystem::path& file);
  tl::expected<const PeerLevel*, std::string> freedoomLevel(const std::string& map);
  /// The same with all its lights white, so that lightmaps have one channel.
  tl::expected<const PeerLevel*, std::string> whiteLitLevel(const std::filesystem::path& file);

 private:
  std::filesystem::path levels_;
  Clock clock_;
  TemporaryFolder folder_;
  std::map<std::string, std::filesystem::path> freedoomFiles_;  ///< by the name of the map
  using PeerLevels = std::map<std::filesystem::path, std::unique_ptr<PeerLevel>>;
  PeerLevels ownLevels_;
  PeerLevels whiteLitLevels_;
};

/// The map with the most texels of Freedoom's 68: 8.9 million of 1/8 m. `hearth bake` prints the
/// number.
inline constexpr const char* kLargestMap = "MAP29";

/// The WAD of Freedoom that contains a map.
std::filesystem::path freedoomWad(std::string_view map);

}  // namespace hearth
