#include "support/level_text.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "math/check.h"

namespace hearth::test {

namespace {

void write(const std::filesystem::path& file, std::string_view text) {
  std::string json(text);
  std::ranges::replace(json, '\'', '"');
  std::ofstream(file) << json;
}

}  // namespace

SourcedResult levelWithSourceFrom(std::string_view levelText, std::string_view lightsText,
                                  const std::vector<NamedText>& others) {
  const auto folder =
      std::filesystem::temp_directory_path() / fmt::format("hearth-test-{}", ::getpid());
  std::filesystem::create_directories(folder);
  write(folder / "level.json", levelText);
  write(folder / "level.lights.json", lightsText);
  for (const NamedText& other : others) write(folder / other.name, other.text);
  SourcedResult sourced = loadLevelWithSource(folder / "level.json");
  std::filesystem::remove_all(folder);
  std::string messages;
  for (const Diagnostic& diagnostic : sourced.result.diagnostics)
    messages += format(diagnostic) + '\n';
  CHECK(sourced.result.loaded, messages);
  return sourced;
}

LoadedLevel levelFrom(std::string_view levelText, std::string_view lightsText,
                      const std::vector<NamedText>& others) {
  return std::move(*levelWithSourceFrom(levelText, lightsText, others).result.loaded);
}

std::string sectorText(std::string_view name, std::string_view vertices, double floor,
                       double ceiling, std::string_view walls, std::string_view more) {
  return fmt::format(
      "'{}': {{ 'floor': {{'z': {}, 'texture': '#808080'}}, 'ceiling': {{'z': {}, 'texture': "
      "'#808080'}}, 'loops': {{'border': {{'v': [{}], 'walls': {}}}}}{} }}",
      name, floor, ceiling, vertices, walls, more);
}

}  // namespace hearth::test
