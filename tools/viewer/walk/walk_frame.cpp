#include "viewer/walk/walk_frame.h"

#include <fmt/format.h>

#include "settings/settings.h"
#include "settings/shell_text.h"

namespace hearth {

namespace {

std::string_view nameOf(LightMode mode) {
  switch (mode) {
    case LightMode::Both:
      return "both";
    case LightMode::None:
      return "none";
    case LightMode::Only:
      return "only";
  }
  return "";
}

}  // namespace

std::string shotOptionsOf(const WalkFrame& frame, const Level& level,
                          const DrawSettings& settings) {
  const Camera& camera = frame.camera;
  const std::string drawOptions = optionsOf(settings);
  const std::string what = frame.view.channel.empty()
                               ? fmt::format("--light {}", nameOf(frame.view.mode))
                               : fmt::format("--channel {}", frame.view.channel);
  const std::string time = camera.seconds > 0 ? fmt::format("--time {} ", camera.seconds) : "";
  std::string movers;
  for (std::size_t i = 0; i < frame.shares.size(); ++i)
    if (frame.shares[i] != 0)
      movers += fmt::format("--mover {} ",
                            shellWord(fmt::format("{}={}", level.movers[i].name, frame.shares[i])));
  return fmt::format("--camera {},{},{},{},{} --sector {} --fov {} --size {}x{} {}{}{}{}",
                     camera.eye.x, camera.eye.y, camera.eye.z, camera.angle, camera.pitch,
                     shellWord(level[camera.sector].name), camera.fov, camera.width, camera.height,
                     time, movers, what, drawOptions.empty() ? "" : " " + drawOptions);
}

}  // namespace hearth
