#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <tl/expected.hpp>

#include "cli/command.h"
#include "files/replace_file.h"
#include "level/scene.h"
#include "settings/shell_text.h"
#include "walk/body.h"

namespace hearth {

namespace {

/// As `hearth fmt` lays it out; in braces are the level's name as JSON and the player's sizes.
constexpr std::string_view kLevel = R"({{
  "version": 1,
  "name": {name},
  "//": "Two rooms, and a doorway with a step between them. Lengths are in metres, angles in degrees; x runs to the right and y down the plan, z upwards. A key \"//\" is a comment.",
  "light": 0.1,
  "player": {{
    "//": "z is that of the eye. The player is {width:g} m wide and {height:g} m high, {crouched:g} m when crouching, and climbs steps of {step:g} m.",
    "sector": "hall", "x": 1.5, "y": 2, "z": 1.6, "angle": 0
  }},
  "shots": [
    {{ "//": "a picture that `hearth check` keeps: x, y, z, angle, pitch",
      "name": "hall", "camera": [0.5, 3.5, 1.6, -25, 0] }}
  ],
  "sectors": {{
    "hall": {{
      "//": "A texture is a colour, or the name of an image without its extension. Images are looked for in ../textures and beside this file; to have them elsewhere, write \"textures\": \"FOLDER\", below \"name\" at the top: a folder as seen from this file.",
      "floor":   {{ "z": 0, "texture": "#6e5a46" }},
      "ceiling": {{ "z": 2.8, "texture": "#b4aa96" }},
      "loops": {{
        "border": {{
          "//": "The corners of the room, clockwise on the plan: x, y, x, y ... The first wall runs from the first corner to the second.",
          "v": [0,0, 5,0, 5,1, 5,3, 5,4, 0,4],
          "walls": [
            {{ "texture": "#a08c78" }},
            {{ "texture": "#a08c78" }},
            {{ "//": "the doorway: from (5, 1) to (5, 3); below it shows the step, above it the lintel",
              "next": "study", "lower": "#5a4b3c", "upper": "#a08c78" }},
            {{ "texture": "#a08c78" }},
            {{ "texture": "#a08c78" }},
            {{ "texture": "#a08c78" }}
          ]
        }}
      }}
    }},
    "study": {{
      "floor":   {{ "z": 0.2, "texture": "#46505a" }},
      "ceiling": {{ "z": 2.4, "texture": "#969ba0" }},
      "loops": {{
        "border": {{
          "v": [5,1, 9,1, 9,3, 5,3],
          "walls": [
            {{ "texture": "#78828c" }},
            {{ "texture": "#78828c" }},
            {{ "texture": "#78828c" }},
            {{ "//": "and back, along the same line", "next": "hall" }}
          ]
        }}
      }}
    }}
  }}
}}
)";

constexpr std::string_view kLights = R"({
  "version": 1,
  "//": "Lights are baked into lightmaps when the level is opened. \"falloff\" is how fast one grows weaker, per metre; \"radius\" makes it a ball, whose shadows are soft.",
  "lights": [
    { "//": "in the hall",
      "x": 1.5, "y": 1.2, "z": 2.3, "intensity": 230, "falloff": 0.3, "color": "#ffe8c8",
      "radius": 0.1 },
    { "//": "in the study",
      "x": 8.2, "y": 1.7, "z": 1.4, "intensity": 210, "falloff": 1.5, "color": "#a0c8ff" }
  ]
}
)";

