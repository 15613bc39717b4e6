#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "level/ids.h"
#include "render/face_span.h"
#include "render/frame_stats.h"
#include "render/lanes.h"
#include "render/span.h"
#include "render/strip.h"

namespace hearth {

/// Spans of one surface in columns of one strip, at most one in each column. They are painted
/// together: each column is a lane of a register.
struct SpanGroup {
  SurfaceId surface;
  const SpriteView* view;  ///< as in Span
  const MeshFace* face;    ///< as in Span
  int firstColumn;         ///< of the strip
  LaneSet lanes;           ///< the columns that have a span
  int rowBegin;            ///< of all spans: the first row ...
  int rowEnd;              ///< ... and the one behind the last
  double zTop;             ///< as in Span
  LaneRowRanges rows;

  // As in Span. Numbers of lanes without a span have no meaning, but can be computed with.
  LaneDoubles depth;
  LaneDoubles fraction;  ///< only of what is upright

  bool has(std::size_t lane) const { return (lanes >> lane & 1) != 0; }

  /// The span of a lane that has one.
  Span span(std::size_t lane) const {
    return {firstColumn + static_cast<int>(lane),
            rows.begin[lane],
            rows.end[lane],
            surface,
            view,
            face,
            depth[lane],
            fraction[lane],
            zTop};
  }

  /// Calls `use(span)` for all spans.
  template <typename Use>
  void forEachSpan(Use&& use) const {
    for (std::size_t lane = 0; lane < Strip::kColumns; ++lane)
      if (has(lane)) use(span(lane));
  }
};

/// Spans of narrow faces of one mesh in columns of one strip, any number in each column. They are
/// painted column by column.
struct FaceGroup {
  SurfaceId mesh;
  int firstColumn;              ///< of the strip
  int rowBegin;                 ///< of all spans: the first row ...
  int rowEnd;                   ///< ... and the one behind the last
  std::size_t pixels;           ///< of all spans
  std::vector<FaceSpan> spans;  ///< at least one; by lane, then by row

  /// One of them.
  Span span(const FaceSpan& of) const {
    return {firstColumn + static_cast<int>(of.lane),
            of.rowBegin,
            of.rowEnd,
            mesh,
            nullptr,
            of.front->face,
            of.depth};
  }

  /// Calls `use(span)` for all spans.
  template <typename Use>
  void forEachSpan(Use&& use) const {
    for (const FaceSpan& of : spans) use(span(of));
  }
};

/// Both kinds of groups, by the strips that they lie in. Keeps its memory from frame to frame.
class SpanGroups {
 public:
  /// In what order `forEach` visits spans that share a pixel.
  enum class Order {
    Any,         ///< no two do
    LastToFirst  ///< that in which they were added, reversed
  };
  explicit SpanGroups(Order order) : order_(order) {}

  /// Removes all groups, and prepares for these strips.
  void clear(int firstStrip, int strips);

  struct Added {
    SpanGroup* group;  ///< null if all rows were empty
    LaneSet lanes;     ///< whose depth and fraction the caller has to set before the next call
  };
  /// Adds spans of a surface with these rows: to a group of it in this strip, or to a new one. The
  /// group is valid until the next call.
  Added add(SurfaceId surface, int strip, const LaneRowRanges& rows);
  /// The same of a face of a mesh, which has this index among those of the level.
  Added add(SurfaceId mesh, std::uint32_t face, int strip, const LaneRowRanges& rows);
  /// Adds spans of narrow faces of a mesh, by lane, then by row. Their fronts must stay.
  void addFaces(SurfaceId mesh, int strip, std::span<const FaceSpan> faces);

  /// Calls `use(group)` for the groups of a strip, each a SpanGroup or a FaceGroup.
  template <typename Use>
  void forEach(int strip, Use&& use) const {
    for (std::uint32_t i = strips_[indexOf(strip)].last; i != kNone; i = links_[i].before) {
      prefetch(links_[i].before);
      visit(links_[i], use);
    }
  }

  /// Calls `use(span)` for all spans.
  template <typename Use>
  void forEachSpan(Use&& use) const {
    for (const Link& link : links_) visit(link, [&](const auto& group) { group.forEachSpan(use); });
  }

  /// The pixels of all spans of a strip.
  std::size_t pixelsOf(int strip) const { return strips_[indexOf(strip)].pixels; }

  std::size_t spans() const { return spans_; }

 private:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};
  static constexpr std::uint32_t kFace = std::uint32_t{1} << 31;

  struct StripGroups {
    std::uint32_t last = kNone;  ///< index of the group added last
    std::size_t pixels = 0;
  };
  /// What the search for a group looks at first, close together.
  struct Link {
    std::uint32_t before;  ///< index of the group that was added before it in its strip
    std::uint32_t owner;   ///< of its spans: the SurfaceId, or kFace and the index of a face
    std::uint32_t index;   ///< in `groups_` or, if it is one of narrow faces, in `faceGroups_`
    LaneSet lanes;         ///< which no other spans can take
    bool isOfFaces;
  };

  template <typename Use>
  void visit(const Link& link, Use&& use) const {
    if (link.isOfFaces)
      use(faceGroups_[link.index]);
    else
      use(groups_[link.index]);
  }

  /// The groups of a strip lie far apart.
  void prefetch(std::uint32_t index) const {
    if (index == kNone || links_[index].isOfFaces) return;
    const char* const group = reinterpret_cast<const char*>(&groups_[links_[index].index]);
    for (std::size_t i = 0; i < sizeof(SpanGroup); i += 64) __builtin_prefetch(group + i);
  }

  std::size_t indexOf(int strip) const { return static_cast<std::size_t>(strip - firstStrip_); }
  Added add(std::uint32_t owner, SurfaceId surface, int strip, const LaneRowRanges& rows);
  Link& linkFor(std::uint32_t owner, int strip, LaneSet lanes, int rowBegin, int rowEnd);
  Link& begin(std::uint32_t owner, int strip);
  /// Adds one as the last of its strip.
  Link& append(int strip, Link link);

  Order order_;
  int firstStrip_ = 0;
  std::vector<StripGroups> strips_;
  std::vector<Link> links_;  ///< of each group
  // And more of either, of earlier frames, to be written over:
  std::vector<SpanGroup> groups_;
  std::vector<FaceGroup> faceGroups_;
  std::uint32_t groupCount_ = 0;
  std::uint32_t faceGroupCount_ = 0;
  std::size_t spans_ = 0;
};

/// The spans of neighbouring strips of a frame.
struct VisibleSpans {
  /// Of the level's surfaces that have no holes. Every pixel lies in exactly one of them.
  SpanGroups level{SpanGroups::Order::Any};
  /// Of what hangs or stands before these: masked middle textures and things. Added near to far.
  SpanGroups overLevel{SpanGroups::Order::LastToFirst};
  FrameStats stats;

  /// Calls `use(group)` for the groups of a strip, each a SpanGroup or a FaceGroup, in an order in
  /// which they can be painted.
  template <typename Use>
  void forEachGroup(int strip, Use&& use) const {
    level.forEach(strip, use);
    overLevel.forEach(strip, use);
  }

  /// Calls `use(span)` for all spans.
  template <typename Use>
  void forEachSpan(Use&& use) const {
    level.forEachSpan(use);
    overLevel.forEachSpan(use);
  }
};

}  // namespace hearth
