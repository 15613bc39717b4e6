#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "load/source.h"

namespace hearth::test {

/// A file that a level names.
struct NamedText {
  std::string_view name;
  std::string_view text;
};

/// A level from the text of its file, of its lights file and of others beside these. Single quotes
/// may stand for double ones. Stops the test program with the loader's messages when the level has
/// a mistake.
LoadedLevel levelFrom(std::string_view levelText, std::string_view lightsText = "[]",
                      const std::vector<NamedText>& others = {});

/// The same, with the way back to the files.
SourcedResult levelWithSourceFrom(std::string_view levelText, std::string_view lightsText = "[]",
                                  const std::vector<NamedText>& others = {});

/// A sector of plain colours: `'name': { ... }`, whose walls are all `walls`.
std::string sectorText(std::string_view name, std::string_view vertices, double floor,
                       double ceiling, std::string_view walls = "{'texture': '#808080'}",
                       std::string_view more = "");

}  // namespace hearth::test
