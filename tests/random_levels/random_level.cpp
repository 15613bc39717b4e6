#include "random_levels/random_level.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "image/image_file.h"
#include "random_levels/features.h"
#include "random_levels/level_json.h"
#include "random_levels/light_colors.h"
#include "random_levels/mesh.h"
#include "random_levels/middles.h"
#include "random_levels/obj_models.h"
#include "random_levels/placed_models.h"
#include "random_levels/places.h"
#include "random_levels/slopes.h"
#include "random_levels/spots.h"
#include "random_levels/sprites.h"
#include "random_levels/storeys.h"
#include "random_levels/suns.h"
#include "random_levels/walls.h"

namespace hearth {
namespace random_levels {
namespace {

constexpr std::size_t kLeastSectors = 3;
constexpr std::size_t kMaxSectors = 25;
constexpr double kMaxTexels = 10'000;
constexpr double kDefaultTexel = 0.125;  // m

struct LevelStyle {
  MeshStyle mesh;
  StoreyStyle storeys;
  WallStyle walls;
  double slopeFraction = 0;
};

void chooseMesh(Random& random, LevelStyle& style) {
  MeshStyle& mesh = style.mesh;
  const bool isSmall = random.chance(0.4);
  mesh.cellMin = isSmall ? 700'000 : 1'250'000;
  mesh.cellMax = isSmall ? 1'300'000 : 3'000'000;
  mesh.unit = random.pick<Um>({125'000, 62'500, 1'000, 100});
  mesh.isJittered = random.chance(0.6);
  mesh.turn = random.pick({Turn::None, Turn::None, Turn::None, Turn::Triangle345,
                           Turn::Triangle7And24And25, Turn::Quarter});
  mesh.columns = static_cast<std::size_t>(random.between(2, 4));
  mesh.rows = static_cast<std::size_t>(random.between(2, 4));
  mesh.insets = random.chance(0.7) ? static_cast<std::size_t>(random.between(1, 4)) : 0;
  mesh.splitFraction = random.chance(0.5) ? random.pick({0.1, 0.2, 0.4}) : 0;
  mesh.nearVertices = random.chance(0.35) ? static_cast<std::size_t>(random.between(1, 3)) : 0;
}

/// A row of small rooms to look along, and at times a second row of something else.
void makeChain(Random& random, LevelStyle& style) {
  style.mesh.columns = static_cast<std::size_t>(random.between(13, 16));
  style.mesh.rows = random.chance(0.5) ? 2 : 1;
  style.mesh.firstInsetRow = 1;
  style.mesh.cellMin = 500'000;
  style.mesh.cellMax = 1'000'000;
  style.storeys.chainLinks = style.mesh.columns;
  style.storeys.groundSectors = 3;
}

LevelStyle chooseStyle(Random& random) {
  LevelStyle style;
  chooseMesh(random, style);
  style.storeys.groundSectors = static_cast<std::size_t>(random.between(2, 7));
  style.storeys.voidFraction = random.pick({0.0, 0.0, 0.1, 0.25});
  style.storeys.storeys = random.pick<std::size_t>({1, 1, 1, 2, 2, 2, 3, 3, 4});
  style.storeys.skyFraction = random.chance(0.5) ? random.pick({0.4, 0.7, 1.0}) : 0;
  style.storeys.skyFloorFraction = random.chance(0.3) ? random.pick({0.3, 0.7}) : 0;
  style.storeys.hasDoors = random.chance(0.4);
  style.storeys.hasHyphens = random.chance(0.35);
  style.walls.stackFraction = random.pick({0.0, 0.15, 0.3, 0.6});
  style.walls.mergeFraction = random.pick({0.2, 0.5, 0.8});
  style.walls.wrongWinding = random.chance(0.2) ? 0.3 : 0;
  style.slopeFraction = random.pick({0.0, 0.0, 0.25, 0.4, 0.7});
  if (random.chance(0.15)) makeChain(random, style);
  return style;
}

/// About the area of all surfaces: m^2.
double surfaceArea(const Model& model) {
  double area = 0;
  for (const Sector& sector : model.sectors) {
    area += 2 * model.floorArea(sector);
    for (const Loop& loop : sector.loops) {
      for (std::size_t i = 0; i < loop.vertices.size(); ++i) {
        const VertexId next = loop.vertices[(i + 1) % loop.vertices.size()];
        area += distance(model.mesh.vertices[loop.vertices[i]], model.mesh.vertices[next]) *
                metres(sector.height());
      }
    }
  }
  return area;
}

Spelling chooseSpelling(Random& random, const Model& model) {
  Spelling spelling;
  spelling.hasSectorArray = random.chance(0.3);
  spelling.hasLoopArrays = random.chance(0.3);
  spelling.namesLightsFile = random.chance(0.5);
  spelling.omitsDefaults = random.chance(0.5);
  if (random.chance(0.5)) spelling.levelLight = random.pick({0.0, 0.1, 0.3, 0.6});
  const double area = surfaceArea(model);
  std::vector<double> texels;
  for (const double texel : {0.125, 0.25, 0.5, 1.0}) {
    if (area / (texel * texel) <= kMaxTexels) texels.push_back(texel);
  }
  spelling.texel = texels.empty() ? 1 : random.chance(0.6) ? texels[0] : random.pickFrom(texels);
  spelling.hasLightArray = spelling.texel == kDefaultTexel && random.chance(0.3);
  return spelling;
}

void chooseBake(Random& random, Spelling& spelling, std::set<Feature>& features) {
  if (spelling.hasLightArray) return;
  const double dice = random.unit();
  spelling.samples = dice < 0.09 ? 9 : dice < 0.23 ? 4 : 1;
  spelling.lambert = random.chance(0.25);
  if (spelling.samples == 4) features.insert(Feature::FourSamples);
  if (spelling.samples == 9) features.insert(Feature::NineSamples);
  if (spelling.lambert) features.insert(Feature::Lambert);
}

bool hasRoomForCameras(const Model& model) {
  return std::any_of(model.sectors.begin(), model.sectors.end(),
                     [](const Sector& sector) { return sector.height() >= kMetre; });
}

/// By numbers of their own, so that levels without them are what they would be anyway.
void chooseMiddles(std::uint64_t seed, Model& model) {
  Random random(~seed);
  if (random.chance(0.3)) hangMiddles(random, model, random.pick({0.1, 0.3, 0.6}));
}

/// By numbers of their own, too. More levels with middle textures have some, so that enough have
/// one behind such a texture: 30 % of all in the end.
std::vector<RandomSprite> chooseSprites(std::uint64_t seed, const Model& model,
                                        const std::vector<RandomView>& views,
                                        std::set<Feature>& features) {
  Random random(seed ^ 0x5370726974657321u);
  if (!random.chance(features.contains(Feature::MiddleTexture) ? 0.5 : 0.24)) return {};
  return makeSprites(random, model, views, features);
}

/// As sprites, and 30 % of all, too.
std::vector<PlacedModel> chooseModels(std::uint64_t seed, const Model& model,
                                      const std::vector<RandomView>& views,
                                      const std::vector<RandomSprite>& sprites,
                                      std::set<Feature>& features) {
  Random random(seed ^ 0x4d6f64656c73u);
  if (!random.chance(features.contains(Feature::MiddleTexture) ? 0.5 : 0.22)) return {};
  return placeModels(random, model, views, sprites, features);
}

/// By numbers of their own, too.
void chooseSpots(std::uint64_t seed, std::vector<RandomLight>& lights,
                 std::set<Feature>& features) {
  Random random(seed ^ 0x53706f7473u);
  if (random.chance(0.4)) makeSpots(random, lights, features);
}

/// Under at least one sky. The lights file of an array has none.
FarLights chooseFarLights(std::uint64_t seed, const Spelling& spelling,
                          std::set<Feature>& features) {
  if (spelling.hasLightArray || !features.contains(Feature::SkyCeiling)) return {};
  FarLights lights;
  Random ofSuns(seed ^ 0x53756e73u);
  if (ofSuns.chance(0.5)) lights.suns = makeSuns(ofSuns, features);
  Random ofSky(seed ^ 0x536b79u);
  if (ofSky.chance(0.3)) lights.sky = makeSky(ofSky, features);
  return lights;
}

Model makeModel(Random& random) {
  while (true) {
    const LevelStyle style = chooseStyle(random);
    Model model = makeStoreys(random, makeMesh(random, style.mesh), style.storeys);
    if (model.sectors.size() < kLeastSectors || model.sectors.size() > kMaxSectors ||
        !hasRoomForCameras(model)) {
      continue;
    }
    makeWalls(random, model, style.walls);
    makeSlopes(random, model, style.slopeFraction);
    return model;
  }
}

}  // namespace
}  // namespace random_levels

namespace {

// ---- files

tl::expected<void, std::string> writeText(const std::filesystem::path& path,
                                          const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) return tl::unexpected(fmt::format("{}: cannot be written", path.string()));
  return {};
}

tl::expected<void, std::string> makeFolder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    return tl::unexpected(fmt::format("{}: cannot be made: {}", folder.string(), error.message()));
  }
  return {};
}

/// Every texel of all the images gets another number; the odd factor spreads these over all
/// colours and is a bijection of 24-bit numbers.
Rgb colourOf(std::uint32_t number) {
  const std::uint32_t mixed = number * 0x9E3779B1u & 0xFFFFFFu;
  return {static_cast<std::uint8_t>(mixed >> 16), static_cast<std::uint8_t>(mixed >> 8 & 0xFF),
          static_cast<std::uint8_t>(mixed & 0xFF)};
}

tl::expected<void, std::string> writeModels(const std::filesystem::path& folder) {
  for (const random_levels::ObjModel& model : random_levels::objModels()) {
    if (auto written = writeText(folder / (model.name + ".obj"), objText(model)); !written)
      return written;
    const std::string materials = mtlText(model);
    if (materials.empty()) continue;
    if (auto written = writeText(folder / (model.name + ".mtl"), materials); !written)
      return written;
  }
  return {};
}

}  // namespace

