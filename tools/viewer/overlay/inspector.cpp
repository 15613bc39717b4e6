#include "viewer/overlay/inspector.h"

#include <imgui/imgui.h>

#include <algorithm>
#include <utility>

#include "level/locate.h"
#include "load/positions.h"
#include "math/tolerance.h"
#include "viewer/overlay/inspector_section.h"
#include "viewer/overlay/light_rays.h"

namespace hearth {

void Inspector::handle(const Event& event, int width) {
  const auto over = [width](int x, int y) {
    return x < width ? std::optional(Pixel{x, y}) : std::nullopt;
  };
  if (const auto* motion = std::get_if<MouseMotion>(&event)) mouse_ = over(motion->x, motion->y);
  if (is(event, WindowEvent::MouseLeft)) mouse_.reset();
  const auto* button = std::get_if<MouseButtonEvent>(&event);
  if (!button || !button->isDown || button->button != MouseButton::Left) return;
  mouse_ = over(button->x, button->y);
  isClicked_ |= mouse_.has_value();
}

bool Inspector::letGo() { return std::exchange(pinned_, std::nullopt).has_value(); }

Inspector::Look Inspector::lookThrough(Pixel pixel, const InspectedLevel& in,
                                       const Camera& camera) const {
  const Projection projection = projectionFor(in.scene, camera);
  const Vec2 ray = projection.rayOf(pixel.x + 0.5);
  return {in.scene[camera.sector].name,
          projection.eye(),
          {ray.x, ray.y, projection.raySlopeAt(pixel.y + 0.5)},
          turned90(projection.direction())};
}

/// Where the eye is in no sector of that name any more, nothing is found.
void Inspector::find(const Look& look, const InspectedLevel& in) {
  if ((found_ || isThingFound()) && look_ == look) return;
  look_ = look;
  forget();
  const auto sector = findSector(in.scene.level(), look.sector);
  if (!sector || !contains(in.scene, in.scene[*sector], look.eye, kPositionSlack)) return;
  const Vec3 eye = nudgedInside(in.scene, in.scene[*sector], look.eye);
  const auto hit = trace(in.scene.level(), *sector, eye, look.direction, RayKind::Look);
  if (!hit) return;
  sprite_ = spriteAt(in.scene, in.renderer.textures(),
                     {*sector, eye, look.direction, look.pictureRight}, hit->t);
  mesh_ = meshAt(in.scene.level(), *sector, eye, look.direction);
  if (sprite_ && mesh_) {
    if (hides(in.scene.level(), *mesh_, *sprite_))
      sprite_.reset();
    else
      mesh_.reset();
  }
  if (!isThingFound()) found_ = inspect(in.scene, in.renderer.light(), in.settings, *hit);
}

std::optional<std::string> Inspector::show(const InspectedLevel& in, const Camera& camera) {
  const bool isClicked = std::exchange(isClicked_, false) && mouse_;
  if (isClicked) pinned_ = lookThrough(*mouse_, in, camera);
  if (isClicked) section_.reveal();
  const bool isOpen = section_.show("Inspector");
  if (!isOpen || (!pinned_ && !mouse_)) forget();
  if (!isOpen) return std::nullopt;
  if (!pinned_ && !mouse_) {
    ImGui::TextUnformatted("Point at a surface in the picture. A click pins the place.");
    return std::nullopt;
  }
  find(pinned_ ? *pinned_ : lookThrough(*mouse_, in, camera), in);
  if (isThingFound()) {
    const Level& level = in.scene.level();
    const InspectorRequest asked =
        sprite_ ? showSprite(level, *sprite_, in.renderer.light(), in.source, pinned_.has_value())
                : showMesh(level, *mesh_, in.renderer.light(), in.source, pinned_.has_value());
    if (asked.letsGo) letGo();
    return asked.copied;
  }
  if (!found_) return std::nullopt;
  const Texture& texture = in.renderer.texture(found_->place.texture->texture);
  LightsTool* const lights = in.lights && in.lights->editor().isOpen() ? in.lights : nullptr;
  const InspectorRequest asked =
      showInspection(*found_,
                     {in.scene.level(), texture, in.source, lights != nullptr,
                      lights ? lights->editor().picked() : std::nullopt},
                     pinned_.has_value());
  if (in.isInPicture) drawLightRays(*found_, asked.light, in.scene, camera);
  if (lights && asked.picked) lights->pick(*asked.picked);
  if (lights && asked.addsLight) lights->addBefore(in.scene, found_->place);
  if (lights && asked.letsShine)
    lights->addEmitter(in.scene.level().textures[found_->place.texture->texture.index()]);
  if (asked.letsGo) letGo();
  return asked.copied;
}

}  // namespace hearth
