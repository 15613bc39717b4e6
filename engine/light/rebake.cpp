#include "light/rebake.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "light/baking/baked_surface.h"
#include "light/baking/bounces.h"
#include "light/baking/light_dependencies.h"
#include "light/baking/light_visibility.h"
#include "light/baking/lightmap_builder.h"
#include "light/baking/mesh_light.h"
#include "light/baking/sprite_light.h"
#include "light/baking/surface_light.h"
#include "light/baking/texel_sums.h"
#include "light/kept_light.h"
#include "light/light_fingerprints.h"
#include "math/check.h"
#include "math/parallel.h"

namespace hearth {

LightMemory::LightMemory(std::size_t maxBytes) : kept_(std::make_unique<Kept>()) {
  kept_->maxBytes = maxBytes;
}

LightMemory::~LightMemory() = default;

void LightMemory::keepBakes(std::size_t count) {
  CHECK(count > 0, count);
  kept_->maxBakes = count;
}

std::size_t LightMemory::bytes() const { return kept_->bytes; }

class Rebake::Baker {
 public:
  Baker(LightMemory::Kept& memory, const Scene& scene, const BakeSettings& settings, int threads);

  std::int64_t texelLightsLeft() const { return texelLightsLeft_; }
  BakedLight draft() const;
  std::optional<BakedLight> finish(BakeProgress& progress, const std::stop_token& stop);

 private:
  using Number = LightMemory::Kept::Number;
  using Contribution = LightMemory::Kept::Contribution;
  using Surface = LightMemory::Kept::Surface;
  using Mesh = LightMemory::Kept::Mesh;

  /// What is known of a surface, and what is not.
  struct Plan {
    std::shared_ptr<const Surface> same;  ///< if it was lit so before
    std::vector<std::size_t> facing;      ///< lights
    std::vector<std::shared_ptr<const Contribution>>
        known;                      ///< of these; null where it is left to find
    std::vector<std::size_t> left;  ///< lights without a known contribution
    std::vector<Number> samplesOn;  ///< surfaces, for what is known
  };

  void findNumbers();
  bool areThere(const std::vector<Number>& numbers) const;
  Plan planFor(SurfaceId id) const;
  void takeKnown(const Surface& old, Plan& plan) const;
  std::shared_ptr<const Mesh> knownMesh(std::uint32_t mesh) const;
  bool needBounced() const;
  std::vector<std::size_t> byFallingWork() const;
  std::size_t lightsAtOnce(SurfaceId id) const;
  std::int64_t texelsOfRounds() const;
  std::shared_ptr<const Surface> lit(SurfaceId id, BakeProgress& progress,
                                     const std::stop_token& stop) const;
  void findLeft(SurfaceId id, const UsedTexels& texels, Surface& found, BakeProgress& progress,
                const std::stop_token& stop) const;
  Contribution contributionOf(std::size_t light, const SurfaceLight& surface, const TexelSums& sums,
                              LightDependencies& dependencies) const;
  TexelSums sumsFor(SurfaceId id) const;
  void addSectorsOf(std::size_t light, SectorSet& sectors) const;
  std::vector<Number> numbersOf(const SectorSet& sectors) const;
  std::vector<std::uint64_t> lightsOn(std::uint32_t mesh) const;
  std::vector<std::shared_ptr<const Mesh>> litMeshes(BakeProgress& progress,
                                                     const std::stop_token& stop) const;
  BakedLight collect(std::span<const std::shared_ptr<const Surface>> lit,
                     std::span<const std::shared_ptr<const Mesh>> meshes) const;
  void remember(std::span<const std::shared_ptr<const Surface>> surfaces,
                std::span<const std::shared_ptr<const Mesh>> meshes);
  std::optional<Lightmap> draftOf(SurfaceId id, const LightVisibilities& visibilities) const;
  /// Without light that bounces, which a draft leaves out.
  Scene unbounced() const { return {scene_.level(), scene_.geometry()}; }
  void draftMeshes(const LightVisibilities& visibilities, const BakeSettings& settings,
                   BakedLight& baked) const;