RandomLevel makeRandomLevel(std::uint64_t seed) {
  using namespace random_levels;
  Random random(seed);
  Model model = makeModel(random);
  chooseMiddles(seed, model);
  RandomLevel level;
  level.name = fmt::format("level_{}", seed);
  level.features = featuresOf(model);
  Places places(random, model, level.features);
  level.views = places.views(static_cast<std::size_t>(random.between(4, 6)));
  std::vector<RandomLight> lights = places.lights(static_cast<std::size_t>(random.between(0, 6)));
  Spelling spelling = chooseSpelling(random, model);
  makeColorsAndCurves(random, lights, level.features);
  chooseSpots(seed, lights, level.features);
  chooseBake(random, spelling, level.features);
  const std::vector<RandomSprite> sprites = chooseSprites(seed, model, level.views, level.features);
  const std::vector<PlacedModel> models =
      chooseModels(seed, model, level.views, sprites, level.features);
  level.levelJson = levelJson(model, level.name, level.views, sprites, models, spelling);
  const FarLights farLights = chooseFarLights(seed, spelling, level.features);
  level.lightsJson = lightsJson(model, lights, farLights, spelling);
  if (lights.empty() && farLights.areNone()) level.features.insert(Feature::NoLights);
  const bool hasArrays = spelling.hasSectorArray || spelling.hasLoopArrays;
  const bool hasObjects = !spelling.hasSectorArray || !spelling.hasLoopArrays;
  if (hasArrays) level.features.insert(Feature::Arrays);
  if (hasObjects) level.features.insert(Feature::Objects);
  return level;
}

