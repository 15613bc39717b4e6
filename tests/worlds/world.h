#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "agreement/tally.h"
#include "import/doom/light_table.h"
#include "import/doom/pictures.h"
#include "import/doom/wad.h"
#include "settings/options.h"

namespace hearth::worlds {

/// A WAD with all that maps take from it.
class Archive {
 public:
  /// The error is one sentence.
  static tl::expected<Archive, std::string> open(const std::filesystem::path& path);

  const doom::Wad& wad() const { return wad_; }
  const doom::Pictures& pictures() const { return pictures_; }

 private:
  Archive(doom::Wad wad, doom::Pictures pictures)
      : wad_(std::move(wad)), pictures_(std::move(pictures)) {}

  doom::Wad wad_;
  doom::Pictures pictures_;
};

/// Where a map is looked at, and how finely.
struct Looks {
  std::size_t places = 50;
  std::uint64_t seed = 1;
  ImageSize size{160, 100};
  double texel = 0.25;  ///< metres
};

/// What became of a map, and what it took.
struct World {
  std::string map;
  std::vector<std::string> errors;  ///< of import and loading: then nothing is seen of it
  std::size_t repairs = 0;          ///< findings of the import
  std::size_t sectors = 0;
  std::size_t segments = 0;
  std::int64_t texels = 0;
  double bakeSeconds = 0;        ///< on one thread
  double frameMilliseconds = 0;  ///< on one thread, median over the places, at 320x200
  agreement::Tally tally;

  bool isRight() const { return tally.views > 0 && tally.holes == 0 && tally.missed() == 0; }
};

/// Imports, loads and bakes a map, and holds what is seen of it against truth. Its files stand in
/// `folder` for the time.
World lookAt(const Archive& archive, const std::string& map, const Looks& looks,
             const std::filesystem::path& folder);

/// Of a table in Markdown.
std::string tableHead();
std::string tableRow(const World& world);

}  // namespace hearth::worlds