  LightMemory::Kept& memory_;
  Bounces bounces_;
  Scene scene_;  ///< with light that bounces
  BakeSettings settings_;
  int threads_;
  std::shared_ptr<const LitSurfaces> made_;
  const LitSurfaces& surfaces_;
  LightFingerprints prints_;
  LightVisibilities visibilities_;
  std::vector<Number> sectorNumbers_;   ///< by SectorId
  std::vector<Number> surfaceNumbers_;  ///< by SurfaceId
  std::vector<bool> isPresent_;         ///< by number
  std::vector<Plan> plans_;             ///< by SurfaceId
  std::int64_t texelLightsLeft_ = 0;
  std::vector<LitMesh> meshes_;  ///< in the level's order
  MeshLighter lighter_;
  std::vector<std::shared_ptr<const Mesh>> knownMeshes_;  ///< null where one is left to light
  std::vector<std::uint32_t> meshesLeft_;
};

namespace {

std::vector<std::uint32_t> allOf(const std::vector<LitMesh>& meshes) {
  std::vector<std::uint32_t> all(meshes.size());
  std::iota(all.begin(), all.end(), 0U);
  return all;
}

}  // namespace

Rebake::Rebake(LightMemory& memory, const Scene& scene, const BakeSettings& settings, int threads)
    : baker_(std::make_unique<Baker>(*memory.kept_, scene, settings, threads)) {}

Rebake::~Rebake() = default;

std::int64_t Rebake::texelLightsLeft() const { return baker_->texelLightsLeft(); }

BakedLight Rebake::draft() const { return baker_->draft(); }

std::optional<BakedLight> Rebake::finish(BakeProgress* progress, const std::stop_token& stop) {
  BakeProgress unwatched;
  return baker_->finish(progress ? *progress : unwatched, stop);
}

// --- What is to be done --------------------------------------------------------------------------

Rebake::Baker::Baker(LightMemory::Kept& memory, const Scene& scene, const BakeSettings& settings,
                     int threads)
    : memory_(memory),
      bounces_(scene, settings, threads),
      scene_(bounces_.scene()),
      settings_(settings),
      threads_(threads),
      made_(memory.surfacesOf(scene, settings.texel)),
      surfaces_(*made_),
      prints_(lightFingerprints(scene_, surfaces_)),
      visibilities_(scene_, settings, LightVisibilities::Purpose::Bake,
                    [this] { return bounces_.irradiance(); }),
      plans_(surfaces_.size()),
      meshes_(makeLitMeshes(scene.level(), settings.texel, threads)),
      lighter_(scene_, visibilities_, settings_, threads, allOf(meshes_), meshes_) {
  if (memory.settings != settings) memory.clear();
  memory.settings = settings;
  findNumbers();
  parallelFor(surfaces_.size(), threads, [&](std::size_t i) {
    if (surfaces_[i]) plans_[i] = planFor(SurfaceId(i));
  });
  for (const std::uint32_t mesh : allOf(meshes_)) {
    knownMeshes_.push_back(knownMesh(mesh));
    if (knownMeshes_.back()) continue;
    meshesLeft_.push_back(mesh);
    texelLightsLeft_ += meshes_[mesh].texels.count() * std::ssize(lighter_.lightsOf(mesh).lights());
  }
  for (std::size_t i = 0; i < surfaces_.size(); ++i)
    if (surfaces_[i]) texelLightsLeft_ += surfaces_[i]->texels.count() * std::ssize(plans_[i].left);
}

void Rebake::Baker::findNumbers() {
  for (const std::uint64_t print : prints_.sectors)
    sectorNumbers_.push_back(memory_.numberOf(print));
  for (const std::uint64_t print : prints_.surfaces)
    surfaceNumbers_.push_back(memory_.numberOf(print));
  isPresent_.resize(memory_.numbers.size());
  for (const auto* numbers : {&sectorNumbers_, &surfaceNumbers_})
    for (const Number number : *numbers) isPresent_[number] = true;
}

/// Whether the level still has what these stand for.
bool Rebake::Baker::areThere(const std::vector<Number>& numbers) const {
  return std::ranges::all_of(numbers, [this](Number number) { return isPresent_[number]; });
}

Rebake::Baker::Plan Rebake::Baker::planFor(SurfaceId id) const {
  Plan plan;
  plan.facing = SurfaceLight(scene_, surfaces_, visibilities_, settings_.lambert, id).facing();
  plan.known.resize(plan.facing.size());
  for (const LightMemory::Kept::OneBake& bake : memory_.bakes) {
    const auto old = bake.surfaces.find(prints_.surfaces[id.index()]);
    if (old == bake.surfaces.end() || !areThere(old->second->samplesOn)) continue;
    takeKnown(*old->second, plan);
    if (plan.known == old->second->contributions) {
      plan.same = old->second;
      return plan;
    }
  }
  for (std::size_t i = 0; i < plan.facing.size(); ++i)
    if (!plan.known[i]) plan.left.push_back(plan.facing[i]);
  return plan;
}

/// What a bake before found, on surfaces and through sectors that are there.
void Rebake::Baker::takeKnown(const Surface& old, Plan& plan) const {
  bool hasTaken = false;
  for (std::size_t i = 0; i < plan.facing.size(); ++i) {
    if (plan.known[i]) continue;
    auto contribution = old.contributionOf(prints_.lights[plan.facing[i]]);
    if (!contribution || !areThere(contribution->sectors)) continue;
    plan.known[i] = std::move(contribution);
    hasTaken = true;
  }
  if (hasTaken)
    plan.samplesOn.insert(plan.samplesOn.end(), old.samplesOn.begin(), old.samplesOn.end());
}

/// Null if it was not lit before, or by other lights or through other sectors.
std::shared_ptr<const LightMemory::Kept::Mesh> Rebake::Baker::knownMesh(std::uint32_t mesh) const {
  const std::vector<std::uint64_t> lights = lightsOn(mesh);
  for (const LightMemory::Kept::OneBake& bake : memory_.bakes) {
    const auto old = bake.meshes.find(prints_.meshes[mesh]);
    if (old != bake.meshes.end() && old->second->lights == lights && areThere(old->second->sectors))
      return old->second;
  }
  return nullptr;
}

/// Prints of those that may shine on a mesh.
std::vector<std::uint64_t> Rebake::Baker::lightsOn(std::uint32_t mesh) const {
  std::vector<std::uint64_t> lights;
  for (const std::size_t light : lighter_.lightsOf(mesh).lights())
    lights.push_back(prints_.lights[light]);
  return lights;
}

/// Largest first, so that no thread starts the longest job last.
std::vector<std::size_t> Rebake::Baker::byFallingWork() const {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < surfaces_.size(); ++i)
    if (surfaces_[i]) order.push_back(i);
  const auto work = [&](std::size_t i) {
    return surfaces_[i]->texels.count() * (1 + std::ssize(plans_[i].left));
  };
  std::ranges::stable_sort(order, std::ranges::greater(), work);
  return order;
}