tl::expected<void, std::string> writeRandomLevelTextures(const std::filesystem::path& folder) {
  if (auto made = makeFolder(folder); !made) return made;
  std::uint32_t number = 0;
  const auto write = [&](const RandomTexture& texture, double holes) {
    Image image(texture.width, texture.height);
    for (int y = 0; y < texture.height; ++y) {
      for (int x = 0; x < texture.width; ++x) {
        image.at(x, y) = colourOf(++number);
        if (random_levels::Random(number).chance(holes)) image.makeHole(x, y);
      }
    }
    return writePng(folder / fmt::format("{}.png", texture.name), image);
  };
  for (const RandomTexture& texture : kRandomLevelTextures)
    if (auto written = write(texture, 0); !written) return written;
  for (const RandomTexture& texture : kRandomLevelMiddles)
    if (auto written = write(texture, 0.5); !written) return written;
  return writeModels(folder);
}

tl::expected<void, std::string> writeRandomLevel(const std::filesystem::path& folder,
                                                 const RandomLevel& level) {
  if (auto made = makeFolder(folder); !made) return made;
  if (auto written = writeText(folder / (level.name + ".json"), level.levelJson); !written) {
    return written;
  }
  return writeText(folder / (level.name + ".lights.json"), level.lightsJson);
}

}  // namespace hearth
