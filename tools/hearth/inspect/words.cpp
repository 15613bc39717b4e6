#include "hearth/inspect/words.h"

#include <fmt/format.h>

#include <cmath>
#include <variant>

namespace hearth {

namespace {

/// Metres or levels, to so many decimals and without zeros at the end.
std::string rounded(double value, int decimals) {
  const double unit = std::pow(10, decimals);
  return fmt::format("{:g}", std::round(value * unit) / unit + 0.0);  // no -0
}

std::string metres(double value) { return fmt::format("{}", std::round(value * 1e3) / 1e3 + 0.0); }

std::string wallWords(const Level& level, const TruthHit& place) {
  const Segment& segment = level[*place.segment];
  const Sector& sector = level[segment.sector];
  std::string words = sector.name;
  if (segment.loop > 0) words += "/" + sector.loops[segment.loop].name;
  words += fmt::format(", wall {}", segment.wall);
  if (std::holds_alternative<Stack>(segment.kind)) words += fmt::format(" part {}", place.subWall);
  return words;
}

std::string falloffWords(const LightSource& light) {
  return light.curve.empty() ? fmt::format("falloff {:g}", light.falloff) : "by its curve";
}

std::string weakWords(const Level& level, const LightFinding& finding) {
  const std::string cosine = finding.unshaded < finding.level ? ", and grazes the surface" : "";
  return fmt::format("too weak here: {} levels at {} m, {}{}", rounded(finding.level, 2),
                     rounded(finding.distance, 2), falloffWords(level.lights[finding.light]),
                     cosine);
}

}  // namespace

std::string surfaceWords(const Level& level, const TruthHit& place) {
  if (!place.segment) return fmt::format("{} of {}", name(place.kind), level[place.sector].name);
  if (!isSidewall(place.kind))
    return fmt::format("{} of {}", name(place.kind), wallWords(level, place));
  return fmt::format("{} of {}, seen through {}", name(place.kind),
                     level[wedgeOf(level, place)].name, wallWords(level, place));
}

SectorId wedgeOf(const Level& level, const TruthHit& sidewall) {
  const Segment& segment = level[*sidewall.segment];
  const auto nextOf = [](const auto& kind) { return std::get<Portal>(kind).next; };
  if (const Stack* stack = std::get_if<Stack>(&segment.kind))
    return nextOf(stack->subWalls[sidewall.subWall].kind);
  return nextOf(segment.kind);
}

std::string pointWords(Vec3 point) {
  return fmt::format("{},{},{}", metres(point.x), metres(point.y), metres(point.z));
}

std::string reasonWords(const Level& level, const LightFinding& finding) {
  switch (finding.reason) {
    case LightReason::Lights:
      return finding.seenShare < 1 ? fmt::format("{:.0f} % of it seen", 100 * finding.seenShare)
                                   : "";
    case LightReason::TooWeak:
      return weakWords(level, finding);
    case LightReason::FacesAway:
      return "faces away: the light is behind this surface";
    case LightReason::InPlane:
      return "in the plane of the surface";
    case LightReason::Blocked:
      return fmt::format("blocked by {} at {}", surfaceWords(level, *finding.blocker),
                         pointWords(finding.blocker->point));
    case LightReason::NotReached:
      return "not reached: no straight way from its part of the level";
  }
  return "";
}

}  // namespace hearth
