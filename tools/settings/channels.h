#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "image/image.h"
#include "math/parallel.h"
#include "render/renderer.h"

/// Pictures other than the lit level, by the names that `--channel` takes.
namespace hearth {

enum class ChannelKind {
  Marks,     ///< on the lit level
  Numbers,   ///< the renderer's own
  Geometry,  ///< alone: needs no light
};

struct ChannelText {
  std::string_view name;
  ChannelKind kind;
  std::string_view shows;
};

/// All channels, in the order of the option's choices.
std::vector<ChannelText> channelTexts();

/// Whether this names a channel of geometry alone; the empty name does not.
bool isGeometry(std::string_view channel);

/// Whether the pixels of a channel show what the camera sees there. An empty name is the level
/// itself.
bool isOfCamera(std::string_view channel);

/// A picture of the camera's size, if the channel is one of geometry alone.
std::optional<Image> drawGeometry(const Scene& scene, const Camera& camera,
                                  std::string_view channel);

/// Draws any channel, into a picture of the camera's size. The renderer is the scene's. The
/// workers, if any, help with marks and numbers.
void drawChannel(const Scene& scene, const Renderer& renderer, const Camera& camera,
                 std::string_view channel, FrameScratch& scratch, const PixelRows& picture,
                 Workers* workers = nullptr);

}  // namespace hearth
