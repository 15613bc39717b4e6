#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "inputs/inputs.h"
#include "model/orbit_view.h"

namespace hearth {

namespace {

using CameraResult = tl::expected<Camera, std::string>;

/// A camera that looks from `eye`; its sector is still to be found.
CameraResult located(const Scene& scene, Camera camera, std::string_view option,
                     std::optional<std::string_view> sectorName) {
  const auto sector = locatePosition(scene, camera.eye, sectorName);
  if (!sector) return tl::unexpected(fmt::format("{}: {}", option, sector.error()));
  camera.sector = *sector;
  return camera;
}

CameraResult fromText(const Scene& scene, const std::string& text,
                      std::optional<std::string_view> sectorName) {
  const auto numbers = parseNumbers(text);
  if (!numbers || numbers->size() < 4 || numbers->size() > 5)
    return tl::unexpected(
        fmt::format("--camera: \"{}\" is not X,Y,Z,ANGLE or X,Y,Z,ANGLE,PITCH", text));
  const std::vector<double>& n = *numbers;
  const double pitch = n.size() == 5 ? n[4] : 0;
  if (std::abs(pitch) > kMaxPitch)
    return tl::unexpected(fmt::format("--camera: the pitch {} is outside -60..60", pitch));
  Camera camera;
  camera.eye = {n[0], n[1], n[2]};
  camera.angle = n[3];
  camera.pitch = pitch;
  return located(scene, camera, "--camera", sectorName);
}

CameraResult fromStart(const Scene& scene, const std::string& text) {
  const auto numbers = parseNumbers(text);
  if (!numbers || numbers->size() != 4)
    return tl::unexpected(fmt::format("--start: \"{}\" is not X,Y,Z,ANGLE", text));
  Camera camera;
  camera.eye = {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
  camera.angle = (*numbers)[3];
  return located(scene, camera, "--start", std::nullopt);
}

CameraResult fromShot(const Level& level, const std::string& name) {
  const auto found = std::ranges::find(level.shots, name, &Shot::name);
  if (found != level.shots.end()) return cameraOf(*found);
  std::vector<std::string_view> names;
  for (const Shot& shot : level.shots) names.push_back(shot.name);
  return tl::unexpected(
      fmt::format("--shot: the level has no shot \"{}\"; it has: {}", name,
                  names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "))));
}

CameraResult fromPlayer(const Scene& scene, std::optional<std::string_view> sectorName) {
  const std::optional<Player>& player = scene.level().player;
  if (!player) return tl::unexpected<std::string>("the level has no player: give --camera");
  Camera camera;
  camera.sector = player->sector;
  camera.eye = player->eye;
  camera.angle = player->angle;
  if (!sectorName) return camera;
  return located(scene, camera, "--sector", sectorName);
}

/// Of a model, which is the level's only mesh.
Camera frontCamera(const Scene& scene, double fov, ImageSize size) {
  const OrbitView view = frontView(scene.level().meshFaces, fov, size);
  return {scene.level().meshes.front().sector,
          view.eye(),
          view.angle,
          view.pitch,
          fov,
          size.width,
          size.height,
          0};
}

CameraResult placed(const Scene& scene, const OptionValues& values) {
  const std::optional<std::string> text = values.text(Option::Camera);
  const std::optional<std::string> shot = values.text(Option::Shot);
  const std::optional<std::string> sector = values.text(Option::Sector);
  if (shot && (text || sector))
    return tl::unexpected<std::string>("give --shot, or --camera and --sector, not both");
  if (const std::optional<std::string> start = values.text(Option::Start)) {
    if (text || shot || sector)
      return tl::unexpected<std::string>("give --start, or a camera by other options, not both");
    return fromStart(scene, *start);
  }
  const auto sectorName = sector ? std::optional<std::string_view>(*sector) : std::nullopt;
  if (text) return fromText(scene, *text, sectorName);
  if (shot) return fromShot(scene.level(), *shot);
  return fromPlayer(scene, sectorName);
}

/// Whether the options say where the camera is.
bool isPlaced(const OptionValues& values) {
  return values.has(Option::Camera) || values.has(Option::Shot) || values.has(Option::Start) ||
         values.has(Option::Sector);
}

}  // namespace

CameraResult cameraFor(const Scene& scene, const OptionValues& values, ImageSize standardSize) {
  if (isModel(values.level) && !isPlaced(values)) {
    const auto size = values.text(Option::Size);
    return frontCamera(scene, values.number(Option::Fov).value_or(kModelFov),
                       size ? *parseSize(*size) : standardSize);
  }
  CameraResult camera = placed(scene, values);
  if (!camera) return camera;
  if (isModel(values.level)) camera->fov = kModelFov;  // also that of its shot
  camera->fov = values.number(Option::Fov).value_or(camera->fov);
  camera->seconds = values.number(Option::Time).value_or(camera->seconds);
  if (!values.has(Option::Shot)) {
    camera->width = standardSize.width;
    camera->height = standardSize.height;
  }
  if (const auto text = values.text(Option::Size)) {
    const std::optional<ImageSize> size = parseSize(*text);
    camera->width = size->width;
    camera->height = size->height;
  }
  return camera;
}

}  // namespace hearth
