#pragma once

#include <optional>
#include <vector>

#include "agreement/panel.h"

namespace hearth::agreement {

/// A stretch at which one panel goes on in another. Ends in the axes of the first.
struct CommonEdge {
  std::size_t to;  ///< index of the other panel
  Edge edge;
};

/// Those of the panels, and of what walls hold: there, what opens at an edge changes.
std::vector<Vec3> cornersOf(const Scene& scene, const std::vector<std::optional<Panel>>& panels);

/// Whether the two lie in one plane and face the same way.
bool areInOnePlane(const Panel& a, const Panel& b);

/// Where `from` goes on in `to`, which lies in its plane: they have an edge in common, round which
/// openings lead from the air before the one to the air before the other. `corners` are those of
/// the scene.
std::vector<Edge> commonEdges(const Scene& scene, const std::vector<Vec3>& corners,
                              const Panel& from, const Panel& to);

}  // namespace hearth::agreement
