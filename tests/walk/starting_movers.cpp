#include "walk_tests/starting_movers.h"

#include <algorithm>

namespace hearth::random_walks {

namespace {

using random_levels::Random;

SectorId anySector(const Level& level, Random& random) {
  return SectorId(random.below(level.sectors.size()));
}

std::uint32_t anySubWall(const Wall& wall, Random& random) {
  const Stack* stack = std::get_if<Stack>(&wall);
  return stack ? static_cast<std::uint32_t>(random.below(stack->subWalls.size())) : 0;
}

MoverSwitch anySwitch(const Level& level, std::size_t mover, Random& random) {
  const Segment& segment = level.segments[random.below(level.segments.size())];
  if (targetsOf(segment.wall).empty() || random.chance(0.5))
    return {segment.id, std::nullopt, mover, false};
  return {segment.id, anySubWall(segment.wall, random), mover, true};
}

void letStart(Level& level, std::size_t index, Random& random) {
  Mover& mover = level.movers[index];
  mover.trigger =
      random.pick({MoverTrigger::None, MoverTrigger::Use, MoverTrigger::Enter, MoverTrigger::Loop});
  mover.speed = random.pick({0.5, 1.5, 4.0, 20.0});
  if (random.chance(0.7)) mover.wait = random.pick({0.0, 0.25, 2.0});
  if (mover.trigger == MoverTrigger::Enter)
    for (int i = 0; i < 3; ++i) mover.zones.push_back(anySector(level, random));
  for (int i = 0; i < 6; ++i) level.switches.push_back(anySwitch(level, index, random));
}

}  // namespace

void letStart(Level& level, Random& random) {
  for (std::size_t i = 0; i < level.movers.size(); ++i) letStart(level, i, random);
  std::ranges::stable_sort(level.switches, {}, &MoverSwitch::segment);
}

}  // namespace hearth::random_walks
