#include "random_levels/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>

#include "math/check.h"

namespace hearth::random_levels {
namespace {

constexpr double kClearance = 0.002;  // m, twice the format's tolerance

Point turnedBy(Turn turn, Point p) {
  switch (turn) {
    case Turn::Triangle345:
      return {(4 * p.x - 3 * p.y) / 5, (3 * p.x + 4 * p.y) / 5};
    case Turn::Triangle7And24And25:
      return {(24 * p.x - 7 * p.y) / 25, (7 * p.x + 24 * p.y) / 25};
    case Turn::Quarter:
      return {-p.y, p.x};
    case Turn::None:
      break;
  }
  return p;
}

Um roundedTo(Um unit, double um) {
  return static_cast<Um>(std::floor(um / static_cast<double>(unit) + 0.5)) * unit;
}

/// Positions of the lines of a grid, from a random origin on.
std::vector<Um> gridLines(Random& random, const MeshStyle& style, std::size_t cells) {
  std::vector<Um> lines{random.between(-8, 8) * kMetre};
  for (std::size_t i = 0; i < cells; ++i) {
    const double width = random.real(double(style.cellMin), double(style.cellMax));
    lines.push_back(lines.back() + std::max<Um>(style.unit, roundedTo(style.unit, width)));
  }
  return lines;
}

/// A fifth of the narrower neighbour: quads stay convex up to a quarter.
Um jitterOf(Random& random, const MeshStyle& style, const std::vector<Um>& lines, std::size_t i) {
  Um room = kMetre * 100;
  if (i > 0) room = std::min(room, lines[i] - lines[i - 1]);
  if (i + 1 < lines.size()) room = std::min(room, lines[i + 1] - lines[i]);
  const Um steps = room / 5 / style.unit;
  return random.between(-steps, steps) * style.unit;
}

Mesh makeGrid(Random& random, const MeshStyle& style) {
  Mesh mesh;
  const std::vector<Um> xs = gridLines(random, style, style.columns);
  const std::vector<Um> ys = gridLines(random, style, style.rows);
  for (std::size_t j = 0; j < ys.size(); ++j) {
    for (std::size_t i = 0; i < xs.size(); ++i) {
      Point p{xs[i], ys[j]};
      if (style.isJittered) {
        p.x += jitterOf(random, style, xs, i);
        p.y += jitterOf(random, style, ys, j);
      }
      mesh.vertices.push_back(turnedBy(style.turn, p));
    }
  }
  for (std::size_t j = 0; j < style.rows; ++j) {
    for (std::size_t i = 0; i < style.columns; ++i) {
      const VertexId corner = j * xs.size() + i;
      mesh.faces.push_back({{{corner, corner + 1, corner + 1 + xs.size(), corner + xs.size()}}});
    }
  }
  return mesh;
}

/// Puts `middle` between `a` and `b` wherever the edge occurs.
void splitEdge(Mesh& mesh, VertexId a, VertexId b, VertexId middle) {
  for (Face& face : mesh.faces) {
    for (std::vector<VertexId>& loop : face.loops) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const VertexId p0 = loop[i];
        const VertexId p1 = loop[(i + 1) % loop.size()];
        if ((p0 == a && p1 == b) || (p0 == b && p1 == a)) {
          loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(i) + 1, middle);
          break;
        }
      }
    }
  }
}

/// The point at `quarters` fourths of the way, if whole micrometres can say it.
std::optional<Point> pointAtQuarters(Point a, Point b, Um quarters) {
  const Point d = b - a;
  if (d.x * quarters % 4 != 0 || d.y * quarters % 4 != 0) return std::nullopt;
  return Point{a.x + d.x * quarters / 4, a.y + d.y * quarters / 4};
}

/// Splits the edge exactly on its line.
std::optional<VertexId> splitAtQuarters(Mesh& mesh, VertexId a, VertexId b, Um quarters) {
  const std::optional<Point> p = pointAtQuarters(mesh.vertices[a], mesh.vertices[b], quarters);
  if (!p) return std::nullopt;
  mesh.vertices.push_back(*p);
  splitEdge(mesh, a, b, mesh.vertices.size() - 1);
  return mesh.vertices.size() - 1;
}

// ---- insets

