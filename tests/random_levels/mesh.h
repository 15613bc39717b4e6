#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "math/vec.h"
#include "random_levels/lattice.h"
#include "random_levels/random.h"

namespace hearth::random_levels {

using VertexId = std::size_t;
using FaceId = std::size_t;
using EdgeKey = std::pair<VertexId, VertexId>;

/// A piece of the map. `loops[0]` is its outline, clockwise on a map with y down; the others are
/// the outlines of the insets that are cut out of it, run the other way.
struct Face {
  std::vector<std::vector<VertexId>> loops;
  bool isInset = false;
};

/// A planar subdivision: every edge that two faces share runs once in each direction. All storeys
/// of a level are unions of its faces, so whatever meets on the map meets exactly.
struct Mesh {
  std::vector<Point> vertices;
  std::vector<Face> faces;

  std::map<EdgeKey, FaceId> edges() const;
};

/// How a mesh is rotated: by the angles of Pythagorean triangles, which keep whole micrometres.
enum class Turn { None, Triangle345, Triangle7And24And25, Quarter };

struct MeshStyle {
  std::size_t columns = 3;
  std::size_t rows = 3;
  Um cellMin = kMetre;      ///< least width of a column or row
  Um cellMax = 2 * kMetre;  ///< largest one
  Um unit = 125'000;        ///< vertices are multiples of it before they are rotated
  bool isJittered = true;   ///< else all lines of the grid stay straight
  Turn turn = Turn::None;
  std::size_t insets = 0;         ///< faces that get one or two insets
  std::size_t firstInsetRow = 0;  ///< rows before it get none
  double splitFraction = 0;       ///< of the edges, that get a vertex at a quarter or a half
  std::size_t nearVertices = 0;   ///< vertices made 2..50 mm beside others
};

/// Faces are row by row; insets follow.
Mesh makeMesh(Random& random, const MeshStyle& style);

/// No edges cross, and no vertex lies within 2 mm of another, or of an edge that is not its own.
bool isClean(const Mesh& mesh);

bool contains(const Mesh& mesh, const Face& face, Vec2 point);
double areaOf(const Mesh& mesh, const Face& face);  ///< m^2

/// The outline of the union of `faces`, which hangs together across edges: the border first, then
/// the holes. Where the union touches itself in a vertex, loops touch there and none repeats it.
std::vector<std::vector<VertexId>> outlineOf(const Mesh& mesh, const std::vector<FaceId>& faces);

/// Twice the signed area, in um^2: positive for a border.
Um doubleArea(const Mesh& mesh, const std::vector<VertexId>& loop);

}  // namespace hearth::random_levels
