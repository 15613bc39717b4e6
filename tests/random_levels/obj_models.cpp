#include "random_levels/obj_models.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "math/trig.h"
#include "random_levels/random.h"
#include "random_levels/random_level.h"

namespace hearth::random_levels {
namespace {

using Polygon = std::vector<std::size_t>;

struct Shape {
  std::vector<Vec3> vertices;
  std::vector<Polygon> polygons;
  bool isClosed = true;
};

// ---- shapes

Shape tile() {
  return {{{-0.5, 0, -0.5}, {-0.5, 0, 0.5}, {0.5, 0, 0.5}, {0.5, 0, -0.5}}, {{0, 1, 2, 3}}, false};
}

Shape panel() {
  return {{{0, 0, -0.5}, {0, 1, -0.5}, {0, 1, 0.5}, {0, 0, 0.5}}, {{0, 1, 2, 3}}, false};
}

Shape box(Vec3 low, Vec3 high) {
  Shape shape;
  for (unsigned i = 0; i < 8; ++i)
    shape.vertices.push_back(
        {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
  shape.polygons = {{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3},
                    {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}};
  return shape;
}

/// Outlines seen from above: from z to x, that is counter-clockwise, with x as `x` and z as `y`.
using Outline = std::vector<Vec2>;

Outline circle(std::size_t corners, double radius) {
  Outline outline;
  for (std::size_t i = 0; i < corners; ++i) {
    const SinCos at = sinCosDegrees(360.0 * static_cast<double>(i) / static_cast<double>(corners));
    outline.push_back({radius * at.sin, radius * at.cos});
  }
  return outline;
}

/// The outline itself, seen from below; its first corner comes first.
Polygon bottomOf(const Outline& outline) {
  Polygon polygon{0};
  for (std::size_t i = outline.size() - 1; i > 0; --i) polygon.push_back(i);
  return polygon;
}

/// Of 1 m height. From the first corner of its outline all others are seen.
Shape prism(const Outline& outline) {
  const std::size_t n = outline.size();
  Shape shape;
  for (const double y : {0.0, 1.0})
    for (const Vec2 p : outline) shape.vertices.push_back({p.x, y, p.y});
  Polygon top;
  for (std::size_t i = 0; i < n; ++i) top.push_back(n + i);
  shape.polygons = {bottomOf(outline), top};
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    shape.polygons.push_back({i, next, n + next, n + i});
  }
  return shape;
}

Shape cone(const Outline& outline) {
  const std::size_t n = outline.size();
  Shape shape;
  for (const Vec2 p : outline) shape.vertices.push_back({p.x, 0, p.y});
  shape.vertices.push_back({0, 1, 0});
  shape.polygons = {bottomOf(outline)};
  for (std::size_t i = 0; i < n; ++i) shape.polygons.push_back({i, (i + 1) % n, n});
  return shape;
}

/// A cone without its bottom, and with a rim that goes up and down.
Shape umbrella() {
  Shape shape = cone(circle(8, 0.5));
  shape.isClosed = false;
  shape.polygons.erase(shape.polygons.begin());
  for (std::size_t i = 0; i < 8; ++i) shape.vertices[i].y = i % 2 == 0 ? 0.25 : -0.0625;
  shape.vertices.back().y = 0.5;
  return shape;
}

/// Lies, and is bumpy; of quads, which are not flat, or of triangles.
Shape sheet(bool isOfQuads) {
  constexpr std::size_t kCells = 5;
  Random random(isOfQuads ? 1 : 2);
  Shape shape;
  shape.isClosed = false;
  for (std::size_t i = 0; i <= kCells; ++i)
    for (std::size_t j = 0; j <= kCells; ++j)
      shape.vertices.push_back({static_cast<double>(i) / kCells - 0.5,
                                0.01 * static_cast<double>(random.between(-10, 30)),
                                static_cast<double>(j) / kCells - 0.5});
  for (std::size_t i = 0; i < kCells; ++i)
    for (std::size_t j = 0; j < kCells; ++j) {
      const std::size_t a = i * (kCells + 1) + j;
      const std::size_t d = a + kCells + 1;
      if (isOfQuads) {
        shape.polygons.push_back({a, a + 1, d + 1, d});
      } else {
        shape.polygons.push_back({a, a + 1, d + 1});
        shape.polygons.push_back({a, d + 1, d});
      }
    }
  return shape;
}

Shape icosahedron() {
  const double golden = (1 + std::sqrt(5.0)) / 2;
  Shape shape;
  for (const double one : {-1.0, 1.0})
    for (const double other : {-golden, golden})
      for (const Vec3 p : {Vec3{0, one, other}, Vec3{one, other, 0}, Vec3{other, 0, one}})
        shape.vertices.push_back(p);
  const auto areNeighbours = [&](std::size_t a, std::size_t b) {
    return length(shape.vertices[a] - shape.vertices[b]) < 2.1;  // its edges are 2 long
  };
  for (std::size_t a = 0; a < 12; ++a)
    for (std::size_t b = a + 1; b < 12; ++b)
      for (std::size_t c = b + 1; c < 12; ++c) {
        if (!areNeighbours(a, b) || !areNeighbours(b, c) || !areNeighbours(a, c)) continue;
        const Vec3 p = shape.vertices[a];
        const Vec3 normal = cross(shape.vertices[b] - p, shape.vertices[c] - p);
        if (dot(normal, p) > 0)
          shape.polygons.push_back({a, b, c});
        else
          shape.polygons.push_back({a, c, b});
      }
  return shape;
}

/// Of 80 triangles.
Shape ball(double radius, Vec3 center) {
  Shape shape = icosahedron();
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
  const auto middleOf = [&](std::size_t a, std::size_t b) {
    const auto [entry, isNew] = middles.try_emplace(std::minmax(a, b), shape.vertices.size());
    if (isNew) shape.vertices.push_back(shape.vertices[a] + shape.vertices[b]);
    return entry->second;
  };
  for (const Polygon& face : std::exchange(shape.polygons, {})) {
    const std::size_t ab = middleOf(face[0], face[1]);
    const std::size_t bc = middleOf(face[1], face[2]);
    const std::size_t ca = middleOf(face[2], face[0]);
    shape.polygons.insert(shape.polygons.end(),
                          {{face[0], ab, ca}, {face[1], bc, ab}, {face[2], ca, bc}, {ab, bc, ca}});
  }
  for (Vec3& p : shape.vertices) p = center + radius / length(p) * p;
  return shape;
}

ObjModel model(std::string name, ObjSkin skin, Shape shape) {
  return {std::move(name), skin, shape.isClosed, std::move(shape.vertices),
          std::move(shape.polygons)};
}

// ---- materials

/// The images of the materials of models that wear images; the third is a plain colour.
constexpr std::array<std::size_t, 2> kImages{5, 1};
constexpr std::size_t kMaterials = 3;

std::string materialText(const ObjModel& model, std::size_t i) {
  Random random(model.vertices.size() + i);
  std::string text = fmt::format("newmtl m{}\nKd", i);
  for (int channel = 0; channel < 3; ++channel)
    text += fmt::format(" {:.4f}", static_cast<double>(random.below(256)) / 255);
  text += '\n';
  if (model.skin == ObjSkin::Images && i < kImages.size())
    text += fmt::format("map_Kd {}.png\n", kRandomLevelTextures[kImages[i]].name);
  return text;
}

// ---- places on images

Vec3 normalOf(const ObjModel& model, const Polygon& polygon) {
  const Vec3 first = model.vertices[polygon[0]];
  return cross(model.vertices[polygon[1]] - first, model.vertices[polygon[2]] - first);
}

/// On the plane of two axes that the polygon faces most. Beside the image, too, and on its borders.
Vec2 imagePlaceOf(Vec3 p, Vec3 normal) {
  const Vec3 size{std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)};
  const Vec2 place = size.x >= std::max(size.y, size.z) ? Vec2{p.z, p.y}
                     : size.y >= size.z                 ? Vec2{p.x, p.z}
                                                        : Vec2{p.x, p.y};
  return 1.5 * place + Vec2{0.25, -0.5};
}

/// A polygon after its places on an image, if it wears one; `placesBefore` are in the file already.
std::string faceText(const ObjModel& model, const Polygon& polygon, std::size_t placesBefore) {
  std::string places;
  std::string face = "f";
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const std::size_t v = polygon[k];
    if (model.skin == ObjSkin::Colors) {
      face += fmt::format(" {}", v + 1);
      continue;
    }
    const Vec2 place = imagePlaceOf(model.vertices[v], normalOf(model, polygon));
    places += fmt::format("vt {} {}\n", place.x, place.y);
    if (model.skin == ObjSkin::Images)
      face += fmt::format(" {}/{}", v + 1, placesBefore + k + 1);
    else  // counted back from the last
      face += fmt::format(" -{}/-{}", model.vertices.size() - v, polygon.size() - k);
  }
  return places + face + '\n';
}

}  // namespace

