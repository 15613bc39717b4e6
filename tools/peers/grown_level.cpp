#include "peers/grown_level.h"

#include <algorithm>
#include <utility>

#include "level/locate.h"

namespace hearth {

namespace {

constexpr ImageSize kGrownPicture{320, 200};
constexpr int kHeadings = 16;
constexpr int kRounds = 20;

SectorId sectorAt(const Scene& scene, Vec3 eye) {
  const auto& sectors = scene.level().sectors;
  const auto found = std::ranges::find_if(
      sectors, [&](const Sector& sector) { return contains(scene, sector, eye, 0); });
  return SectorId(static_cast<std::size_t>(found - sectors.begin()));
}

}  // namespace

tl::expected<std::shared_ptr<GrownLevel>, std::string> GrownLevel::of(
    const std::filesystem::path& file, Vec3 eye) {
  LoadResult result = loadLevel(file);
  std::filesystem::remove(file);
  if (!result.loaded) return tl::unexpected(format(result.diagnostics.front()));
  return std::make_shared<GrownLevel>(*std::move(result.loaded), eye);
}

GrownLevel::GrownLevel(LoadedLevel level, Vec3 eye)
    : level_(PeerLevel::unlit(std::move(level))),
      start_(sectorAt(level_.loaded.scene(), eye)),
      eye_(eye),
      frames_(kGrownPicture) {}

FrameBench GrownLevel::measure(const Clock& clock) {
  drawAll(clock);
  frames_.begin();
  for (int i = 0; i < kRounds; ++i) drawAll(clock);
  return frames_.result();
}

std::vector<Image> GrownLevel::pictures() const {
  std::vector<Image> pictures;
  for (int i = 0; i < kHeadings; ++i)
    pictures.push_back(level_.renderer.draw(cameraTo(i), LightMode::Both));
  return pictures;
}

Camera GrownLevel::cameraTo(int heading) const {
  Camera camera{start_, eye_, 360.0 * heading / kHeadings};
  camera.width = kGrownPicture.width;
  camera.height = kGrownPicture.height;
  return camera;
}

void GrownLevel::drawAll(const Clock& clock) {
  for (int i = 0; i < kHeadings; ++i) frames_.draw(level_.renderer, cameraTo(i), clock);
}

}  // namespace hearth
