#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "image/image.h"
#include "render/renderer.h"

/// What a picture can show besides the lit level, by the names that `--channel` takes.
namespace hearth {

/// In the order of the option's choices.
std::vector<std::string_view> channelNames();

/// A picture of the camera's size, if the channel is one of geometry alone, which needs no light.
std::optional<Image> drawGeometry(const Level& level, const Camera& camera,
                                  std::string_view channel);

/// The same of any channel. The renderer is the level's.
Image drawChannel(const Level& level, const Renderer& renderer, const Camera& camera,
                  std::string_view channel);

}  // namespace hearth
