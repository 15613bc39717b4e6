#pragma once

#include <gtest/gtest.h>

#include <string>

#include "load/load.h"
#include "support/in_tree.h"

namespace hearth {

/// A level file of the project, by its path from the top folder.
inline LoadedLevel loaded(const std::string& path) {
  LoadResult result = loadLevel(test::inTree(path));
  for (const Diagnostic& diagnostic : result.diagnostics)
    if (diagnostic.isError) ADD_FAILURE() << format(diagnostic);
  return std::move(result.loaded).value();
}

inline SectorId sectorNamed(const Level& level, const std::string& name) {
  for (std::size_t i = 0; i < level.sectors.size(); ++i)
    if (level.sectors[i].name == name) return SectorId(i);
  ADD_FAILURE() << "no sector " << name;
  return {};
}

}  // namespace hearth
