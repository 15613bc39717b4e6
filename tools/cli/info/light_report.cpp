#include "cli/info/light_report.h"

#include <algorithm>
#include <span>

namespace hearth {

namespace {

/// Those of its lightmap, or that it would have; none of what takes no light.
const TexelRect* texelsOf(const BakedLight& light, std::size_t i) {
  if (light.surfaces[i]) return &light.surfaces[i]->texels;
  const auto mesh = std::ranges::find(light.meshes, SurfaceId(i), &LitMesh::surface);
  if (mesh != light.meshes.end()) return &mesh->texels;
  return light.lightmaps[i] ? &light.lightmaps[i]->rect : nullptr;  // of a sprite
}

SurfaceReport reportOf(const BakedLight& light, std::size_t i) {
  SurfaceReport report;
  report.rays = light.surfaceCosts[i].rays;
  const std::optional<Lightmap>& map = light.lightmaps[i];
  const TexelRect* const rect = texelsOf(light, i);
  if (!rect) {
    report.bare = 1;
    return report;
  }
  const std::int64_t texels = rect->count();
  if (map) {
    const bool isWhite = map->channels == 1;
    (isWhite ? report.white : report.colored) = 1;
    (isWhite ? report.whiteTexels : report.coloredTexels) = texels;
    report.even = map->isUniform() ? 1 : 0;
    report.bytes = static_cast<std::int64_t>(map->bytes());
  } else {
    (light.surfaceCosts[i].facingLights == 0 ? report.unfaced : report.unreached) = 1;
    report.skippedTexels = texels;
  }
  return report;
}

/// Of light that bounces, whose channels are found together.
void addBounced(std::span<const LightCost> channels, LightKindReport& bounced) {
  if (channels.empty()) return;
  bounced.lights = 1;
  bounced.samples = channels.front().samples;
  for (const LightCost& channel : channels) bounced.rays += channel.rays;
}

void addLights(const Level& level, const BakedLight& baked, LightReport& report) {
  for (std::size_t i = 0; i < level.lights.size(); ++i) {
    const LightSource& light = level.lights[i];
    const LightCost& cost = baked.lightCosts[i];
    LightKindReport& kind = light.isEmitter()  ? report.emitters
                            : light.isSky      ? report.skies
                            : light.sun        ? report.suns
                            : light.radius > 0 ? report.spheres
                                               : report.points;
    ++kind.lights;
    kind.samples += cost.samples;
    kind.rays += cost.rays;
    report.coloredLights += light.isColored() ? 1 : 0;
    report.uselessLights += light.reach(0) == 0 || cost.seenSamples == 0 ? 1 : 0;
  }
  addBounced(std::span(baked.lightCosts).subspan(level.lights.size()), report.bounced);
}

}  // namespace

SurfaceReport& SurfaceReport::operator+=(const SurfaceReport& other) {
  bare += other.bare;
  unfaced += other.unfaced;
  unreached += other.unreached;
  white += other.white;
  colored += other.colored;
  even += other.even;
  whiteTexels += other.whiteTexels;
  coloredTexels += other.coloredTexels;
  skippedTexels += other.skippedTexels;
  bytes += other.bytes;
  rays += other.rays;
  return *this;
}

double LightKindReport::raysPerSample() const {
  return samples == 0 ? 0 : static_cast<double>(rays) / static_cast<double>(samples);
}

LightReport lightReport(const Scene& scene, const BakedLight& light) {
  LightReport report;
  for (const SurfaceId id : scene.shownSurfaces()) {
    const SurfaceReport surface = reportOf(light, id.index());
    report.kinds[static_cast<std::size_t>(scene[id].kind)] += surface;
    report.all += surface;
  }
  addLights(scene.level(), light, report);
  return report;
}

}  // namespace hearth
