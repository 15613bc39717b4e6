#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "image/image.h"
#include "import/doom/findings.h"
#include "import/doom/pictures.h"

namespace hearth::doom {

/// A name of a WAD as that of a file, in lower case: what is neither a letter nor a digit as its
/// number, so that it leads to no other folder.
std::string fileName(const std::string& name);
/// The image of a wall's texture or of a flat, as a level names it.
std::string wallImage(const std::string& texture);
std::string flatImage(const std::string& flat);

/// How an image lies on a wall.
struct Hanging {
  int xOffset = 0;   ///< texels by which it is shifted to the left, ...
  int yOffset = 0;   ///< ... and up
  double along = 0;  ///< metres of the wall to the left of its first point
  std::optional<double>
      top;  ///< metres, where the image's first row begins; none: as Hearth has it
};

/// Of all images of one level together: sixteen times as many as the largest map of Freedoom needs.
inline constexpr std::size_t kMaxPixels = std::size_t{1} << 26;

/// The textures of a level, made of the pictures that its map asks for.
class Materials {
 public:
  /// `map` decides which sky it is.
  Materials(const Pictures& pictures, const std::string& map, Findings& findings,
            std::size_t maxPixels = kMaxPixels);

  /// As levels write them. Walls and flats that cannot be drawn are grey.
  nlohmann::ordered_json wall(const std::string& name, const Hanging& hanging);
  nlohmann::ordered_json flat(const std::string& name);
  /// The name of the image that a switch shows while it is on, in place of this texture: SW1 and
  /// SW2 begin the names of pairs (https://doomwiki.org/wiki/Switch). None of another texture.
  std::optional<std::string> switched(const std::string& name);
  /// One sees through its holes. None where it cannot be drawn.
  std::optional<nlohmann::ordered_json> middle(const std::string& name, const Hanging& hanging);
  nlohmann::ordered_json sky();
  /// The image of the sky; null if it has not been asked for, or cannot be drawn.
  const Image* skyImage() const;
  /// Metres from the first row of a wall's image to the end of its last.
  double heightOf(const std::string& name) const;

  /// The image of a file; null if there is none yet.
  const Image* find(const std::string& file) const;
  /// Counts an image before memory is taken for it: a small hostile WAD may define thousands of
  /// large ones. False where the images would have too many pixels.
  bool takePixels(ImageSize size);
  void add(const std::string& file, Image image);

  /// Writes what has been asked for as PNG files. The error is one sentence.
  tl::expected<void, std::string> write(const std::filesystem::path& folder) const;
  std::size_t count() const { return images_.size(); }

 private:
  enum class Kind : std::uint8_t { Wall, Flat };
  std::string skyFile() const { return "sky-" + fileName(skyName_); }
  bool draw(const std::string& file, Kind kind, const std::string& name,
            std::string_view otherwise);
  tl::expected<Picture, std::string> decode(Kind kind, const std::string& name);
  nlohmann::ordered_json hung(const std::string& file, const Hanging& hanging) const;

  const Pictures& pictures_;
  std::string skyName_;
  Findings& findings_;
  std::size_t pixelsLeft_;
  std::map<std::string, Image> images_;  ///< by file, without its extension
  std::set<std::string> undrawn_;        ///< files
};

}  // namespace hearth::doom
