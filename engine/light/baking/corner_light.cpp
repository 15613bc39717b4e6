#include "light/baking/corner_light.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "light/baking/texel_sums.h"
#include "light/baking/unshadowed_brightness.h"
#include "math/box3.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

constexpr double kUnknown = -1;

/// The fraction of a ball's volume in front of a plane that is so far behind its centre; of a point
/// all or nothing.
double fractionOfBall(double inFront, double radius) {
  if (std::abs(inFront) <= kInPlane) return 0;
  if (radius == 0) return inFront > 0 ? 1 : 0;
  const double height = std::clamp((inFront / radius + 1) / 2, 0.0, 1.0);
  return height * height * (3 - 2 * height);
}

auto coordinates(Vec3 p) { return std::tuple(p.x, p.y, p.z); }

}  // namespace

CornerLight::CornerLight(const Scene& scene, const LightVisibilities& visibilities, bool lambert,
                         const MeshPlace& place)
    : scene_(scene),
      visibilities_(visibilities),
      lambert_(lambert),
      place_(place),
      areas_(visibilities.areas()),
      costs_(scene.lights().size()) {}

void CornerLight::placeCorners(std::span<const LitMesh::SmallFace> faces) {
  corners_.clear();
  ofAreas_.clear();
  ofFaces_.clear();
  std::map<std::tuple<double, double, double>, std::uint32_t> found;
  for (const LitMesh::SmallFace& face : faces) {
    CornersOfFace& ofFace = ofFaces_.emplace_back();
    for (std::size_t k = 0; k < ofFace.size(); ++k) {
      const Vec3 point = faceAt(face).corners[k];
      const auto [entry, isNew] =
          found.try_emplace(coordinates(point), static_cast<std::uint32_t>(corners_.size()));
      if (isNew) corners_.push_back({point, sectorAround(scene_, place_.sectors, point)});
      ofFace[k] = entry->second;
    }
  }
}

TexelSums CornerLight::find(std::span<const LitMesh::SmallFace> faces) {
  placeCorners(faces);
  shafts_.emplace(scene_, visibilities_, boxOfCorners(), place_);
  constexpr int kChannels = 3;
  TexelSums sums({0, 0, 3, static_cast<int>(faces.size())}, kChannels);
  for (const std::size_t light : place_.lights.lights()) add(light, faces, sums);
  return sums;
}

void CornerLight::add(std::size_t index, std::span<const LitMesh::SmallFace> faces,
                      TexelSums& sums) {
  const LightSource& light = scene_.lights()[index];
  if (light.isArea()) return addArea(index, faces, sums);
  seen_.assign(corners_.size(), kUnknown);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const MeshFace& face = faceAt(faces[i]);
    const Vec3 front = frontOf(face);
    const Vec3 normal = (1 / length(front)) * front;
    const double inFront = fractionInFront(index, face, normal);
    if (!(inFront > 0)) continue;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t corner = cornerFor(ofFaces_[i], static_cast<std::size_t>(k));
      const double brightness = unshadowedBrightness(light, visibilities_.reach.metres(index),
                                                     corners_[corner].point, normal, lambert_);
      if (brightness > 0)
        sums.add(k, static_cast<int>(i), light, brightness * inFront * seenFraction(index, corner));
    }
  }
}

void CornerLight::addArea(std::size_t index, std::span<const LitMesh::SmallFace> faces,
                          TexelSums& sums) {
  if (ofAreas_.empty()) findAreas(faces, costs_[index].rays);
  const LightSource& light = scene_.lights()[index];
  const double brightness =
      unshadowedBrightness(light, visibilities_.reach.metres(index), {}, {}, lambert_);
  const std::size_t count = areas_.lights().size();
  const std::size_t area = areas_.placeOf(index);
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const double seen = ofAreas_[(3 * i + k) * count + area];
      ++costs_[index].samples;
      if (seen > 0) ++costs_[index].seenSamples;
      if (brightness * seen > 0)
        sums.add(static_cast<int>(k), static_cast<int>(i), light, brightness * seen);
    }
}

