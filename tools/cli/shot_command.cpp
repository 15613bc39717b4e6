#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "cli/command.h"
#include "image/image_file.h"
#include "inputs/inputs.h"
#include "inputs/moved_light.h"
#include "render/renderer.h"
#include "settings/channels.h"

namespace hearth {

namespace {

/// The level at the shares that the options ask for.
struct ShownLevel {
  MovedLevel level;
  std::vector<double> shares;  ///< by mover
};

tl::expected<ShownLevel, std::string> shownLevel(const OpenedLevel& opened,
                                                 const OptionValues& values) {
  const LoadedLevel& authored = *opened.result.loaded;
  auto shares = moverSharesFor(authored.level, values);
  if (!shares) return tl::unexpected(shares.error());
  auto loaded = loadedAt(authored, opened.source, *shares, values);
  if (!loaded) return tl::unexpected(loaded.error());
  return ShownLevel{*std::move(loaded), *std::move(shares)};
}

/// Baked only where it shows, unless it is that of several states.
tl::expected<BakedLight, std::string> lightOf(const ShownLevel& shown, const OpenedLevel& opened,
                                              const Camera& camera, const OptionValues& values) {
  if (restStatesFor(shown.shares, values).count() == 1)
    return lightInView(shown.level->scene(), camera, values);
  return MovedLight(*opened.result.loaded, opened.source, values).at(*shown.level, shown.shares);
}

/// The picture that the options ask for.
tl::expected<Image, std::string> picture(const ShownLevel& shown, const OpenedLevel& opened,
                                         const Camera& camera, const OptionValues& values) {
  const LoadedLevel& loaded = *shown.level;
  const std::optional<std::string> channel = values.text(Option::Channel);
  if (channel)
    if (auto geometry = drawGeometry(loaded.scene(), camera, *channel)) return *std::move(geometry);
  const auto light = lightOf(shown, opened, camera, values);
  if (!light) return tl::unexpected(light.error());
  const Renderer renderer(loaded.scene(), loaded.textures, *light, drawSettingsFrom(values));
  if (!channel) return renderer.draw(camera, lightModeFrom(values));
  FrameScratch scratch;
  PixelBuffer memory;
  const PixelRows rows = memory.rows(camera.width, camera.height);
  Workers workers(threadsFrom(values));
  drawChannel(loaded.scene(), renderer, camera, *channel, scratch, rows, &workers);
  return imageOf(rows);
}

/// A name that promises a picture of another kind. Any other name is the user's business.
std::optional<std::string> mistakeInName(const std::filesystem::path& output) {
  constexpr std::array<std::string_view, 6> kOthers{".jpg", ".jpeg", ".bmp",
                                                    ".tga", ".gif",  ".webp"};
  std::string ending = output.extension().string();
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  if (std::ranges::find(kOthers, ending) == kOthers.end()) return std::nullopt;
  return fmt::format("-o: {}: pictures are written as PNG: name it {}", output.string(),
                     std::filesystem::path(output).replace_extension(".png").string());
}

std::optional<std::string> mistakeInShotOptions(const OptionValues& values) {
  if (values.has(Option::Channel) && values.has(Option::Light))
    return "give --light or --channel, not both";
  return mistakeInName(*values.text(Option::Output));
}

ExitStatus runShot(const OptionValues& values) {
  if (const auto mistake = mistakeInShotOptions(values)) return fail(*mistake);
  const OpenedLevel opened = loadAndReportWithSource(values);
  if (!opened.result.loaded) return ExitStatus::BadInput;
  const auto shown = shownLevel(opened, values);
  if (!shown) return fail(shown.error());
  const auto camera = cameraFor(shown->level->scene(), values, {320, 200});
  if (!camera) return fail(camera.error());
  const auto image = picture(*shown, opened, *camera, values);
  if (!image) return fail(image.error());
  const auto written = writePng(*values.text(Option::Output), *image);
  return written ? ExitStatus::Done : fail(written.error());
}

}  // namespace

Command shotCommand() {
  return {
      "shot",
      "bakes and draws one picture, of a level or of a model alone (MODEL.obj); needs no display",
      std::vector<Option>{Option::Output, Option::Camera, Option::Sector, Option::Shot,
                          Option::Mover, Option::MoverStages, Option::Size, Option::Fov,
                          Option::Time, Option::Light, Option::Channel, Option::Quiet} +
          drawOptions() + lightOptions(),
      {Option::Output},
      runShot};
}

}  // namespace hearth