/// Directions of the corners of an inset from its middle, in clockwise order on the map, in the
/// face's own coordinates: even ones point at the middles of its edges, odd ones at its corners.
constexpr std::array<Vec2, 8> kSpokes{
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
/// The corner that an odd spoke points at; the middle that the even spoke before it points at is
/// the one of the edge that ends there.
constexpr std::array<std::size_t, 4> kSpokeTarget{2, 3, 0, 1};

class InsetCutter {
 public:
  InsetCutter(Random& random, Mesh& mesh, FaceId face, Um unit)
      : random_(random), mesh_(mesh), face_(face), unit_(unit) {
    const std::vector<VertexId>& outline = mesh.faces[face].loops[0];
    CHECK(outline.size() == 4, outline.size());
    std::copy_n(outline.begin(), 4, corners_.begin());
  }

  void cutOne() {
    std::vector<VertexId> loop;
    const std::vector<std::size_t> spokes = randomSpokes();
    const std::size_t special = random_.below(spokes.size());
    const int touch = static_cast<int>(random_.below(4));
    for (std::size_t k = 0; k < spokes.size(); ++k) {
      const bool mayTouch = k == special;
      loop.push_back(mayTouch ? touching(spokes[k], touch) : free({0.5, 0.5}, spokes[k], 0.35));
    }
    add(loop);
  }

  /// Two insets side by side: they share either a vertex or a whole edge.
  void cutPair() {
    const bool sharesEdge = random_.chance(0.5);
    const VertexId upper = at({0.5, sharesEdge ? random_.real(0.2, 0.4) : random_.real(0.4, 0.6)});
    const VertexId lower = sharesEdge ? at({0.5, random_.real(0.6, 0.8)}) : upper;
    const VertexId right1 = at({random_.real(0.65, 0.85), 0.3});
    const VertexId right2 = at({random_.real(0.65, 0.85), 0.7});
    const VertexId left1 = at({random_.real(0.15, 0.35), 0.7});
    const VertexId left2 = at({random_.real(0.15, 0.35), 0.3});
    std::vector<VertexId> right{upper, right1, right2};
    std::vector<VertexId> left{lower, left1, left2};
    if (sharesEdge) {
      right.push_back(lower);
      left.push_back(upper);
      cutOut({upper, right1, right2, lower, left1, left2});
    } else {
      cutOut(right);
      cutOut(left);
    }
    mesh_.faces.push_back({{right}, true});
    mesh_.faces.push_back({{left}, true});
  }

 private:
  VertexId add(Point p) {
    mesh_.vertices.push_back(p);
    return mesh_.vertices.size() - 1;
  }
  void add(const std::vector<VertexId>& loop) {
    cutOut(loop);
    mesh_.faces.push_back({{loop}, true});
  }
  void cutOut(std::vector<VertexId> loop) {
    std::reverse(loop.begin(), loop.end());
    mesh_.faces[face_].loops.push_back(loop);
  }

  /// The vertex at (s, t), both 0..1, of the face's bilinear map.
  VertexId at(Vec2 st) {
    const Vec2 top = lerp(metres(corner(0)), metres(corner(1)), st.x);
    const Vec2 bottom = lerp(metres(corner(3)), metres(corner(2)), st.x);
    const Vec2 p = lerp(top, bottom, st.y);
    return add(Point{roundedTo(unit_, p.x * 1e6), roundedTo(unit_, p.y * 1e6)});
  }
  VertexId free(Vec2 middle, std::size_t spoke, double reach) {
    return at(middle + random_.real(0.4, 1) * reach * kSpokes[spoke]);
  }

  /// A corner of the inset that touches the face's outline, nearly does, or stays free.
  VertexId touching(std::size_t spoke, int touch) {
    const bool pointsAtCorner = spoke % 2 == 1;
    if (pointsAtCorner && touch == 0) return corners_[kSpokeTarget[spoke / 2]];
    if (pointsAtCorner && touch == 1) return add(besideCorner(kSpokeTarget[spoke / 2]));
    if (!pointsAtCorner && touch < 2) {
      const std::size_t edge = (kSpokeTarget[spoke / 2] + 3) % 4;
      const Um quarters = random_.between(1, 3);
      const auto split = splitAtQuarters(mesh_, corners_[edge], corners_[(edge + 1) % 4], quarters);
      if (split) return *split;
    }
    return free({0.5, 0.5}, spoke, 0.35);
  }
  /// 4..50 mm from the corner, on the way to the middle.
  Point besideCorner(std::size_t k) {
    const Vec2 middle =
        0.25 * (metres(corner(0)) + metres(corner(1)) + metres(corner(2)) + metres(corner(3)));
    const Vec2 d = middle - metres(corner(k));
    const double reach = random_.real(0.004, 0.05) / length(d);
    const Vec2 p = metres(corner(k)) + reach * d;
    return {roundedTo(1, p.x * 1e6), roundedTo(1, p.y * 1e6)};
  }

  /// Three to eight spokes, no gap between neighbours half a turn or more.
  std::vector<std::size_t> randomSpokes() {
    static const std::vector<std::vector<std::size_t>> kChoices{
        {0, 3, 5},       {0, 3, 6},          {0, 2, 4, 6},
        {0, 2, 3, 5, 6}, {0, 1, 3, 4, 6, 7}, {0, 1, 2, 3, 4, 5, 6, 7}};
    std::vector<std::size_t> spokes = random_.pickFrom(kChoices);
    const std::size_t turn = random_.below(8);
    for (std::size_t& spoke : spokes) spoke = (spoke + turn) % 8;
    return spokes;
  }

  Point corner(std::size_t k) const { return mesh_.vertices[corners_[k]]; }

  Random& random_;
  Mesh& mesh_;
  FaceId face_;
  Um unit_;
  std::array<VertexId, 4> corners_{};
};

void cutInsets(Random& random, Mesh& mesh, const MeshStyle& style) {
  std::vector<FaceId> cells;
  for (FaceId f = style.firstInsetRow * style.columns; f < mesh.faces.size(); ++f) {
    cells.push_back(f);
  }
  random.shuffle(cells);
  cells.resize(std::min(cells.size(), style.insets));
  const Um unit = style.unit >= 62'500 ? 62'500 : 4 * style.unit;
  for (const FaceId face : cells) {
    Mesh changed = mesh;
    if (mesh.faces[face].loops[0].size() != 4) continue;  // a neighbour's inset touches it
    InsetCutter cutter(random, changed, face, unit);
    random.chance(0.35) ? cutter.cutPair() : cutter.cutOne();
    if (isClean(changed)) mesh = std::move(changed);
  }
}

// ---- more vertices

EdgeKey pickEdge(Random& random, const Mesh& mesh) {
  const auto edges = mesh.edges();
  return std::next(edges.begin(), static_cast<std::ptrdiff_t>(random.below(edges.size())))->first;
}

void splitSomeEdges(Random& random, Mesh& mesh, double fraction) {
  const auto count =
      static_cast<std::size_t>(fraction * static_cast<double>(mesh.edges().size()) / 2);
  for (std::size_t n = 0; n < count; ++n) {
    const auto [a, b] = pickEdge(random, mesh);
    Mesh changed = mesh;
    const Um quarters = random.between(1, 3);
    if (splitAtQuarters(changed, a, b, quarters) && isClean(changed)) mesh = std::move(changed);
  }
}

/// A vertex 3..50 mm after the start of an edge and up to half as much beside it.
void addNearVertex(Random& random, Mesh& mesh) {
  const auto [a, b] = pickEdge(random, mesh);
  const Vec2 from = metres(mesh.vertices[a]);
  const Vec2 along = metres(mesh.vertices[b]) - from;
  const double reach = random.real(0.003, 0.05) / length(along);
  const double sign = random.chance(0.5) ? 1 : -1;
  const double aside = sign * random.real(0.2, 0.5);
  const Vec2 p = from + reach * (along + aside * turned90(along));
  Mesh changed = mesh;
  changed.vertices.push_back({roundedTo(1, p.x * 1e6), roundedTo(1, p.y * 1e6)});
  splitEdge(changed, a, b, changed.vertices.size() - 1);
  if (isClean(changed)) mesh = std::move(changed);
}

// ---- checks

bool properlyCross(Point a, Point b, Point c, Point d) {
  const auto side = [](Point p, Point q, Point r) {
    const Um area = cross(q - p, r - p);
    return (area > 0) - (area < 0);
  };
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

bool verticesAreClear(const Mesh& mesh, const std::set<VertexId>& used,
                      const std::vector<EdgeKey>& edges) {
  for (const VertexId v : used) {
    for (const auto& [a, b] : edges) {
      if (v == a || v == b) continue;
      if (distanceToSegment(metres(mesh.vertices[v]), metres(mesh.vertices[a]),
                            metres(mesh.vertices[b])) < kClearance) {
        return false;
      }
    }
  }
  return true;
}

// ---- outlines

/// Whether turning from `from` towards +90 degrees one meets `a` before `b`.
bool comesFirst(Point from, Point a, Point b) {
  const auto half = [&](Point p) {
    const Um side = cross(from, p);
    return side > 0 || (side == 0 && dot(from, p) > 0) ? 0 : 1;
  };
  if (half(a) != half(b)) return half(a) < half(b);
  return cross(a, b) > 0;
}

/// Where several boundary edges leave `at`, the one that closes the outside's wedge: so a hole that
/// touches the border in a vertex becomes a loop of its own.
VertexId nextVertex(const Mesh& mesh, VertexId from, VertexId at, const std::set<VertexId>& ways) {
  const Point origin = mesh.vertices[at];
  const Point back = mesh.vertices[from] - origin;
  return *std::min_element(ways.begin(), ways.end(), [&](VertexId a, VertexId b) {
    return comesFirst(back, mesh.vertices[a] - origin, mesh.vertices[b] - origin);
  });
}

}  // namespace

std::map<EdgeKey, FaceId> Mesh::edges() const {
  std::map<EdgeKey, FaceId> result;
  for (FaceId f = 0; f < faces.size(); ++f) {
    for (const std::vector<VertexId>& loop : faces[f].loops) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const bool isNew = result.insert({{loop[i], loop[(i + 1) % loop.size()]}, f}).second;
        CHECK(isNew, f, i);
      }
    }
  }
  return result;
}

