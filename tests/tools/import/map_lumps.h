#pragma once

#include "import/doom/map.h"
#include "wad_builder.h"

namespace hearth::doom {

/// Adds the lumps of a map to a WAD, as readMap() reads them.
inline void addMap(WadBuilder& wad, const Map& map) {
  LumpBuilder things;
  for (const Thing& thing : map.things)
    things.int16(thing.x).int16(thing.y).int16(thing.angle).int16(thing.type).int16(thing.flags);
  LumpBuilder lines;
  for (const Line& line : map.lines) {
    lines.int16(static_cast<int>(line.from)).int16(static_cast<int>(line.to));
    lines.int16(line.flags).int16(line.special).int16(line.tag);
    for (const auto& side : line.sides) lines.int16(side ? static_cast<int>(*side) : -1);
  }
  LumpBuilder sides;
  for (const Side& side : map.sides) {
    sides.int16(side.xOffset).int16(side.yOffset);
    sides.name(side.upper).name(side.lower).name(side.middle);
    sides.int16(static_cast<int>(side.sector));
  }
  LumpBuilder vertices;
  for (const Vertex& vertex : map.vertices) vertices.int16(vertex.x).int16(vertex.y);
  LumpBuilder sectors;
  for (const Sector& sector : map.sectors) {
    sectors.int16(sector.floor).int16(sector.ceiling);
    sectors.name(sector.floorFlat).name(sector.ceilingFlat);
    sectors.int16(sector.light).int16(sector.special).int16(sector.tag);
  }
  wad.add(map.name).add("THINGS", things).add("LINEDEFS", lines).add("SIDEDEFS", sides);
  wad.add("VERTEXES", vertices).add("SECTORS", sectors);
}

}  // namespace hearth::doom
