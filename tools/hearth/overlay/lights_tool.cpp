#include "hearth/overlay/lights_tool.h"

#include <SDL_keycode.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "hearth/overlay/overlay.h"
#include "level/locate.h"
#include "light/raytracer.h"

namespace hearth {

namespace {

// Of a mark, in pixels of letters: a diamond, and how far from its middle it can be picked.
constexpr int kHalfDiagonal = 5;
constexpr int kReach = 8;

/// Metres before the eye at which a light is put, the first that nothing hides.
constexpr std::array kAhead = {1.5, 1.0, 0.5, 0.25};

/// Enough to see what is near, and not all that is far.
constexpr double kFirstFalloff = 0.5;

bool isVisible(const Level& level, const Camera& camera, Vec3 point) {
  const Vec3 eye = nudgedInside(level, level[camera.sector], camera.eye);
  SectorSet met;
  return Raytracer(level).sectorAt({eye, camera.sector}, point, met).has_value();
}

Rgb colorOf(const LightSource& light) { return {light.color[0], light.color[1], light.color[2]}; }

Rgb mixed(Rgb a, Rgb b) {
  const auto mean = [](std::uint8_t x, std::uint8_t y) {
    return static_cast<std::uint8_t>((x + y) / 2);
  };
  return {mean(a.r, b.r), mean(a.g, b.g), mean(a.b, b.b)};
}

struct Mark {
  Rgb color;
  Rgb rim;
  bool isDim;
};

void drawMark(Image& picture, Vec2 pixel, const Mark& mark) {
  const int scale = letterScale(picture.height());
  const int half = scale * kHalfDiagonal;
  const int left = static_cast<int>(std::lround(pixel.x));
  const int top = static_cast<int>(std::lround(pixel.y));
  for (int y = std::max(0, top - half); y <= std::min(picture.height() - 1, top + half); ++y)
    for (int x = std::max(0, left - half); x <= std::min(picture.width() - 1, left + half); ++x) {
      const int fromMiddle = std::abs(x - left) + std::abs(y - top);
      if (fromMiddle > half) continue;
      const Rgb color = fromMiddle > half - 2 * scale ? mark.rim : mark.color;
      picture.at(x, y) = mark.isDim ? mixed(color, picture.at(x, y)) : color;
    }
}

bool isNear(Vec2 pixel, const Image& picture) {
  return pixel.x > -kReach && pixel.y > -kReach && pixel.x < picture.width() + kReach &&
         pixel.y < picture.height() + kReach;
}

}  // namespace

// --- Events --------------------------------------------------------------------------------------

std::optional<std::size_t> LightsTool::lightAt(Vec2 pixel, const MarkerSpace& space,
                                               int pictureHeight) const {
  std::optional<std::size_t> nearest;
  double least = kReach * letterScale(pictureHeight);
  for (std::size_t i = 0; i < editor_.lights().lights.size(); ++i) {
    const auto mark = space.pixelOf(editor_.lights().lights[i].source.position);
    if (!mark || length(*mark - pixel) > least) continue;
    least = length(*mark - pixel);
    nearest = i;
  }
  return nearest;
}

bool LightsTool::take(const PointerEvent& event, const MarkerSpace& space, int pictureHeight) {
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
      grip_ = Grip{picked, *space.pixelOf(picked.source.position) - event.pixel};
      hasPicked_ = true;
      return true;
    }
    case PointerEvent::Kind::Move:
      if (!grip_) return false;
      drag(event, space);
      return true;
    case PointerEvent::Kind::Release:
      if (!grip_) return false;
      release();
      return true;
  }
  return false;
}

void LightsTool::drag(const PointerEvent& event, const MarkerSpace& space) {
  LightDescription light = grip_->light;
  Vec3& position = light.source.position;
  if (!space.pixelOf(position)) return;  // the eye has turned away from it
  position = space.dragged(position, event.pixel + grip_->toMark, event.isShifted);
  editor_.set(light);
}

bool LightsTool::take(const SDL_KeyboardEvent& key) {
  if ((key.keysym.mod & KMOD_CTRL) == 0 || !editor_.isOpen()) return false;
  const bool isShifted = (key.keysym.mod & KMOD_SHIFT) != 0;
  switch (key.keysym.sym) {
    case SDLK_z:
      if (isShifted)
        editor_.redo();
      else
        editor_.undo();
      return true;
    case SDLK_y:
      editor_.redo();
      return true;
    case SDLK_s:
      release();
      editor_.save();
      return true;
    default:
      return key.keysym.sym == SDLK_LCTRL || key.keysym.sym == SDLK_RCTRL;
  }
}

void LightsTool::release() {
  if (editor_.isDragging()) editor_.endDrag();
  grip_.reset();
}

void LightsTool::addBefore(const Level& level, const Camera& camera) {
  release();
  const Projection view(camera, camera.eye);
  LightDescription light;
  light.source.falloff = kFirstFalloff;
  for (const double ahead : kAhead) {
    const Vec2 plan = camera.eye.xy() + ahead * view.direction();
    light.source.position = {toMillimetres(plan.x), toMillimetres(plan.y),
                             toMillimetres(camera.eye.z)};
    if (isVisible(level, camera, light.source.position)) break;
  }
  editor_.add(light);
  hasPicked_ = editor_.picked().has_value();
}

// --- Marks ---------------------------------------------------------------------------------------

void LightsTool::draw(const Level& level, const Camera& camera, const MarkerSpace& space,
                      Image& picture) const {
  if (!editor_.isOpen()) return;
  constexpr Rgb kRim = {0, 0, 0};
  constexpr Rgb kPickedRim = {255, 255, 255};
  const auto drawLight = [&](std::size_t i) {
    const LightSource& light = editor_.lights().lights[i].source;
    const auto pixel = space.pixelOf(light.position);
    if (!pixel || !isNear(*pixel, picture)) return;
    const bool isHidden = !space.isMap() && !isVisible(level, camera, light.position);
    const bool isPicked = editor_.picked() == i;
    drawMark(picture, *pixel, {colorOf(light), isPicked ? kPickedRim : kRim, isHidden});
  };
  for (std::size_t i = 0; i < editor_.lights().lights.size(); ++i) drawLight(i);
  if (editor_.picked()) drawLight(*editor_.picked());  // over all others
}

}  // namespace hearth
