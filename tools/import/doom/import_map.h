#pragma once

#include <filesystem>
#include <string>
#include <tl/expected.hpp>

#include "import/doom/findings.h"
#include "import/doom/heights.h"
#include "import/doom/light_table.h"
#include "import/doom/lights.h"
#include "import/doom/materials.h"
#include "import/doom/pictures.h"
#include "import/doom/things.h"
#include "import/doom/wad.h"

namespace hearth::doom {

/// The input of an import, except the map.
struct Source {
  const Wad& wad;
  const Pictures& pictures;
  const LightTable& lights;
};

struct ImportSettings {
  std::filesystem::path folder;  ///< where the level goes; it need not be there
  Doors doors = Doors::Moving;
  /// The fraction of the sectors' light in the map: low enough for the light of lamps to show.
  double ambient = 0.75;
  ThingSettings things{};
  std::size_t imagePixels = kMaxPixels;  ///< of all its images together
  LightFrom lightFrom = LightFrom::Points;
  std::size_t lights = kMaxLights;  ///< at points, at most
};

/// The result of importing one map.
struct Imported {
  std::string map;
  std::filesystem::path level;
  /// Of the map, and of the level.
  std::size_t mapSectors = 0;
  std::size_t sectors = 0;
  std::size_t lines = 0;
  std::size_t walls = 0;
  std::size_t mapThings = 0;
  std::size_t sprites = 0;
  std::size_t lights = 0;  ///< at points
  std::size_t emitters = 0;
  std::size_t textures = 0;
  std::size_t movers = 0;
  std::vector<LineFate> specials;  ///< all lines of the map that do something; none if frozen
  Findings findings;
};

/// A level before it is written.
struct Converted {
  std::string level;   ///< the text of its file
  std::string lights;  ///< and of that of its lights
  Materials materials;
};

/// Fills in `imported`, which must outlive the result. The error is one sentence.
tl::expected<Converted, std::string> convertMap(const Source& source, const std::string& name,
                                                const ImportSettings& settings, Imported& imported);

/// Writes the level of a map with its lights and textures; never over a level that is there, and
/// only one that loads. The error is one sentence.
tl::expected<Imported, std::string> importMap(const Source& source, const std::string& name,
                                              const ImportSettings& settings);

}  // namespace hearth::doom
