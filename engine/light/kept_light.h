#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
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

  /// What one light brings to one surface.
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
    std::size_t bytes() const {
      std::size_t sum = lightmap ? lightmap->bytes() : 0;
      for (const auto& contribution : contributions) sum += contribution->bytes();
      return sum;
    }
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

  std::size_t maxBytes;
  std::size_t bytes = 0;
  std::optional<BakeSettings> settings;
  std::uint64_t geometry = 0;                         ///< hashOf() the last scene, ...
  std::shared_ptr<const LitSurfaces> made;            ///< ... whose surfaces these are
  std::unordered_map<std::uint64_t, Number> numbers;  ///< of prints
  template <typename Lit>
  using ByPrint = std::unordered_map<std::uint64_t, std::shared_ptr<const Lit>>;
  ByPrint<Surface> surfaces;
  ByPrint<Mesh> meshes;

  void clear() {
    surfaces.clear();
    meshes.clear();
    bytes = 0;
  }

  /// If there is room.
  template <typename Lit>
  void keep(ByPrint<Lit>& all, std::uint64_t print, std::shared_ptr<const Lit> lit) {
    auto& kept = all[print];
    if (kept) bytes -= kept->bytes();
    kept = std::move(lit);
    bytes += kept->bytes();
    if (bytes <= maxBytes) return;
    bytes -= kept->bytes();
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
};

}  // namespace hearth
