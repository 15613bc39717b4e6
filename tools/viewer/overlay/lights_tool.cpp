#include "viewer/overlay/lights_tool.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>
#include <utility>

#include "level/locate.h"
#include "light/rays/raytracer.h"
#include "load/positions.h"
#include "math/trig.h"
#include "viewer/overlay/light_rays.h"
#include "viewer/overlay/overlay.h"

namespace hearth {

namespace {

// Of a mark, in pixels of letters: a diamond, and how far from its middle it can be picked.
constexpr int kHalfDiagonal = 5;
constexpr int kReach = 8;

/// Metres before the eye at which a light is put, the first that nothing hides.
constexpr std::array kAhead = {1.5, 1.0, 0.5, 0.25};

/// Enough to see what is near, and not all that is far.
constexpr double kFirstFalloff = 0.5;

/// And before a surface.
constexpr double kMaxBefore = 1;

/// Degrees.
constexpr double kLowestNewSun = 30;

/// Levels. Shadows show beside what a sun adds.
constexpr double kNewSky = 100;

/// Levels. Its image still shows in what shines.
constexpr double kNewEmitter = 150;

/// The sector of a point that the eye sees.
std::optional<SectorId> seenAt(const Scene& scene, const Camera& camera, Vec3 point) {
  const Vec3 eye = nudgedInside(scene, scene[camera.sector], camera.eye);
  return Raytracer(scene).sectorAt({eye, camera.sector}, point);
}

/// Where a light has its mark; areas have none.
std::optional<Vec2> markOf(const LightSource& light, const MarkerSpace& space) {
  if (light.isArea()) return std::nullopt;
  return light.sun ? space.pixelTowards(light.sun->direction()) : space.pixelOf(light.position);
}

/// Whether something hides a light from the eye.
bool isHidden(const Scene& scene, const Camera& camera, const LightSource& light) {
  if (!light.sun) return !seenAt(scene, camera, light.position);
  const Vec3 eye = nudgedInside(scene, scene[camera.sector], camera.eye);
  return !Raytracer(scene).seesSky({eye, camera.sector}, light.sun->direction());
}

/// A sun in a direction, to hundredths of a degree; above the horizon.
Sun sunTowards(Vec3 direction, double size) {
  constexpr double kPerRadian = 180 / std::numbers::pi;
  const auto rounded = [](double degrees) { return std::round(100 * degrees) / 100; };
  const double pitch = kPerRadian * std::atan2(direction.z, length(direction.xy()));
  return {rounded(compassDegrees(direction.xy())), std::clamp(rounded(pitch), 1.0, 90.0), size};
}

/// A drag along both sides of a map goes where the mouse has gone farther.
Axis fartherAxis(Vec2 direction) {
  return std::abs(direction.x) >= std::abs(direction.y) ? Axis::X : Axis::Y;
}

Rgb mixed(Rgb a, Rgb b) {
  const auto mean = [](std::uint8_t x, std::uint8_t y) {
    return static_cast<std::uint8_t>((x + y) / 2);
  };
  return {mean(a.r, b.r), mean(a.g, b.g), mean(a.b, b.b)};
}

struct Mark {
  Rgb color;
  Rgb rim;
  bool isHidden;  ///< then it is hollow
};

void drawMark(const PixelRows& picture, Vec2 pixel, const Mark& mark) {
  const int scale = letterScale(picture.height);
  const int half = scale * kHalfDiagonal;
  const int left = static_cast<int>(std::lround(pixel.x));
  const int top = static_cast<int>(std::lround(pixel.y));
  for (int y = std::max(0, top - half); y <= std::min(picture.height - 1, top + half); ++y)
    for (int x = std::max(0, left - half); x <= std::min(picture.width - 1, left + half); ++x) {
      const int fromMiddle = std::abs(x - left) + std::abs(y - top);
      if (fromMiddle > half) continue;
      const bool isRim = fromMiddle > half - 2 * scale;
      std::uint32_t& shown = *picture.at(x, y);
      if (!mark.isHidden)
        shown = toXrgb(isRim ? mark.rim : mark.color);
      else if (isRim)
        shown = toXrgb(mixed(mark.rim, fromXrgb(shown)));
    }
}

/// What the loader will say of the first light that it has no sector for.
std::optional<std::string> mistakeInPlaces(const Scene& scene, const LightsDescription& described) {
  const Locator locator(scene);
  for (std::size_t i = 0; i < described.lights.size(); ++i) {
    const LightDescription& light = described.lights[i];
    std::optional<SectorId> sector;
    if (light.sector) sector = findSector(scene.level(), light.sector->name);
    if (light.sector && !sector)
      return fmt::format("light {}: there is no sector \"{}\"", i, light.sector->name);
    const auto found = locator.locate(light.source.position, sector, PositionOf::Light);
    if (!found)
      return fmt::format("light {}: {}; {}", i, found.error().message, found.error().advice);
  }
  return std::nullopt;
}

bool isNear(Vec2 pixel, const PixelRows& picture) {
  return pixel.x > -kReach && pixel.y > -kReach && pixel.x < picture.width + kReach &&
         pixel.y < picture.height + kReach;
}

}  // namespace

// --- Events --------------------------------------------------------------------------------------

std::optional<std::size_t> LightsTool::lightAt(Vec2 pixel, const MarkerSpace& space,
                                               int pictureHeight) const {
  if (!areMarksShown_) return std::nullopt;
  std::optional<std::size_t> nearest;
  double least = kReach * letterScale(pictureHeight);
  for (std::size_t i = 0; i < editor_.lights().count(); ++i) {
    const auto mark = markOf(editor_.lights().at(i).source, space);
    if (!mark || length(*mark - pixel) > least) continue;
    least = length(*mark - pixel);
    nearest = i;
  }
  return nearest;
}

bool LightsTool::handle(const PointerEvent& event, const MarkerSpace& space, int pictureHeight) {
  if (!editor_.isDragging()) grip_.reset();  // the file may have been read anew
  if (!editor_.isOpen()) return false;
  switch (event.kind) {
    case PointerEvent::Kind::Press: {
      const auto light = lightAt(event.pixel, space, pictureHeight);
      if (!light) return false;
      release();
      editor_.pick(light);
      editor_.beginDrag();
      const LightDescription& picked = editor_.pickedLight();
      grip_ = Grip{picked, *markOf(picked.source, space) - event.pixel};
      section_.reveal();
      return true;
    }
    case PointerEvent::Kind::Move:
      if (!grip_) return false;
      dragTo(event, space);
      return true;
    case PointerEvent::Kind::Release:
      if (!grip_) return false;
      release();
      return true;
  }
  return false;
}

void LightsTool::dragTo(const PointerEvent& event, const MarkerSpace& space) {
  LightDescription light = grip_->light;
  if (light.source.sun) return dragSunTo(event.pixel + grip_->toMark, space);
  Vec3& position = light.source.position;
  const auto mark = space.pixelOf(position);
  if (!mark) return;  // the eye has turned away from it
  const Vec2 pixel = event.pixel + grip_->toMark;
  grip_->axis = event.axis;
  if (event.isShifted && !event.axis)
    grip_->axis = space.isMap() ? fartherAxis(pixel - *mark) : Axis::Z;
  position = space.dragged(position, pixel, grip_->axis);
  editor_.set(light);
}

void LightsTool::dragSunTo(Vec2 pixel, const MarkerSpace& space) {
  if (space.isMap()) return;
  LightDescription light = grip_->light;
  light.source.sun = sunTowards(space.directionAt(pixel), light.source.sun->size());
  editor_.set(light);
}

std::optional<LightsTool::Drag> LightsTool::drag() const {
  if (!grip_ || !editor_.isDragging() || !editor_.picked()) return std::nullopt;
  if (!editor_.pickedLight().source.hasPlace()) return std::nullopt;
  return Drag{editor_.pickedLight().source.position, grip_->axis};
}

bool LightsTool::handle(const KeyEvent& key, const Scene& scene) {
  if (grip_ && axisOf(key)) return true;
  if (!key.hasCtrl || !editor_.isOpen()) return false;
  switch (key.letter) {
    case 'z':
      if (key.hasShift)
        editor_.redo();
      else
        editor_.undo();
      return true;
    case 'y':
      editor_.redo();
      return true;
    case 's':
      save(scene);
      return true;
    default:
      return key.key == Key::LeftCtrl || key.key == Key::RightCtrl;
  }
}

bool LightsTool::isSave(const KeyEvent& key) { return key.hasCtrl && key.letter == 's'; }

void LightsTool::release() {
  if (editor_.isDragging()) editor_.endDrag();
  grip_.reset();
}

void LightsTool::showMarks(bool areShown) {
  release();
  areMarksShown_ = areShown;
}

void LightsTool::pick(std::size_t light) {
  release();
  if (light >= editor_.lights().count()) return;
  editor_.pick(light);
  section_.reveal();
}

// --- The file ------------------------------------------------------------------------------------

void LightsTool::save(const Scene& scene) {
  release();
  if (const auto mistake = mistakeInPlaces(scene, editor_.lights()))
    editor_.refuse("not saved: " + *mistake);
  else
    editor_.save();
}

// --- New lights ----------------------------------------------------------------------------------

void LightsTool::addBefore(const Scene& scene, const Camera& camera) {
  const Projection view(camera, camera.eye);
  Vec3 position;
  std::optional<SectorId> sector;
  for (std::size_t i = 0; i < kAhead.size() && !sector; ++i) {
    const Vec2 plan = camera.eye.xy() + kAhead.at(i) * view.direction();
    position = {plan.x, plan.y, camera.eye.z};
    sector = seenAt(scene, camera, position);
  }
  add(scene, position, sector);
}

void LightsTool::addSun(const Camera& camera) {
  LightDescription light;
  const double pitch = std::clamp(std::round(camera.pitch), kLowestNewSun, 90.0);
  light.source.sun.emplace(std::round(camera.angle), pitch, 0);
  add(light);
}

void LightsTool::addSky() {
  LightDescription light;
  light.source.isSky = true;
  light.source.intensity = kNewSky;
  add(light);
}

void LightsTool::addEmitter(const std::string& texture) {
  LightDescription light;
  light.source.texture = texture;
  light.source.intensity = kNewEmitter;
  add(light);
}

void LightsTool::addBefore(const Scene& scene, const SurfacePoint& place) {
  const Vec3 begin = nudgedInside(scene, scene[place.sector], place.point);
  const auto met = trace(scene.level(), place.sector, begin, place.normal, RayKind::Look);
  const double free = met ? met->t : kMaxBefore;  // the normal is a unit
  const Vec3 position = place.point + std::min(kMaxBefore, free / 2) * place.normal;
  add(scene, position, sectorAt(scene.level(), place.sector, begin, position));
}

/// Names the sector where a position alone does not say which.
void LightsTool::add(const Scene& scene, Vec3 position, std::optional<SectorId> sector) {
  LightDescription light;
  light.source.falloff = kFirstFalloff;
  light.source.position = {toMillimetres(position.x), toMillimetres(position.y),
                           toMillimetres(position.z)};
  const std::string name = sector ? scene[*sector].name : "";
  const Locator locator(scene);
  if (sector && !locator.locate(light.source.position, std::nullopt, PositionOf::Light))
    light.sector = NameReference{name, {}};
  add(light, sector ? "in " + name : "");
}

void LightsTool::add(const LightDescription& light, const std::string& comment) {
  release();
  editor_.add(light, comment);
  section_.reveal();
}

// --- Marks ---------------------------------------------------------------------------------------

void LightsTool::draw(const Scene& scene, const Camera& camera, const MarkerSpace& space,
                      const PixelRows& picture) const {
  if (!editor_.isOpen() || !areMarksShown_) return;
  constexpr Rgb kRim = {0, 0, 0};
  constexpr Rgb kPickedRim = {255, 255, 255};
  const auto drawLight = [&](std::size_t i) {
    const LightSource& light = editor_.lights().at(i).source;
    const auto pixel = markOf(light, space);
    if (!pixel || !isNear(*pixel, picture)) return;
    const bool isHollow = !space.isMap() && isHidden(scene, camera, light);
    const bool isPicked = editor_.picked() == i;
    const Rgb rim = isHollow ? colorOf(light) : kRim;
    drawMark(picture, *pixel, {colorOf(light), isPicked ? kPickedRim : rim, isHollow});
  };
  for (std::size_t i = 0; i < editor_.lights().count(); ++i) drawLight(i);
  if (editor_.picked()) drawLight(*editor_.picked());  // over all others
}

}  // namespace hearth