// --- The light -----------------------------------------------------------------------------------

std::optional<BakedLight> Rebake::Baker::finish(BakeProgress& progress,
                                                const std::stop_token& stop) {
  progress.begin(texelsOfRounds() + lighter_.texelsOf(meshesLeft_));
  if (needBounced() && !bounces_.find(progress, stop)) return std::nullopt;
  std::vector<std::shared_ptr<const Surface>> surfaces(surfaces_.size());
  const std::vector<std::size_t> order = byFallingWork();
  parallelFor(order.size(), threads_, [&](std::size_t job) {
    if (stop.stop_requested()) return;
    auto surface = lit(SurfaceId(order[job]), progress, stop);
    if (!stop.stop_requested()) surfaces[order[job]] = std::move(surface);
  });
  const auto meshes = litMeshes(progress, stop);
  const bool isWhole =
      std::ranges::all_of(order, [&](std::size_t i) { return surfaces[i] != nullptr; }) &&
      std::ranges::all_of(meshes, [](const auto& mesh) { return mesh != nullptr; });
  if (isWhole || memory_.bakes.empty()) memory_.begin();
  remember(surfaces, meshes);
  if (!isWhole) return std::nullopt;
  return collect(surfaces, meshes);
}

/// Whether anything is left that light bounces to. The light of all areas is found together;
/// sprites are always lit anew.
bool Rebake::Baker::needBounced() const {
  return bounces_.haveLight() &&
         (!meshesLeft_.empty() || !scene_.level().sprites.empty() ||
          std::ranges::any_of(plans_, [this](const Plan& plan) {
            return std::ranges::any_of(
                plan.left, [this](std::size_t light) { return scene_.lights()[light].isArea(); });
          }));
}

/// So that the sums of the lights take no more than 32 MB.
std::size_t Rebake::Baker::lightsAtOnce(SurfaceId id) const {
  const auto texels = static_cast<std::size_t>(surfaces_[id.index()]->texels.count());
  return std::max(std::size_t{1}, (std::size_t{32} << 20) / (texels * 3 * sizeof(double)));
}

/// Texels, as often as samples are placed on them.
std::int64_t Rebake::Baker::texelsOfRounds() const {
  std::int64_t texels = 0;
  for (std::size_t i = 0; i < plans_.size(); ++i) {
    if (plans_[i].left.empty()) continue;
    const std::size_t atOnce = lightsAtOnce(SurfaceId(i));
    const std::size_t rounds = (plans_[i].left.size() + atOnce - 1) / atOnce;
    texels += surfaces_[i]->texels.count() * static_cast<std::int64_t>(rounds);
  }
  return texels;
}

