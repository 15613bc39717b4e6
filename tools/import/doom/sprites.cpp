#include "import/doom/sprites.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace hearth::doom {

namespace {

/// By the index of a view in levels: Doom's rotations go round to the left, those of levels to the
/// right.
std::size_t rotationOf(std::size_t view) {
  const std::size_t count = SpriteSides().size();
  return (count - view) % count;
}

/// Of one image.
SpriteCanvas canvasOf(const PatchHeader& header, bool isMirrored) {
  SpriteCanvas canvas{header.left, header.width - header.left, header.top,
                      header.top - header.height};
  if (isMirrored) std::swap(canvas.left, canvas.right);
  return canvas;
}

SpriteCanvas unionOf(const SpriteCanvas& a, const SpriteCanvas& b) {
  return {std::max(a.left, b.left), std::max(a.right, b.right), std::max(a.top, b.top),
          std::min(a.bottom, b.bottom)};
}

}  // namespace

bool SpriteLook::hasSides() const {
  return std::ranges::any_of(frames, [](const auto& views) { return views.size() > 1; });
}

std::size_t SpriteLook::countImages() const {
  std::size_t count = 0;
  for (const auto& views : frames) count += views.size();
  return count;
}

tl::expected<SpriteLook, std::string> Sprites::lookOf(const ThingType& type) {
  const Animation animation = animationOf(type);
  SpriteLook look;
  look.framesPerSecond = animation.framesPerSecond;
  look.isBright = animation.isBright;
  Views all;
  std::map<char, std::vector<std::string>> files;
  for (const char letter : animation.frames) {
    if (!files.contains(letter)) {
      const auto views = viewsOf(type.sprite + std::string(1, letter));
      if (!views) return tl::unexpected(views.error());
      for (const View& view : *views) files[letter].push_back(view.file);
      all.insert(all.end(), views->begin(), views->end());
    }
    look.frames.push_back(files[letter]);
  }
  if (all.empty()) return tl::unexpected(std::string("it shows nothing"));
  look.canvas = canvasOf(all.front().header, all.front().side.isMirrored);
  for (const View& view : all)
    look.canvas = unionOf(look.canvas, canvasOf(view.header, view.side.isMirrored));
  return drawAll(all, look.canvas).map([&] { return look; });
}

/// Those of a frame, in the order of levels.
tl::expected<Sprites::Views, std::string> Sprites::viewsOf(const std::string& frame) const {
  const SpriteSides* sides = pictures_.sprites().find(frame);
  if (!sides) return tl::unexpected(fmt::format("there is no sprite {}", frame));
  const bool isSame = isSameFromAllSides(*sides);
  Views views;
  for (std::size_t i = 0; i < (isSame ? 1 : sides->size()); ++i) {
    const std::size_t rotation = rotationOf(i);
    const auto& side = (*sides)[rotation];
    if (!side)
      return tl::unexpected(fmt::format("sprite {} has no image {}{}", frame, frame, rotation + 1));
    const auto header = readPatchHeader(side->patch);
    if (!header) return tl::unexpected(fmt::format("sprite {} {}", side->lump, header.error()));
    const std::string name = fmt::format("{}{}", frame, isSame ? 0 : rotation + 1);
    views.push_back({"sprite-" + fileName(name), *side, *header});
  }
  return views;
}

tl::expected<void, std::string> Sprites::drawAll(const Views& views, const SpriteCanvas& canvas) {
  const auto [width, height] = canvas.size();
  if (width > kMaxSide || height > kMaxSide)
    return tl::unexpected(
        fmt::format("sprite {} and its other images take {} x {} pixels where their offsets put "
                    "them: a side may have {}",
                    views.front().side.lump, width, height, kMaxSide));
  for (const View& view : views) {
    if (materials_.find(view.file)) continue;
    if (!materials_.takePixels(canvas.size()))
      return tl::unexpected(fmt::format(
          "sprite {} and the images before it have more pixels than a level's images may",
          view.side.lump));
    materials_.add(view.file, draw(view, canvas));
  }
  return {};
}

/// What is mirrored is drawn on the mirror image of the canvas.
Image Sprites::draw(const View& view, const SpriteCanvas& canvas) {
  const auto& [lump, patch, isMirrored] = view.side;
  Picture picture(canvas.size(), pictures_.palette()[0]);
  const std::vector<int> tops(static_cast<std::size_t>(canvas.size().width),
                              canvas.top - view.header.top);
  const int left = (isMirrored ? canvas.right : canvas.left) - view.header.left;
  if (const auto mistake = drawPatch(patch, left, tops, pictures_.palette(), picture))
    findings_.push_back(
        {Outcome::Repaired, Part::Texture, 0, fmt::format("sprite {} {}", lump, *mistake)});
  const Image image = withHoles(std::move(picture));
  return isMirrored ? mirrored(image) : image;
}

}  // namespace hearth::doom