Mesh makeMesh(Random& random, const MeshStyle& style) {
  Mesh mesh = makeGrid(random, style);
  CHECK(isClean(mesh));
  cutInsets(random, mesh, style);
  splitSomeEdges(random, mesh, style.splitFraction);
  for (std::size_t i = 0; i < style.nearVertices; ++i) addNearVertex(random, mesh);
  return mesh;
}

bool isClean(const Mesh& mesh) {
  std::set<VertexId> used;
  std::vector<EdgeKey> edges;
  for (const auto& [edge, face] : mesh.edges()) {
    used.insert(edge.first);
    // Each undirected edge once; those of the outline run in one direction only.
    if (edge.first < edge.second || !mesh.edges().contains({edge.second, edge.first})) {
      edges.push_back(edge);
    }
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      const auto& v = mesh.vertices;
      if (properlyCross(v[edges[i].first], v[edges[i].second], v[edges[j].first],
                        v[edges[j].second])) {
        return false;
      }
    }
  }
  return verticesAreClear(mesh, used, edges);
}

bool contains(const Mesh& mesh, const Face& face, Vec2 point) {
  bool isInside = false;
  for (const std::vector<VertexId>& loop : face.loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2 a = metres(mesh.vertices[loop[i]]);
      const Vec2 b = metres(mesh.vertices[loop[(i + 1) % loop.size()]]);
      if ((a.y > point.y) == (b.y > point.y)) continue;
      if (point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x)) isInside = !isInside;
    }
  }
  return isInside;
}

