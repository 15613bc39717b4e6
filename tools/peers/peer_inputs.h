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

/// A level, baked as it says.
struct PeerLevel {
  LoadedLevel loaded;
  BakedLight light;
  Renderer renderer;

  explicit PeerLevel(LoadedLevel level);
  PeerLevel(const PeerLevel&) = delete;
  PeerLevel& operator=(const PeerLevel&) = delete;
  /// Not lit by anything but its sectors' own light.
  static PeerLevel unlit(LoadedLevel level) { return {std::move(level), Unlit{}}; }

 private:
  struct Unlit {};
  PeerLevel(LoadedLevel level, Unlit);
};

/// What the rows of the table measure, each made when it is first asked for.
class PeerInputs {
 public:
  /// `levels` holds the castle and the tutorial.
  PeerInputs(std::filesystem::path levels, Clock clock);

  const Clock& clock() const { return clock_; }
  /// For files of a row: gone afterwards.
  const std::filesystem::path& folder() const { return folder_.path(); }

  std::filesystem::path keepFile() const { return levels_ / "keep.json"; }
  std::filesystem::path tutorialFile() const { return levels_ / "tutorial.json"; }
  /// A map of Freedoom, imported as it is when its play begins. The error says what is missing.
  tl::expected<std::filesystem::path, std::string> freedoomFile(const std::string& map);

  /// The error is what is wrong with the file.
  tl::expected<const PeerLevel*, std::string> level(const std::filesystem::path& file);
  tl::expected<const PeerLevel*, std::string> freedoomLevel(const std::string& map);
  /// With all its lights white: lightmaps have one channel.
  tl::expected<const PeerLevel*, std::string> greyLevel(const std::filesystem::path& file);

 private:
  std::filesystem::path levels_;
  Clock clock_;
  TemporaryFolder folder_;
  std::map<std::string, std::filesystem::path> freedoomFiles_;  ///< by the name of the map
  using PeerLevels = std::map<std::filesystem::path, std::unique_ptr<PeerLevel>>;
  PeerLevels ownLevels_;
  PeerLevels greyLevels_;
};

/// The map of Freedoom's 68 with the most texels of 1/8 m, 8.9 million: `hearth bake` prints them.
inline constexpr const char* kLargestMap = "MAP29";

/// The WAD of Freedoom that has a map.
std::filesystem::path freedoomWad(std::string_view map);

}  // namespace hearth