/// As `kLevel`.
constexpr std::string_view kGridLevel = R"({{
  "version": 1,
  "name": {name},
  "//": "A dungeon drawn as a grid. Lengths are in metres, angles in degrees; x runs to the right and y down the rows, z upwards. A key \"//\" is a comment.",
  "light": 0.1,
  "player": {{
    "//": "z is that of the eye. The player is {width:g} m wide and {height:g} m high, {crouched:g} m when crouching, and climbs steps of {step:g} m.",
    "x": 3, "y": 3, "z": 1.6, "angle": 0
  }},
  "shots": [
    {{ "//": "a picture that `hearth check` keeps: x, y, z, angle, pitch",
      "name": "hall", "camera": [6.5, 11.2, 1.8, 345, 0] }}
  ],
  "grid": {{
    "cell": 2,
    "rows": [
      "##########",
      "#.....#..#",
      "#.###+#.##",
      "#.#ooo+..#",
      "#.+oMo####",
      "#.#ooo+..#",
      "##########"
    ],
    "legend": {{
      "//": "What a character of the rows stands for. A texture is a colour, or the name of an image without its extension, with the metres that one repeat covers: \"brick 2,2\".",
      "#": {{ "//": "with \"wall\": solid", "wall": "#a08c78" }},
      "M": {{ "wall": "#b4aa96" }},
      ".": {{
        "//": "without: air. Cells of one entry that touch are one sector, called by its first cell: \".1,1\".",
        "floor":   {{ "texture": "#6e5a46" }},
        "ceiling": {{ "z": 2.6, "texture": "#8c8070" }}
      }},
      "+": {{
        "//": "A doorway: \"upper\" is the wall above it, seen from where the ceiling is higher.",
        "floor":   {{ "texture": "#46505a" }},
        "ceiling": {{ "z": 2.1, "texture": "#5a4b3c" }},
        "upper": "#a08c78"
      }},
      "o": {{
        "//": "The hall: \"lower\" is the wall below it, seen from where the floor is lower.",
        "light": 0.15,
        "floor":   {{ "z": 0.2, "texture": "#784646" }},
        "ceiling": {{ "z": 4, "texture": "#969ba0" }},
        "lower": "#5a4b3c"
      }}
    }}
  }}
}}
)";

constexpr std::string_view kGridLights = R"({
  "version": 1,
  "//": "Lights are baked into lightmaps when the level is opened. \"falloff\" is how fast one grows weaker, per metre; \"radius\" makes it a ball, whose shadows are soft.",
  "lights": [
    { "//": "in the hall",
      "x": 7.3, "y": 7.2, "z": 3, "intensity": 230, "falloff": 0.2, "color": "#ffe8c8",
      "radius": 0.1 },
    { "//": "in the passages",
      "x": 7, "y": 3, "z": 2, "intensity": 210, "falloff": 0.5, "color": "#ffb070" },
    { "x": 17, "y": 3, "z": 2, "intensity": 210, "falloff": 0.8, "color": "#a0c8ff" },
    { "x": 17, "y": 11, "z": 2, "intensity": 210, "falloff": 0.8, "color": "#ffb070" }
  ]
}
)";

/// What `hearth new` writes.
struct NewLevel {
  std::string_view level;
  std::string_view lights;
};

using Written = tl::expected<void, std::string>;

/// Writes a file that is not there yet.
Written writeNew(const std::filesystem::path& path, std::string_view text) {
  const auto created = createFile(path, [&](std::ostream& stream) {
    stream << text;
    return stream.good();
  });
  if (!created) return tl::unexpected(created.error());
  if (*created) return {};
  return tl::unexpected(fmt::format("{}: is there already; choose another name", path.string()));
}

Written writeLevel(const NewLevel& texts, const std::filesystem::path& level,
                   const std::filesystem::path& lights) {
  const std::string name = nlohmann::json(level.stem().string())
                               .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  if (auto written = writeNew(lights, texts.lights); !written) return written;
  const Player player;
  const std::string text =
      fmt::format(fmt::runtime(texts.level), fmt::arg("name", name),
                  fmt::arg("width", 2 * player.radius), fmt::arg("height", player.height),
                  fmt::arg("crouched", bodyOf({}, 1).height), fmt::arg("step", player.stepHeight));
  auto written = writeNew(level, text);
  std::error_code ignored;
  if (!written) std::filesystem::remove(lights, ignored);
  return written;
}

ExitStatus runNew(const OptionValues& values) {
  std::filesystem::path level = values.level;
  if (level.extension() != ".json") level += ".json";
  std::filesystem::path lights = level;
  lights.replace_extension(".lights.json");
  const NewLevel texts =
      values.has(Option::Grid) ? NewLevel{kGridLevel, kGridLights} : NewLevel{kLevel, kLights};
  if (const auto written = writeLevel(texts, level, lights); !written) return fail(written.error());
  fmt::print("{} and {}: edit them, and walk with\n    {} walk {}\n", level.string(),
             lights.string(), values.program, shellWord(level.string()));
  return ExitStatus::Done;
}

}  // namespace

Command newCommand() {
  return {"new",
          "writes a small level with comments and lights, to begin with",
          {Option::Grid},
          {},
          runNew};
}

}  // namespace hearth