std::shared_ptr<const LightMemory::Kept::Surface> Rebake::Baker::lit(
    SurfaceId id, BakeProgress& progress, const std::stop_token& stop) const {
  const Plan& plan = plans_[id.index()];
  if (plan.same) return plan.same;
  Surface surface;
  for (const std::size_t light : plan.facing) surface.lights.push_back(prints_.lights[light]);
  surface.contributions = plan.known;
  surface.samplesOn = plan.samplesOn;
  if (!plan.facing.empty()) {
    const UsedTexels texels(*surfaces_[id.index()], surfaces_[id.index()]->texels);
    if (!plan.left.empty()) findLeft(id, texels, surface, progress, stop);
    std::ranges::sort(surface.samplesOn);
    surface.samplesOn.erase(std::unique(surface.samplesOn.begin(), surface.samplesOn.end()),
                            surface.samplesOn.end());
    TexelSums sums = sumsFor(id);
    for (const auto& contribution : surface.contributions) sums.add(contribution->sums);
    LightmapBuilder map(texels, settings_.samples.value_or(1));
    map.add(sums);
    surface.lightmap =
        finishedLightmap(SurfacePlaces(scene_, surfaces_, id), std::move(map), settings_);
  }
  return std::make_shared<const Surface>(std::move(surface));
}

TexelSums Rebake::Baker::sumsFor(SurfaceId id) const {
  const bool isColored = std::ranges::any_of(plans_[id.index()].facing, [this](std::size_t light) {
    return scene_.lights()[light].isColored();
  });
  return {surfaces_[id.index()]->texels, isColored ? 3 : 1};
}

/// Computes the contributions of the lights that are left.
void Rebake::Baker::findLeft(SurfaceId id, const UsedTexels& texels, Surface& found,
                             BakeProgress& progress, const std::stop_token& stop) const {
  LightDependencies dependencies;
  SurfaceLight surface(scene_, surfaces_, visibilities_, settings_.lambert, id,
                       VisibilityMethod::Shafts, &dependencies);
  std::span<const std::size_t> left = plans_[id.index()].left;
  auto contribution = found.contributions.begin();
  for (const std::size_t atOnce = lightsAtOnce(id); !left.empty();) {
    const auto lights = left.first(std::min(atOnce, left.size()));
    left = left.subspan(lights.size());
    std::map<std::size_t, TexelSums> sums;
    for (const std::size_t light : lights)
      sums.try_emplace(light, texels.rect(), scene_.lights()[light].isColored() ? 3 : 1);
    addLights(
        surface, texels, lights, settings_,
        [&](std::size_t light) -> TexelSums& { return sums.at(light); }, progress, stop);
    for (const std::size_t light : lights) {
      contribution = std::find(contribution, found.contributions.end(), nullptr);
      *contribution = std::make_shared<const Contribution>(
          contributionOf(light, surface, sums.at(light), dependencies));
    }
  }
  for (const SurfaceId sought : dependencies.surfaces().sorted())
    found.samplesOn.push_back(surfaceNumbers_[sought.index()]);
}

Rebake::Baker::Contribution Rebake::Baker::contributionOf(std::size_t light,
                                                          const SurfaceLight& surface,
                                                          const TexelSums& sums,
                                                          LightDependencies& dependencies) const {
  SectorSet& met = dependencies.sectorsOf(light);
  if (!sums.isDark() || dependencies.isSampleInMesh())
    for (const SectorId sector : dependencies.sampleSectors().sorted()) met.add(sector);
  addSectorsOf(light, met);
  return {sums.cropped(), surface.costs()[light], numbersOf(met)};
}

/// Those that decide which part of a light shines.
void Rebake::Baker::addSectorsOf(std::size_t light, SectorSet& sectors) const {
  for (const SectorId sector : visibilities_.sectorsOf(light)) sectors.add(sector);
}

std::vector<LightMemory::Kept::Number> Rebake::Baker::numbersOf(const SectorSet& sectors) const {
  std::vector<Number> numbers;
  for (const SectorId sector : sectors.sorted()) numbers.push_back(sectorNumbers_[sector.index()]);
  return numbers;
}

/// Lights those that are left.
std::vector<std::shared_ptr<const LightMemory::Kept::Mesh>> Rebake::Baker::litMeshes(
    BakeProgress& progress, const std::stop_token& stop) const {
  std::vector<std::shared_ptr<const Mesh>> meshes = knownMeshes_;
  auto found = lighter_.find(meshesLeft_, progress, stop);
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!found[i]) continue;
    const std::uint32_t mesh = meshesLeft_[i];
    SectorSet met;
    for (const SectorId sector : lighter_.sectorsOf(mesh)) met.add(sector);
    const LightsOnMesh& lights = lighter_.lightsOf(mesh);
    lights.addSectorsTo(met);
    for (const std::size_t light : lights.lights()) addSectorsOf(light, met);
    met.add(std::exchange(found[i]->met, {}));
    meshes[mesh] =
        std::make_shared<const Mesh>(Mesh{lightsOn(mesh), numbersOf(met), *std::move(found[i])});
  }
  return meshes;
}