std::vector<ObjModel> objModels() {
  // From the corner in the middle all others are seen.
  const Outline corner{{0, 0}, {0.5, 0}, {0.5, -0.5}, {-0.5, -0.5}, {-0.5, 0.5}, {0, 0.5}};
  return {model("tile", ObjSkin::OfThing, tile()),
          model("panel", ObjSkin::Images, panel()),
          model("crate", ObjSkin::Images, box({-0.5, 0, -0.5}, {0.5, 1, 0.5})),
          model("block", ObjSkin::Colors, box({0, -0.5, 0}, {1, 0.5, 1})),
          model("tetrahedron", ObjSkin::Colors, cone(circle(3, 0.5))),
          model("column", ObjSkin::OfThing, prism(circle(6, 0.25))),
          model("corner", ObjSkin::Images, prism(corner)),
          model("ball", ObjSkin::Colors, ball(0.5, {0, 0.5, 0})),
          model("globe", ObjSkin::OfThing, ball(0.5, {0, 0, 0})),
          model("sheet", ObjSkin::Colors, sheet(false)),
          model("cloth", ObjSkin::Images, sheet(true)),
          model("umbrella", ObjSkin::OfThing, umbrella())};
}

std::string objText(const ObjModel& model) {
  std::string text;
  if (model.skin != ObjSkin::OfThing) text += fmt::format("mtllib {}.mtl\n", model.name);
  for (const Vec3 p : model.vertices) text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
  std::size_t places = 0;
  for (std::size_t i = 0; i < model.polygons.size(); ++i) {
    if (model.skin != ObjSkin::OfThing) text += fmt::format("usemtl m{}\n", i % kMaterials);
    text += faceText(model, model.polygons[i], places);
    places += model.polygons[i].size();
  }
  return text;
}

std::string mtlText(const ObjModel& model) {
  std::string text;
  if (model.skin == ObjSkin::OfThing) return text;
  for (std::size_t i = 0; i < kMaterials; ++i) text += materialText(model, i);
  return text;
}

}  // namespace hearth::random_levels
