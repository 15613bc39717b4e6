#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "level/scene.h"

namespace hearth {

/// Which segments begin or end at a vertex: neighbours across walls and sectors.
class VertexFan {
 public:
  explicit VertexFan(const Scene& scene);

  struct Spoke {
    Vec2 vertex;
    SegmentId segment;
    bool startsHere;  ///< else it ends here
  };

  /// All spokes of the vertex at which a segment begins (ends).
  std::span<const Spoke> atStartOf(SegmentId id) const { return fanOf(2 * id.index()); }
  std::span<const Spoke> atEndOf(SegmentId id) const { return fanOf(2 * id.index() + 1); }

  /// Segments above or below this one, in its plane and with its ends, on the other side of a flat
  /// portal of its sector. Linking splits both sides of flat portals alike.
  std::vector<SegmentId> acrossFlatPortals(SegmentId id) const;

  /// Metres, absolute: a part of the vertical edge above a vertex.
  struct Heights {
    double zBottom;
    double zTop;
  };

  /// The parts of `within` at which a path leads round `vertex`, an end of the wall, from the air
  /// before the wall to the air of sector `to`: through openings before the wall's plane, and never
  /// back. All of `within` if `to` is the wall's own sector. Parts may overlap.
  std::vector<Heights> waysRound(const Segment& wall, Vec2 vertex, SectorId to,
                                 Heights within) const;

 private:
  /// The air of a sector beside a vertex, and the far end of the segment where the path came in.
  struct Air {
    SectorId sector;
    Heights heights;
    Vec2 from;

    bool holds(const Air& other) const {
      return sector == other.sector && from == other.from &&
             heights.zBottom <= other.heights.zBottom && heights.zTop >= other.heights.zTop;
    }
  };

  /// Spokes [begin, end) of one vertex.
  struct Fan {
    std::uint32_t begin;
    std::uint32_t end;
  };

  std::span<const Spoke> fanOf(std::size_t segmentEnd) const {
    const Fan fan = fans_[segmentEnd];
    return std::span(spokes_).first(fan.end).subspan(fan.begin);
  }
  Vec2 farEnd(const Spoke& spoke) const;
  /// The air that a path at those heights enters through the openings of a segment, at its vertex.
  std::vector<Air> beyond(const Spoke& spoke, Heights near) const;

  Scene scene_;
  std::vector<Spoke> spokes_;  ///< sorted by vertex
  std::vector<Fan> fans_;      ///< of each segment's start, then its end
};

}  // namespace hearth
