#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "load/json/fields.h"
#include "load/read/read.h"

namespace hearth {

namespace {

constexpr std::array<std::string_view, 6> kSectorKeys{"light",      "floor",     "ceiling",
                                                      "slopeFloor", "slopeCeil", "loops"};
constexpr std::array<std::string_view, 2> kLoopKeys{"v", "walls"};
constexpr std::array<std::string_view, 5> kFlatKeys{"z", "texture", "isRelative", "parallax",
                                                    "next"};
constexpr std::array<std::string_view, 3> kSlopeKeys{"z", "sidewall", "isRelative"};

/// Found in a sector, and of its loops.
constexpr MisplacedKeys kOfLoops{
    kLoopKeys, "give it to a loop: \"loops\": {{ \"border\": {{ .., \"{}\": .. }} }}"};
/// Found in a loop, and of its sector.
constexpr MisplacedKeys kOfSectors{kSectorKeys, "give it to the sector, beside \"loops\""};

/// `keys` and "name", which array elements have and object members do not.
template <std::size_t count>
std::vector<std::string_view> knownKeys(const std::array<std::string_view, count>& keys,
                                        bool isNamedByKey) {
  std::vector<std::string_view> known(keys.begin(), keys.end());
  if (!isNamedByKey) known.push_back("name");
  return known;
}

std::optional<FlatPortalDescription> readFlatPortalPair(Report& report, JsonValue next) {
  constexpr std::array<std::string_view, 2> kKeys{"up", "down"};
  const Fields fields(report, next, kKeys);
  const auto up = fields.require("up", "name the sector above");
  const auto down = fields.require("down", "name the sector below");
  const auto upName = up ? readReference(report, *up) : std::nullopt;
  const auto downName = down ? readReference(report, *down) : std::nullopt;
  if (!upName || !downName) return std::nullopt;
  return FlatPortalDescription{*upName, *downName, next.place()};
}

/// `"up-down"` or `{"up": .., "down": ..}`.
std::optional<FlatPortalDescription> readFlatPortal(Report& report, JsonValue next) {
  if (next.isObject()) return readFlatPortalPair(report, next);
  const std::string_view text = next.isString() ? next.text() : std::string_view();
  const std::size_t dash = text.find('-');
  if (dash == 0 || dash == std::string_view::npos || dash + 1 == text.size() ||
      text.find('-', dash + 1) != std::string_view::npos) {
    report.error(next.place(), "not the names of two sectors",
                 "write \"up-down\", or {\"up\": .., \"down\": ..} when a name holds a \"-\"");
    return std::nullopt;
  }
  return FlatPortalDescription{{std::string(text.substr(0, dash)), next.place()},
                               {std::string(text.substr(dash + 1)), next.place()},
                               next.place()};
}

void refuseBesideNext(Report& report, const FlatDescription& flat, const Fields& fields) {
  if (flat.texture)
    report.error(fields.find("texture")->place(), "a texture on a flat portal",
                 "remove it or \"next\"");
  if (flat.isSky)
    report.error(fields.find("parallax")->place(), "a flat portal that is sky",
                 "remove \"parallax\" or \"next\"");
}

void readHeights(Report& report, JsonValue value, SlopeDescription& slope) {
  if (!value.isArray()) {
    reportWrongType(report, value, "an array of heights");
    return;
  }
  for (const JsonValue element : value.elements()) {
    slope.heightPlaces.push_back(element.place());
    slope.heights.push_back(element.isNull() ? std::nullopt : readNumber(report, element, kLength));
    if (!element.isNull() && !slope.heights.back()) {
      slope.heights.clear();
      return;
    }
  }
}

std::optional<SlopeDescription> readSlope(Report& report, const Fields& sector,
                                          std::string_view key) {
  const std::optional<JsonValue> value = sector.find(key);
  if (!value) return std::nullopt;
  const Fields fields(report, *value, kSlopeKeys);
  SlopeDescription slope;
  slope.place = value->place();
  fields.read("isRelative", slope.isRelative);
  if (const auto sidewall = fields.find("sidewall"))
    slope.sidewall = readTexture(report, *sidewall, TextureUse::OnWall);
  const auto heights = fields.require("z", "give one height for each vertex of the border");
  if (heights) {
    slope.place = heights->place();
    readHeights(report, *heights, slope);
  }
  if (slope.heights.empty()) return std::nullopt;
  return slope;
}

bool take(Report& report, JsonValue value, std::size_t vertices, VertexBudget& budget) {
  if (budget.isExceeded) return false;
  budget.isExceeded = vertices > budget.left;
  if (budget.isExceeded)
    reportTooManyVertices(report, value.place(), budget.limit);
  else
    budget.left -= vertices;
  return !budget.isExceeded;
}

void readVertices(Report& report, JsonValue value, LoopDescription& loop, VertexBudget& budget) {
  if (!value.isArray()) return reportWrongType(report, value, "an array x0,y0, x1,y1, ...");
  const std::size_t count = value.size();
  if (count > 0 &&
      (value.front().isArray() || value.front().isObject() || value.front().isString())) {
    const JsonValue first = value.front();
    report.error(
        first.place(),
        fmt::format("{} for each vertex instead of one flat list", first.isArray()    ? "an array"
                                                                   : first.isObject() ? "an object"
                                                                                      : "a text"),
        "write the numbers alone: x0,y0, x1,y1, ...");
    return;
  }
  if (count % 2 != 0) {
    report.error(value.place(),
                 fmt::format("{} coordinates, an odd number: one is missing, or too many", count),
                 "give x and y of each vertex");
    return;
  }
  if (count < 6) {
    report.error(value.place(), fmt::format("{} coordinates are no loop", count),
                 "give x and y of at least three vertices");
    return;
  }
  if (!take(report, value, count / 2, budget)) return;
  std::vector<double> numbers;
  for (const JsonValue element : value.elements()) {
    if (const auto number = readNumber(report, element, kCoordinate)) numbers.push_back(*number);
    loop.vertexPlaces.push_back(element.place());
  }
  if (numbers.size() != count) return;
  for (std::size_t i = 0; i < count; i += 2) {
    loop.vertices.push_back({numbers[i], numbers[i + 1]});
    loop.vertexPlaces[i / 2] = loop.vertexPlaces[i];
  }
  loop.vertexPlaces.resize(count / 2);
}

/// Which walls or vertices are left over, of a loop that has more of the one or the other.
std::string unpaired(const LoopDescription& loop) {
  const std::size_t walls = loop.walls.size();
  if (walls > loop.vertices.size())
    return fmt::format("no vertex is left for wall {}", loop.vertices.size());
  const Vec2 vertex = loop.vertices[walls];
  return fmt::format("none is left for the one that begins at ({}, {})", vertex.x, vertex.y);
}

void readWalls(Report& report, JsonValue value, LoopDescription& loop) {
  if (value.isObject()) {
    loop.walls.push_back(readWall(report, value));
    return;
  }
  if (!value.isArray())
    return reportWrongType(report, value, "an array of walls, or one wall for all");
  for (const JsonValue wall : value.elements()) loop.walls.push_back(readWall(report, wall));
  if (loop.vertices.empty() || loop.walls.size() == loop.vertices.size()) return;
  report.error(value.place(),
               fmt::format("{} walls for {} vertices: {}", loop.walls.size(), loop.vertices.size(),
                           unpaired(loop)),
               "give exactly one wall for each vertex, or a single object for all");
}

LoopDescription readLoop(Report& report, NameReference name, JsonValue value, bool isNamedByKey,
                         VertexBudget& budget) {
  const Fields fields(report, value, knownKeys(kLoopKeys, isNamedByKey), kOfSectors);
  LoopDescription loop{std::move(name.name), name.place, {}, {}, {}};
  if (const auto vertices = fields.require("v", "give the vertices: x0,y0, x1,y1, ..."))
    readVertices(report, *vertices, loop, budget);
  if (const auto walls = fields.require("walls", "give one wall for each vertex"))
    readWalls(report, *walls, loop);
  // Later stages find a wall for each vertex, or one for all.
  if (loop.walls.size() != 1 && loop.walls.size() != loop.vertices.size())
    loop.walls.assign(1, WallDescription{value.place(), Unreadable{}});
  return loop;
}

/// The loop names that are used twice have been reported by the parser when they are keys.
void readLoops(Report& report, JsonValue value, SectorDescription& sector, VertexBudget& budget) {
  for (const JsonValue::Member& member : namedChildren(report, value, "loops"))
    sector.loops.push_back(readLoop(report, {std::string(member.key.text()), member.key.place()},
                                    member.value, value.isObject(), budget));
  for (const LoopDescription& loop : sector.loops)
    sector.hasReadableLoops &= !loop.vertices.empty();
  const bool hasBorder = std::any_of(sector.loops.begin(), sector.loops.end(),
                                     [](const auto& loop) { return loop.name == "border"; });
  if (sector.loops.size() > 1 && !hasBorder) {
    report.error(value.place(), "several loops and none named \"border\"",
                 "name the outline \"border\"");
    sector.hasReadableLoops = false;
  }
  sector.hasReadableLoops &= !sector.loops.empty();
}

}  // namespace

void reportTooManyVertices(Report& report, Place place, std::size_t limit) {
  report.error(place, fmt::format("more than {} vertices", limit),
               "raise the limit with --max-vertices");
}

FlatDescription readFlat(Report& report, const Fields& sector, std::string_view key,
                         double defaultZ) {
  FlatDescription flat;
  flat.z = defaultZ;
  const std::optional<JsonValue> value = sector.find(key);
  flat.place = flat.zPlace = value ? value->place() : sector.value().place();
  flat.isReadable = !sector.isMisspelled(key);
  if (!value) return flat;
  const Fields fields(report, *value, kFlatKeys);
  flat.isReadable =
      fields.isObject() && !fields.isMisspelled("texture") && !fields.isMisspelled("next");
  if (const auto z = fields.find("z")) flat.zPlace = z->place();
  flat.isReadable &= fields.read("z", kCoordinate, flat.z);
  fields.read("isRelative", flat.isRelative);
  flat.isReadable &= fields.read("parallax", flat.isSky);
  if (const auto texture = fields.find("texture")) {
    flat.texture = readTexture(report, *texture, TextureUse::OnFlat);
    flat.isReadable &= flat.texture.has_value();
  }
  if (const auto next = fields.find("next")) {
    flat.next = readFlatPortal(report, *next);
    flat.isReadable &= flat.next.has_value();
    refuseBesideNext(report, flat, fields);
  }
  return flat;
}

SectorDescription readSector(Report& report, NameReference name, JsonValue value,
                             VertexBudget& budget) {
  const bool isNamedByKey = name.place < value.place();
  const Fields fields(report, value, knownKeys(kSectorKeys, isNamedByKey), kOfLoops);
  SectorDescription sector;
  sector.name = std::move(name.name);
  sector.place = name.place;
  fields.read("light", {0, 1}, sector.light);
  sector.floor = readFlat(report, fields, "floor", kFloorZ);
  sector.ceiling = readFlat(report, fields, "ceiling", kCeilingZ);
  sector.slopeFloor = readSlope(report, fields, "slopeFloor");
  sector.slopeCeil = readSlope(report, fields, "slopeCeil");
  sector.hasReadableLoops = fields.isObject();
  if (const auto loops = fields.require("loops", "give at least a border"))
    readLoops(report, *loops, sector, budget);
  else
    sector.hasReadableLoops = false;
  return sector;
}

}  // namespace hearth
