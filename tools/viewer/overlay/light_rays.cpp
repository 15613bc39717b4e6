#include "viewer/overlay/light_rays.h"

#include <imgui/imgui.h>

#include <algorithm>
#include <cmath>

#include "math/tolerance.h"
#include "render/line.h"
#include "render/renderer.h"
#include "viewer/overlay/imgui_values.h"
#include "viewer/overlay/inspector_section.h"
#include "viewer/overlay/overlay.h"

namespace hearth {

namespace {

// In pixels of the smallest letters.
constexpr double kDash = 8;
constexpr float kRayThickness = 2;
constexpr float kMark = 5;

constexpr int kHiddenAlpha = 70;  // of 255
constexpr Rgb kStopped = {255, 64, 48};
constexpr Rgb kPlace = {255, 255, 255};

/// Metres before the eye from which on lines are drawn.
constexpr double kNear = kAuthorNoise;

/// Metres of a ray towards a sun that are drawn: beyond all that is near.
constexpr double kToSun = 1000;

enum class Stroke { Whole, Dashed };

/// Draws lines of the world into the picture of a camera.
class WorldLines {
 public:
  WorldLines(const Scene& scene, const Camera& camera)
      : scene_(scene),
        camera_(camera),
        projection_(projectionFor(scene, camera)),
        list_(*ImGui::GetBackgroundDrawList()),
        scale_(letterScale(camera.height)) {}

  void draw(Vec3 from, Vec3 to, Rgb color, Stroke stroke) {
    const std::optional<LinePart> before =
        keepPositive({}, depthOf(from) - kNear, depthOf(to) - kNear);
    if (!before) return;
    const Vec3 first = between(from, to, before->from);
    const Vec3 last = between(from, to, before->to);
    const Vec2 begin = pixelOf(first);
    const Vec2 end = pixelOf(last);
    const auto inside = insidePicture(begin, end, camera_.width, camera_.height);
    if (!inside) return;
    const double dashes =
        std::ceil((inside->to - inside->from) * length(end - begin) / (kDash * scale_));
    const int step = stroke == Stroke::Dashed ? 2 : 1;
    for (int i = 0; i < dashes; i += step) {
      const auto fractionAt = [&](double dash) {
        return std::lerp(inside->from, inside->to, std::min(1.0, dash / dashes));
      };
      const Vec3 middle = between(first, last, worldFraction(first, last, fractionAt(i + 0.5)));
      list_.AddLine(imVec(lerp(begin, end, fractionAt(i))),
                    imVec(lerp(begin, end, fractionAt(i + 1))), colorAt(middle, color),
                    kRayThickness * scaleOf());
    }
  }

  void drawCross(Vec3 at, Rgb color) {
    if (depthOf(at) <= kNear) return;
    const float arm = kMark * scaleOf();
    const ImVec2 p = imVec(pixelOf(at));
    const ImU32 mixed = colorAt(at, color);
    list_.AddLine({p.x - arm, p.y - arm}, {p.x + arm, p.y + arm}, mixed, kRayThickness * scaleOf());
    list_.AddLine({p.x - arm, p.y + arm}, {p.x + arm, p.y - arm}, mixed, kRayThickness * scaleOf());
  }

  void drawRing(Vec3 at, Rgb color) {
    if (depthOf(at) <= kNear) return;
    list_.AddCircle(imVec(pixelOf(at)), kMark * scaleOf(), colorAt(at, color), 0,
                    kRayThickness * scaleOf());
  }

 private:
  static Vec3 between(Vec3 from, Vec3 to, double fraction) { return from + fraction * (to - from); }
  float scaleOf() const { return static_cast<float>(scale_); }
  double depthOf(Vec3 p) const { return projection_.toCamera(p.xy()).depth; }
  Vec2 pixelOf(Vec3 p) const {
    const CameraPoint seen = projection_.toCamera(p.xy());
    return {projection_.columnOf(seen), projection_.rowOf(p.z, seen.depth)};
  }

  /// A fraction of the line from one point to another, from that of the projected line: along it
  /// 1/depth varies linearly (perspective-correct interpolation).
  double worldFraction(Vec3 from, Vec3 to, double fraction) const {
    const double depth0 = depthOf(from);
    const double depth1 = depthOf(to);
    return fraction * depth0 / std::lerp(depth1, depth0, fraction);
  }

  bool isHidden(Vec3 p) const {
    const Vec3 direction = p - projection_.eye();
    const auto met =
        trace(scene_.level(), camera_.sector, projection_.eye(), direction, RayKind::Look);
    return met && (1 - met->t) * length(direction) > kAuthorNoise;
  }

  ImU32 colorAt(Vec3 p, Rgb color) const {
    return IM_COL32(color.r, color.g, color.b, isHidden(p) ? kHiddenAlpha : 255);
  }

  Scene scene_;
  const Camera& camera_;
  Projection projection_;
  ImDrawList& list_;
  int scale_;  ///< of letters
};

void drawRay(const LightFinding& finding, const LightSource& light, Vec3 place, WorldLines& lines) {
  if (light.isArea()) return;
  const Vec3 from = light.sun ? place + kToSun * light.sun->direction() : light.position;
  if (finding.adds != Vec3{}) return lines.draw(from, place, colorOf(light), Stroke::Whole);
  const Vec3 end = finding.blocker ? finding.blocker->point : from;
  lines.draw(from, end, colorOf(light), Stroke::Whole);
  lines.draw(end, place, kStopped, Stroke::Dashed);
  if (finding.blocker) lines.drawCross(end, kStopped);
}

}  // namespace

Rgb colorOf(const LightSource& light) { return {light.color[0], light.color[1], light.color[2]}; }

void drawLightRays(const Inspection& found, std::optional<std::size_t> pointed, const Scene& scene,
                   const Camera& camera) {
  WorldLines lines(scene, camera);
  const std::size_t listed = listedLights(found);
  for (std::size_t i = 0; i < listed; ++i) {
    const LightFinding& finding = found.lights[i];
    if (!pointed || *pointed == i)
      drawRay(finding, scene.level().lights[finding.light], found.place.point, lines);
  }
  lines.drawRing(found.place.point, kPlace);
}

}  // namespace hearth
