#include "import/doom/map.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace hearth::doom {

namespace {

constexpr std::uint16_t kNone = 0xFFFF;
constexpr std::size_t kMaxLumps = 11;       // that follow the one with the map's name
constexpr std::size_t kMaxRecords = 65536;  // of a lump: as many as 16-bit indices can address
constexpr std::size_t kMaxSides = kNone;    // one index stands for no side

std::uint16_t uint16At(Bytes bytes, std::size_t at) {
  return static_cast<std::uint16_t>(int16At(bytes, at));
}

bool isMarker(const Wad& wad, std::size_t lump) {
  return lump + 1 < wad.lumps().size() && wad.lumps()[lump + 1].name == "THINGS" &&
         !wad.lumps()[lump].name.empty();
}

/// The lumps of one map, up to the name of the next.
class MapReader {
 public:
  MapReader(const Wad& wad, std::size_t marker) : wad_(wad), marker_(marker) {
    map_.name = wad.lumps()[marker].name;
  }

  tl::expected<Map, std::string> read() {
    if (has("BEHAVIOR")) return tl::unexpected(map_.name + " is a map for Hexen, not for Doom");
    readAll(map_.vertices, "VERTEXES", 4, vertexAt);
    readAll(map_.sectors, "SECTORS", 26, sectorAt);
    readAll(map_.sides, "SIDEDEFS", 30, sideAt, kMaxSides);
    readAll(map_.lines, "LINEDEFS", 14, lineAt);
    readAll(map_.things, "THINGS", 10, thingAt);
    checkIndices();
    if (!mistake_.empty()) return tl::unexpected(map_.name + ": " + mistake_);
    return std::move(map_);
  }

 private:
  std::optional<Bytes> lump(std::string_view name) const {
    const auto& lumps = wad_.lumps();
    const std::size_t end = std::min(lumps.size(), marker_ + 1 + kMaxLumps);
    for (std::size_t i = marker_ + 1; i < end && !isMarker(wad_, i); ++i)
      if (lumps[i].name == name) return lumps[i].bytes;
    return std::nullopt;
  }
  bool has(std::string_view name) const { return lump(name).has_value(); }
  void refuse(std::string mistake) {
    if (mistake_.empty()) mistake_ = std::move(mistake);
  }

  template <typename Record>
  void readAll(std::vector<Record>& records, std::string_view name, std::size_t size,
               Record (*recordAt)(Bytes), std::size_t maxRecords = kMaxRecords) {
    const auto bytes = lump(name);
    if (!bytes) return refuse(fmt::format("there is no {}", name));
    if (bytes->size() % size != 0)
      return refuse(
          fmt::format("{} has {} bytes, which is no multiple of {}", name, bytes->size(), size));
    if (bytes->size() / size > maxRecords)
      return refuse(
          fmt::format("{} has {} records, more than {}", name, bytes->size() / size, maxRecords));
    for (std::size_t at = 0; at < bytes->size(); at += size)
      records.push_back(recordAt(bytes->subspan(at, size)));
  }

  static Vertex vertexAt(Bytes b) { return {int16At(b, 0), int16At(b, 2)}; }
  static Sector sectorAt(Bytes b) {
    return {int16At(b, 0),
            int16At(b, 2),
            nameAt(b, 4),
            nameAt(b, 12),
            std::clamp<int>(int16At(b, 20), 0, 255),
            uint16At(b, 22),
            uint16At(b, 24)};
  }
  static Side sideAt(Bytes b) {
    return {int16At(b, 0), int16At(b, 2), nameAt(b, 4),
            nameAt(b, 12), nameAt(b, 20), uint16At(b, 28)};
  }
  static Line lineAt(Bytes b) {
    Line line{uint16At(b, 0), uint16At(b, 2), uint16At(b, 4), uint16At(b, 6), uint16At(b, 8), {}};
    for (const std::size_t i : {0U, 1U})
      if (const std::uint16_t side = uint16At(b, 10 + 2 * i); side != kNone) line.sides[i] = side;
    return line;
  }
  static Thing thingAt(Bytes b) {
    return {int16At(b, 0), int16At(b, 2), int16At(b, 4), uint16At(b, 6), uint16At(b, 8)};
  }

  void checkIndices() {
    const auto check = [this](std::size_t index, std::size_t count, const char* of, std::size_t i,
                              const char* what) {
      if (index >= count) refuse(fmt::format("{} {} names {} {} of {}", of, i, what, index, count));
    };
    for (std::size_t i = 0; i < map_.sides.size(); ++i)
      check(map_.sides[i].sector, map_.sectors.size(), "side", i, "sector");
    for (std::size_t i = 0; i < map_.lines.size(); ++i) {
      const Line& line = map_.lines[i];
      for (const std::uint32_t vertex : {line.from, line.to})
        check(vertex, map_.vertices.size(), "line", i, "vertex");
      for (const auto& side : line.sides)
        if (side) check(*side, map_.sides.size(), "line", i, "side");
    }
  }

  const Wad& wad_;
  std::size_t marker_;
  Map map_;
  std::string mistake_;
};

}  // namespace

std::vector<std::string> mapNames(const Wad& wad) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < wad.lumps().size(); ++i)
    if (isMarker(wad, i)) names.push_back(wad.lumps()[i].name);
  return names;
}

tl::expected<Map, std::string> readMap(const Wad& wad, std::string_view name) {
  for (std::size_t i = wad.lumps().size(); i-- > 0;)
    if (wad.lumps()[i].name == name && isMarker(wad, i)) return MapReader(wad, i).read();
  const std::vector<std::string> names = mapNames(wad);
  if (names.empty()) return tl::unexpected(std::string(kNoMaps));
  return tl::unexpected(
      fmt::format("there is no map {}; those of the WAD: {}", name, fmt::join(names, ", ")));
}

}  // namespace hearth::doom
