#include "random_levels/obj_models.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string_view>

namespace hearth::random_levels {
namespace {

using Triangle = std::array<Vec3, 3>;

/// As fans from the first corner of each polygon.
std::vector<Triangle> trianglesOf(const ObjModel& model) {
  std::vector<Triangle> triangles;
  for (const auto& polygon : model.polygons)
    for (std::size_t k = 2; k < polygon.size(); ++k)
      triangles.push_back(
          {model.vertices[polygon[0]], model.vertices[polygon[k - 1]], model.vertices[polygon[k]]});
  return triangles;
}

Vec3 normalOf(const Triangle& t) { return cross(t[1] - t[0], t[2] - t[0]); }

std::ptrdiff_t linesThatStart(const std::string& text, std::string_view with) {
  std::ptrdiff_t count = 0;
  for (std::size_t at = 0; at < text.size(); at = text.find('\n', at) + 1)
    count += std::string_view(text).substr(at).starts_with(with) ? 1 : 0;
  return count;
}

TEST(ObjModels, haveDifferentNames) {
  std::set<std::string> names;
  for (const ObjModel& model : objModels()) EXPECT_TRUE(names.insert(model.name).second);
}

TEST(ObjModels, haveNoFaceWithoutArea) {
  for (const ObjModel& model : objModels())
    for (const Triangle& triangle : trianglesOf(model))
      EXPECT_GT(length(normalOf(triangle)), 1e-3) << model.name;
}

TEST(ObjModels, thatAreClosedHaveTwoFacesAtEachEdgeThatFaceOut) {
  for (const ObjModel& model : objModels()) {
    std::map<std::pair<std::size_t, std::size_t>, int> edges;
    for (const auto& polygon : model.polygons)
      for (std::size_t k = 0; k < polygon.size(); ++k)
        ++edges[{polygon[k], polygon[(k + 1) % polygon.size()]}];
    const bool isClosed = std::ranges::all_of(edges, [&](const auto& entry) {
      const auto& [from, to] = entry.first;
      const auto back = edges.find({to, from});
      return entry.second == 1 && back != edges.end() && back->second == 1;
    });
    EXPECT_EQ(isClosed, model.isClosed) << model.name;
    double volume = 0;
    for (const Triangle& t : trianglesOf(model)) volume += dot(t[0], cross(t[1], t[2])) / 6;
    if (model.isClosed) {
      EXPECT_GT(volume, 0.05) << model.name;
    }
  }
}

TEST(ObjModels, areFansWhoseTrianglesFaceAsTheirPolygon) {
  for (const ObjModel& model : objModels()) {
    if (!model.isClosed) continue;  // the polygons of open ones need not be flat
    for (const auto& polygon : model.polygons) {
      ObjModel one = model;
      one.polygons = {polygon};
      const std::vector<Triangle> triangles = trianglesOf(one);
      for (const Triangle& triangle : triangles)
        EXPECT_GT(dot(normalOf(triangle), normalOf(triangles[0])), 0) << model.name;
    }
  }
}

TEST(ObjModels, holdATileThatFacesUpAndAPanelThatFacesAlongX) {
  const std::vector<ObjModel> models = objModels();
  for (const Triangle& triangle : trianglesOf(models[kObjTile]))
    EXPECT_EQ(normalOf(triangle), (Vec3{0, 1, 0}));
  for (const Triangle& triangle : trianglesOf(models[kObjPanel]))
    EXPECT_EQ(normalOf(triangle), (Vec3{1, 0, 0}));
}

TEST(ObjModels, areWrittenWithEveryVertexAndPolygon) {
  for (const ObjModel& model : objModels()) {
    SCOPED_TRACE(model.name);
    const std::string text = objText(model);
    std::size_t corners = 0;
    for (const auto& polygon : model.polygons) corners += polygon.size();
    EXPECT_EQ(linesThatStart(text, "v "), std::ssize(model.vertices));
    EXPECT_EQ(linesThatStart(text, "f "), std::ssize(model.polygons));
    const bool hasImage = model.skin != ObjSkin::Colors;
    EXPECT_EQ(linesThatStart(text, "vt "), hasImage ? static_cast<std::ptrdiff_t>(corners) : 0);
    EXPECT_EQ(linesThatStart(text, "mtllib "), model.skin == ObjSkin::OfThing ? 0 : 1);
  }
}

TEST(ObjModels, haveMaterialsOfTheirSkin) {
  for (const ObjModel& model : objModels()) {
    SCOPED_TRACE(model.name);
    const std::string text = mtlText(model);
    EXPECT_EQ(linesThatStart(text, "newmtl "), model.skin == ObjSkin::OfThing ? 0 : 3);
    EXPECT_EQ(linesThatStart(text, "map_Kd "), model.skin == ObjSkin::Images ? 2 : 0);
  }
}

}  // namespace
}  // namespace hearth::random_levels
