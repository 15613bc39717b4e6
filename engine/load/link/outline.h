#pragma once

#include <cstdint>
#include <vector>

#include "load/json/report.h"
#include "load/read/description.h"
#include "math/box_tree.h"
#include "math/vec.h"

namespace hearth {

/// An authored wall, turned so that its sector lies in front. Ends are indices into
/// `Outlines::points`.
struct Edge {
  std::uint32_t sector;
  std::uint32_t loop;       ///< index into OutlineSector::loops
  std::uint32_t wallIndex;  ///< in the file
  std::uint32_t from;
  std::uint32_t to;
};

struct OutlineLoop {
  std::uint32_t described;  ///< index into SectorDescription::loops
  std::uint32_t firstEdge;  ///< its edges are contiguous and in order
  std::uint32_t edgeCount;
  std::uint32_t firstVertex;  ///< its vertices are contiguous and in file order
  double twiceArea;           ///< of the loop as authored; positive for one wound like a border
  bool isTurned;              ///< its edges run against the file
};

struct OutlineSector {
  std::vector<OutlineLoop> loops;  ///< the border first; empty when the file's were unreadable
  std::uint32_t firstEdge = 0;
  std::uint32_t edgeCount = 0;
  bool isSound = false;  ///< else something about its loops has been reported
};

/// A vertex of one loop that lies on a wall of another loop of its sector.
struct Touch {
  std::uint32_t edge;
  std::uint32_t vertex;
  double noise;  ///< metres, of the walls concerned
};

/// The walls of all sectors as a graph: what welding works on.
struct Outlines {
  std::vector<Vec2> points;  ///< all vertices, by sector and loop
  std::vector<Edge> edges;   ///< by sector and loop
  std::vector<OutlineSector> sectors;
  std::vector<Touch> touches;

  Vec2 from(const Edge& edge) const { return points[edge.from]; }
  Vec2 to(const Edge& edge) const { return points[edge.to]; }
  double length(const Edge& edge) const { return hearth::length(to(edge) - from(edge)); }
  Box box(const Edge& edge) const { return boxOf(from(edge), to(edge)); }
  /// The tree's indices count from the sector's first edge.
  BoxTree treeOf(const OutlineSector& sector) const;
};

/// Turns loops round where that is needed. Sectors come out sound unless unreadable.
Outlines makeOutlines(const LevelDescription& description);

/// What the file says of an edge's loop.
inline const LoopDescription& describedLoop(const LevelDescription& description,
                                            const Outlines& outlines, const Edge& edge) {
  const OutlineLoop& loop = outlines.sectors[edge.sector].loops[edge.loop];
  return description.sectors[edge.sector].loops[loop.described];
}

/// Reports loops that repeat a vertex, touch or cross themselves, cross each other, leave the
/// border, nest or enclose no area, and marks their sectors as not sound. Warns of loops in sound
/// sectors that were turned round. Finds the touches.
void validateOutlines(Report& report, const LevelDescription& description, Outlines& outlines);

}  // namespace hearth
