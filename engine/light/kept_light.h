#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "light/baking/mesh_light.h"
#include "light/baking/texel_sums.h"
#include "light/geometry_hash.h"
#include "light/light_cost.h"
#include "light/lightmap.h"
#include "light/lit_surface.h"
#include "light/rebake.h"
#include "math/hash.h"

namespace hearth {

/// What is kept from one bake to the next.
struct LightMemory::Kept {
  /// Stands for the print of a sector or surface.
  using Number = std::uint32_t;

  /// What one light brings to one surface. Bakes share it where it is the same.
  struct Contribution {
    TexelSums sums;
    LightCost cost;
    std::vector<Number> sectors;  ///< from which it was found

    std::size_t bytes() const { return sums.bytes() + sectors.size() * sizeof(Number); }
  };
  /// A surface that was lit.
  struct Surface {
    std::vector<std::uint64_t> lights;  ///< prints of those that face it
    std::vector<std::shared_ptr<const Contribution>> contributions;  ///< of these
    std::vector<Number> samplesOn;                                   ///< surfaces
    std::optional<Lightmap> lightmap;

    std::shared_ptr<const Contribution> contributionOf(std::uint64_t light) const {
      const auto found = std::ranges::find(lights, light);
      return found == lights.end()
                 ? nullptr
                 : contributions[static_cast<std::size_t>(found - lights.begin())];
    }
    std::size_t ownBytes() const { return lightmap ? lightmap->bytes() : 0; }
  };
  /// A mesh that was lit. Its light is kept as a whole: much of it lies in small faces, for which
  /// sums of each light would take far more room.
  struct Mesh {
    std::vector<std::uint64_t> lights;  ///< prints of those that may shine on it
    std::vector<Number> sectors;        ///< from which its light was found
    MeshLight light;

    std::size_t bytes() const {
      return (light.lightmap ? light.lightmap->bytes() : 0) +
             light.costs.size() * sizeof(LightCost) + sectors.size() * sizeof(Number);
    }
  };

  template <typename Lit>
  using ByPrint = std::unordered_map<std::uint64_t, std::shared_ptr<const Lit>>;
  /// What a bake found. One that was stopped adds to that of the bake before.
  struct OneBake {
    ByPrint<Surface> surfaces;
    ByPrint<Mesh> meshes;
  };

  std::size_t maxBytes;
  std::size_t maxBakes = 1;
  std::size_t bytes = 0;
  std::optional<BakeSettings> settings;
  std::uint64_t geometry = 0;                         ///< hashOf() the last scene, ...
  std::shared_ptr<const LitSurfaces> made;            ///< ... whose surfaces these are
  std::unordered_map<std::uint64_t, Number> numbers;  ///< of prints
  std::deque<OneBake> bakes;                          ///< the last one first

  void clear() {
    bakes.clear();
    uses.clear();
    bytes = 0;
  }

  /// Of the map in which a bake has a surface or a mesh, about.
  static constexpr std::size_t kEntryBytes = 64;

  void dropOldest() {
    bytes -= kEntryBytes * (bakes.back().surfaces.size() + bakes.back().meshes.size());
    for (const auto& [print, surface] : bakes.back().surfaces) release(*surface);
    for (const auto& [print, mesh] : bakes.back().meshes) release(*mesh);
    bakes.pop_back();
  }

  /// Begins a bake, of which `keep` adds what was found.
  void begin() {
    bakes.emplace_front();
    while (bakes.size() > maxBakes) dropOldest();
  }

  /// In the last bake, if there is room without those before it.
  template <typename Lit>
  void keep(ByPrint<Lit>& all, std::uint64_t print, std::shared_ptr<const Lit> lit) {
    retain(*lit);
    auto& kept = all[print];
    if (kept)
      release(*kept);
    else
      bytes += kEntryBytes;
    kept = std::move(lit);
    while (bytes > maxBytes && bakes.size() > 1) dropOldest();
    if (bytes <= maxBytes) return;
    release(*kept);
    bytes -= kEntryBytes;
    all.erase(print);
  }

  /// Of the geometry, and of which ids show: a texture that shows nowhere changes ids alone.
  static std::uint64_t hashOf(const Scene& scene, double texel) {
    Hash hash;
    hash.addWhole(geometryHash(scene, texel));
    for (const SurfaceGeometry& surface : scene.geometry().surfaces)
      hash.addWhole(surface.shows ? 1 : 0);
    return hash.value();
  }

  /// Those of the last scene where that is the same.
  std::shared_ptr<const LitSurfaces> surfacesOf(const Scene& scene, double texel) {
    const std::uint64_t hash = hashOf(scene, texel);
    if (!made || geometry != hash)
      made = std::make_shared<const LitSurfaces>(makeLitSurfaces(scene, texel));
    geometry = hash;
    return made;
  }

  Number numberOf(std::uint64_t print) {
    return numbers.try_emplace(print, static_cast<Number>(numbers.size())).first->second;
  }

 private:
  /// How often what bakes share is used.
  std::unordered_map<const void*, std::size_t> uses;

  void use(const void* what, std::size_t size) {
    if (uses[what]++ == 0) bytes += size;
  }
  void letGo(const void* what, std::size_t size) {
    const auto found = uses.find(what);
    if (--found->second > 0) return;
    uses.erase(found);
    bytes -= size;
  }
  void retain(const Surface& surface) {
    use(&surface, surface.ownBytes());
    for (const auto& of : surface.contributions) use(of.get(), of->bytes());
  }
  void release(const Surface& surface) {
    letGo(&surface, surface.ownBytes());
    for (const auto& of : surface.contributions) letGo(of.get(), of->bytes());
  }
  void retain(const Mesh& mesh) { use(&mesh, mesh.bytes()); }
  void release(const Mesh& mesh) { letGo(&mesh, mesh.bytes()); }
};

}  // namespace hearth
