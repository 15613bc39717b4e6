#pragma once

#include <optional>
#include <span>
#include <vector>

#include "level/scene.h"
#include "light/bakery.h"
#include "light/blended_texels.h"
#include "math/parallel.h"

namespace hearth {

/// The light of a level with all its movers at rest. Level, geometry and light must outlive its
/// use.
struct LightAtRest {
  Scene scene;
  const BakedLight* light;
};

/// The light of a level while some movers are between their ends: of each texel the weighted sum of
/// its light in some states at rest, rounded half up. The scenes of the states differ only in the
/// heights of flats, and in what stands on these. A texel of a step moves with the flat whose edge
/// the step is: the next sector's floor below an opening, its ceiling above one. All other texels
/// of walls stay in place. Where a texel lies beyond the surface in a state, it takes the nearest
/// light of the surface there. A surface that does not show in a state takes its light from the
/// others.
class BlendedLight {
 public:
  /// From now on the light of these, baked with texels of one size. At least one.
  void setStates(std::span<const LightAtRest> states);
  /// The same on the texels of some surfaces, as they are while the flats stand as in the scene
  /// that is blended for.
  void setStates(std::span<const LightAtRest> states, LitSurfaces surfaces);

  /// Sets the weights of the states, >= 0 with a sum of 1, while the flats stand as in `shown`.
  /// Takes no memory, and a time that depends on the surfaces whose light differs between states.
  void blend(const Scene& shown, std::span<const double> weights, Workers* workers = nullptr);

  /// Always at the same place. Surfaces that were not given, and meshes, lie as in one of the
  /// states; their lightmaps have the texels of all.
  const BakedLight& light() const { return light_; }

 private:
  /// A lightmap, and the states in which a surface has it.
  struct Source {
    const Lightmap* map;
    const LitSurface* lit;       ///< null for a thing
    std::optional<double> edge;  ///< of a step: its height in these states
    std::vector<std::size_t> states;
  };
  /// A surface whose light differs between states.
  struct Blend {
    SurfaceId surface;
    std::vector<std::size_t> shownIn;  ///< states; all of a thing
    std::vector<Source> sources;
    std::vector<StateTexels> texels = {};  ///< room for those of `sources`
  };
  /// A mesh whose faces lie elsewhere on the lightmap in some states: where it moves with the floor
  /// that it stands on.
  struct MeshBlend {
    struct Source {
      std::size_t state;              ///< in which it has light, and the same faces
      std::vector<TexelRect> rectOf;  ///< by face
    };
    std::size_t mesh;
    std::vector<Source> sources;
    std::vector<StateTexels> texels = {};  ///< room for those of `sources`
  };

  void setAllLight();
  void setSurface(SurfaceId id);
  void setLight(SurfaceId id);
  void setMesh(std::size_t mesh);
  Blend blendOf(SurfaceId id) const;
  TexelRect texelsOf(const Blend& blend) const;
  void blendSurface(const Scene& shown, std::span<const double> weights, Blend& blend);
  void blendMesh(std::span<const double> weights, MeshBlend& blend);

  std::vector<LightAtRest> states_;
  bool hasOwnSurfaces_ = false;  ///< that were given
  std::vector<Blend> blends_;
  std::vector<MeshBlend> meshes_;
  std::vector<SurfaceId> moving_;  ///< level flats whose height differs
  BakedLight light_;
};

/// The same, for a single picture: with the surfaces of `shown`, on texels as those of the states.
BakedLight blendedLight(const Scene& shown, std::span<const LightAtRest> states,
                        std::span<const double> weights, int threads);

}  // namespace hearth
