#include <fmt/format.h>

#include <cmath>

#include "load/link/link.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

bool isFar(double coordinate) { return std::abs(coordinate) > kPreciseReach; }

/// The first coordinate of a sector that lies beyond kPreciseReach.
struct FarPlace {
  Place place;
  double coordinate;
};

std::optional<FarPlace> farPlaceOf(const SectorDescription& sector) {
  for (const FlatDescription* flat : {&sector.floor, &sector.ceiling})
    if (isFar(flat->z)) return FarPlace{flat->zPlace, flat->z};
  for (const LoopDescription& loop : sector.loops)
    for (std::size_t i = 0; i < loop.vertices.size(); ++i)
      for (const double coordinate : {loop.vertices[i].x, loop.vertices[i].y})
        if (isFar(coordinate)) return FarPlace{loop.vertexPlaces[i], coordinate};
  return std::nullopt;
}

}  // namespace

void validateReach(Linking& linking) {
  for (const SectorDescription& sector : linking.description.sectors)
    if (const std::optional<FarPlace> far = farPlaceOf(sector))
      return linking.report.warning(
          far->place,
          fmt::format("{} is so far from the origin that light may miss its surfaces",
                      far->coordinate),
          fmt::format("move the level to within {:.0f} m of it", kPreciseReach), "far-away");
}

}  // namespace hearth