/// At each corner for all faces there at once: their normals differ. As a source of light a face is
/// even: one of its corners tells its light.
void CornerLight::findAreas(std::span<const LitMesh::SmallFace> faces, std::int64_t& slices) {
  const bool isSource = visibilities_.purpose() == LightVisibilities::Purpose::Source;
  const std::size_t count = areas_.lights().size();
  ofAreas_.assign(3 * faces.size() * count, 0);
  std::vector<std::vector<std::size_t>> uses(corners_.size());  // corners of faces
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t corner =
          isSource ? cornerInUse(ofFaces_[i], uses) : cornerFor(ofFaces_[i], k);
      uses[corner].push_back(3 * i + k);
    }
  std::vector<Vec3> normals;
  std::vector<double> fractions;
  for (std::size_t corner = 0; corner < corners_.size(); ++corner) {
    const auto& [point, sector] = corners_[corner];
    if (!sector || uses[corner].empty()) continue;
    normals.clear();
    for (const std::size_t use : uses[corner]) {
      const Vec3 front = frontOf(faceAt(faces[use / 3]));
      normals.push_back((1 / length(front)) * front);
    }
    fractions.assign(normals.size() * count, 0);
    areas_.findOnMesh(point, *sector, normals, fractions, slices, &met_);
    for (std::size_t k = 0; k < normals.size(); ++k)
      std::copy_n(&fractions[k * count], count, &ofAreas_[uses[corner][k] * count]);
  }
}

/// One that is in use, if any is: so few are.
std::uint32_t CornerLight::cornerInUse(const CornersOfFace& ofFace,
                                       const std::vector<std::vector<std::size_t>>& uses) const {
  const auto used = std::ranges::find_if(ofFace, [&](std::uint32_t corner) {
    return corners_[corner].sector && !uses[corner].empty();
  });
  return used != ofFace.end() ? *used : cornerFor(ofFace, 0);
}

/// Of a light: as much of it as is in front of the face, by the face's unit normal.
double CornerLight::fractionInFront(std::size_t index, const MeshFace& face, Vec3 normal) const {
  if (const SunVisibility* sun = visibilities_.sun(index)) return sun->fractionInFront(normal);
  const LightSource& light = scene_.lights()[index];
  return fractionOfBall(dot(normal, light.position - face.corners[0]),
                        visibilities_.reach.radius(index));
}

/// The corner itself or, if it lies in no air, another one of the face.
std::uint32_t CornerLight::cornerFor(const CornersOfFace& ofFace, std::size_t corner) const {
  for (std::size_t k = 0; k < ofFace.size(); ++k) {
    const std::uint32_t other = ofFace[(corner + k) % ofFace.size()];
    if (corners_[other].sector) return other;
  }
  return ofFace[corner];
}

TargetBox CornerLight::boxOfCorners() const {
  Box3 around;
  for (const Corner& corner : corners_) around.add(corner.point);
  return TargetBox::around(around);
}

double CornerLight::seenFraction(std::size_t light, std::uint32_t corner) {
  double& seen = seen_[corner];
  if (seen >= 0) return seen;
  LightCost& cost = costs_[light];
  ++cost.samples;
  seen = seenFractionFrom(corners_[corner], light, cost.rays);
  if (seen > 0) ++cost.seenSamples;
  return seen;
}

double CornerLight::seenFractionFrom(const Corner& corner, std::size_t light, std::int64_t& rays) {
  if (const SunVisibility* sun = visibilities_.sun(light)) {
    if (!corner.sector) return 0;
    return sun->seenFractionFromCorner(corner.point, place_.mesh, *corner.sector,
                                       place_.lights.shaftTowards(light), rays);
  }
  const auto& [shaft, outcome] = shafts_->toPoint(light, corner.point, {0, 0, 1});
  return visibilities_.fine(light).seenFractionFromCorner(corner.point, place_.mesh, shaft, outcome,
                                                          rays);
}

}  // namespace hearth