BakedLight Rebake::Baker::collect(std::span<const std::shared_ptr<const Surface>> lit,
                                  std::span<const std::shared_ptr<const Mesh>> meshes) const {
  BakedLight baked;
  baked.surfaces = surfaces_;
  baked.lightmaps.resize(lit.size());
  baked.surfaceCosts.resize(lit.size());
  baked.lightCosts.resize(scene_.lights().size());
  for (std::size_t i = 0; i < lit.size(); ++i) {
    if (!lit[i]) continue;
    const std::vector<std::size_t>& facing = plans_[i].facing;
    baked.lightmaps[i] = lit[i]->lightmap;
    baked.surfaceCosts[i].facingLights = facing.size();
    for (std::size_t k = 0; k < facing.size(); ++k) {
      const LightCost& cost = lit[i]->contributions[k]->cost;
      baked.lightCosts[facing[k]] += cost;
      baked.surfaceCosts[i].rays += cost.rays;
    }
  }
  baked.meshes = meshes_;
  lightSprites(scene_, visibilities_, threads_, baked);
  for (std::uint32_t i = 0; i < meshes.size(); ++i) lighter_.add(i, meshes[i]->light, baked);
  baked.stats = statsOf(baked);
  return baked;
}

/// As many as there is room for.
void Rebake::Baker::remember(std::span<const std::shared_ptr<const Surface>> surfaces,
                             std::span<const std::shared_ptr<const Mesh>> meshes) {
  LightMemory::Kept::OneBake& bake = memory_.bakes.front();
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    if (surfaces[i]) memory_.keep(bake.surfaces, prints_.surfaces[i], surfaces[i]);
  for (std::size_t i = 0; i < meshes.size(); ++i)
    if (meshes[i]) memory_.keep(bake.meshes, prints_.meshes[i], meshes[i]);
}

// --- A draft -------------------------------------------------------------------------------------

BakedLight Rebake::Baker::draft() const {
  BakeSettings points = settings_;
  points.softSamples = 0;
  const LightVisibilities visibilities(unbounced(), points, LightVisibilities::Purpose::Draft);
  BakedLight baked;
  baked.surfaces = surfaces_;
  baked.lightmaps.resize(surfaces_.size());
  const std::vector<std::size_t> order = byFallingWork();
  parallelFor(order.size(), threads_, [&](std::size_t job) {
    baked.lightmaps[order[job]] = draftOf(SurfaceId(order[job]), visibilities);
  });
  lightSprites(unbounced(), visibilities, threads_, baked);
  draftMeshes(visibilities, points, baked);
  baked.stats = statsOf(baked);
  return baked;
}

void Rebake::Baker::draftMeshes(const LightVisibilities& visibilities, const BakeSettings& settings,
                                BakedLight& baked) const {
  baked.meshes = meshes_;
  for (std::uint32_t i = 0; i < meshes_.size(); ++i)
    if (knownMeshes_[i]) lighter_.add(i, knownMeshes_[i]->light, baked);
  const MeshLighter lighter(unbounced(), visibilities, settings, threads_, meshesLeft_, meshes_);
  BakeProgress unwatched;
  auto found = lighter.find(meshesLeft_, unwatched);
  for (std::size_t i = 0; i < found.size(); ++i)
    lighter.add(meshesLeft_[i], *std::move(found[i]), baked);
}

std::optional<Lightmap> Rebake::Baker::draftOf(SurfaceId id,
                                               const LightVisibilities& visibilities) const {
  const Plan& plan = plans_[id.index()];
  if (plan.facing.empty()) return std::nullopt;
  if (plan.same) return plan.same->lightmap;
  TexelSums sums = sumsFor(id);
  for (const auto& contribution : plan.known)
    if (contribution) sums.add(contribution->sums);
  std::vector<std::size_t> left = plan.left;
  std::erase_if(left, [this](std::size_t light) { return scene_.lights()[light].isBounced; });
  if (!left.empty()) {
    SurfaceLight surface(unbounced(), surfaces_, visibilities, settings_.lambert, id);
    addLightsDraft(surface, left, settings_, [&](std::size_t) -> TexelSums& { return sums; });
  }
  return sums.toLightmap(settings_.samples.value_or(1));
}

}  // namespace hearth