Um doubleArea(const Mesh& mesh, const std::vector<VertexId>& loop) {
  Um sum = 0;
  const Point origin = mesh.vertices[loop[0]];
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    sum += cross(mesh.vertices[loop[i]] - origin, mesh.vertices[loop[i + 1]] - origin);
  }
  return sum;
}

double areaOf(const Mesh& mesh, const Face& face) {
  double area = 0;
  for (const std::vector<VertexId>& loop : face.loops) {
    area += 0.5e-12 * static_cast<double>(doubleArea(mesh, loop));
  }
  return area;
}

std::vector<std::vector<VertexId>> outlineOf(const Mesh& mesh, const std::vector<FaceId>& faces) {
  std::map<VertexId, std::set<VertexId>> ways;
  const std::set<FaceId> inside(faces.begin(), faces.end());
  const std::map<EdgeKey, FaceId> edges = mesh.edges();
  for (const auto& [edge, face] : edges) {
    const auto reverse = edges.find({edge.second, edge.first});
    const bool isInner = reverse != edges.end() && inside.contains(reverse->second);
    if (inside.contains(face) && !isInner) ways[edge.first].insert(edge.second);
  }
  std::vector<std::vector<VertexId>> loops;
  while (!ways.empty()) {
    std::vector<VertexId> loop{ways.begin()->first};
    VertexId at = *ways.begin()->second.begin();
    VertexId from = loop[0];
    while (true) {
      ways[from].erase(at);
      if (ways[from].empty()) ways.erase(from);
      if (at == loop[0]) break;
      loop.push_back(at);
      CHECK(ways.contains(at), from, at);
      const VertexId next = nextVertex(mesh, from, at, ways[at]);
      from = at;
      at = next;
    }
    loops.push_back(loop);
  }
  std::stable_partition(loops.begin(), loops.end(),
                        [&](const auto& loop) { return doubleArea(mesh, loop) > 0; });
  CHECK(doubleArea(mesh, loops[0]) > 0);
  CHECK(loops.size() == 1 || doubleArea(mesh, loops[1]) < 0, loops.size());
  return loops;
}

}  // namespace hearth::random_levels
