#include "load/link/outline.h"

#include <algorithm>

namespace hearth {

namespace {

double twiceArea(const std::vector<Vec2>& loop) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
    sum += cross(loop[i] - loop[0], loop[i + 1] - loop[0]);
  return sum;
}

/// Indices of the loops, the border first, else as in the file.
std::vector<std::uint32_t> borderFirst(const SectorDescription& sector) {
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < sector.loops.size(); ++i) order.push_back(i);
  std::stable_partition(order.begin(), order.end(),
                        [&](std::uint32_t i) { return sector.loops[i].name == "border"; });
  return order;
}

class OutlineBuilder {
 public:
  explicit OutlineBuilder(Outlines& outlines) : outlines_(outlines) {}

  void addSector(const SectorDescription& sector) {
    OutlineSector outline;
    outline.firstEdge = static_cast<std::uint32_t>(outlines_.edges.size());
    outline.isSound = sector.hasReadableLoops;
    if (outline.isSound)
      for (const std::uint32_t described : borderFirst(sector))
        addLoop(outline, sector.loops[described], described);
    outline.edgeCount = static_cast<std::uint32_t>(outlines_.edges.size()) - outline.firstEdge;
    outlines_.sectors.push_back(std::move(outline));
  }

 private:
  void addLoop(OutlineSector& sector, const LoopDescription& loop, std::uint32_t described) {
    const auto count = static_cast<std::uint32_t>(loop.vertices.size());
    const auto first = static_cast<std::uint32_t>(outlines_.points.size());
    outlines_.points.insert(outlines_.points.end(), loop.vertices.begin(), loop.vertices.end());
    const bool isBorder = sector.loops.empty();
    const double area = twiceArea(loop.vertices);
    const bool isTurned = isBorder ? area < 0 : area > 0;
    const auto loopIndex = static_cast<std::uint32_t>(sector.loops.size());
    const auto sectorIndex = static_cast<std::uint32_t>(outlines_.sectors.size());
    sector.loops.push_back({described, static_cast<std::uint32_t>(outlines_.edges.size()), count,
                            first, area, isTurned});
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t wall = isTurned ? count - 1 - i : i;
      std::uint32_t from = first + wall;
      std::uint32_t to = first + (wall + 1) % count;
      if (isTurned) std::swap(from, to);
      outlines_.edges.push_back({sectorIndex, loopIndex, wall, from, to});
    }
  }

  Outlines& outlines_;
};

}  // namespace

BoxTree Outlines::treeOf(const OutlineSector& sector) const {
  std::vector<Box> boxes;
  for (std::uint32_t i = 0; i < sector.edgeCount; ++i)
    boxes.push_back(box(edges[sector.firstEdge + i]));
  return BoxTree(boxes);
}

Outlines makeOutlines(const LevelDescription& description) {
  Outlines outlines;
  OutlineBuilder builder(outlines);
  for (const SectorDescription& sector : description.sectors) builder.addSector(sector);
  return outlines;
}

}  // namespace hearth
