#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>

#include "import/doom/game.h"
#include "import/doom/ground_plan.h"
#include "import/doom/light_table.h"
#include "import/doom/materials.h"
#include "load/limits.h"

namespace hearth::doom {

/// More are refused where levels are loaded.
inline constexpr std::size_t kMaxLights = LoadLimits{}.lights;

/// Whether walls and flats that shine are lights at points before them; or emitters, and the sky
/// shines, too, and a sun.
enum class LightFrom : std::uint8_t { Points, Areas };

struct LightSettings {
  Game game{};
  LightFrom from = LightFrom::Points;
  std::size_t most = kMaxLights;
};

/// The lights of a map as a lights file holds them: where its things shine, and those of its walls,
/// floors and ceilings that do. `materials` have the images of the level.
nlohmann::ordered_json lightsJson(const GroundPlan& plan, const LightTable& table,
                                  const Materials& materials, const LightSettings& settings,
                                  Findings& findings);

}  // namespace hearth::doom
