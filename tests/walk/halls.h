#pragma once

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "support/level_text.h"
#include "walks.h"

/// Plain levels with things in them.
namespace hearth::test {

/// A hall of 12 by 4 m.
inline LoadedLevel hallWith(const std::string& things, double ceiling = 4,
                            const std::vector<NamedText>& models = {}) {
  return levelFrom("{'light':1,'things':[" + things + "],'sectors':{" +
                       sectorText("hall", "0,0, 12,0, 12,4, 0,4", 0, ceiling) + "}}",
                   "[]", models);
}

/// Two rooms of 4 by 4 m, side by side along x, whose common wall is `toEast` as seen from the
/// west.
inline LoadedLevel roomsWith(const std::string& things, const std::string& toEast,
                             const std::string& toWest, const std::vector<NamedText>& models = {}) {
  return levelFrom("{'light':1,'things':[" + things + "],'sectors':{" +
                       sectorText("west", "0,0, 4,0, 4,4, 0,4", 0, 4,
                                  "[" + kSolid + "," + toEast + "," + kSolid + "," + kSolid + "]") +
                       "," +
                       sectorText("east", "4,0, 8,0, 8,4, 4,4", 0, 4,
                                  "[" + kSolid + "," + kSolid + "," + kSolid + "," + toWest + "]") +
                       "}}",
                   "[]", models);
}

/// A wall with a window above a sill of 1.2 m.
inline std::string windowTo(const std::string& next) {
  return "{'walls':[{'z':1.2,'texture':'#808080'},{'next':'" + next + "'}]}";
}

/// Two storeys of 8 by 4 m and 4 m each, `low` and `up`, with nothing between them.
inline LoadedLevel storeysWith(const std::string& things,
                               const std::vector<NamedText>& models = {}) {
  const std::string loops = "'loops':{'border':{'v':[0,0, 8,0, 8,4, 0,4],'walls':" + kSolid + "}}}";
  return levelFrom(
      "{'light':1,'things':[" + things +
          "],'sectors':{'up':{'floor':{'z':4,'next':'up-low'},'ceiling':{'z':8,'texture':"
          "'#808080'}," +
          loops + ",'low':{'floor':{'texture':'#808080'},'ceiling':{'z':4,'next':'up-low'}," +
          loops + "}}",
      "[]", models);
}

/// An OBJ model: an upright prism over a regular polygon, of 1 m radius and height.
inline std::string gon(int corners) {
  std::string text;
  for (const int height : {0, 1})
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners;
      text += fmt::format("v {:.17g} {} {:.17g}\n", std::cos(angle), height, std::sin(angle));
    }
  for (const int height : {0, 1}) {
    text += "f";
    for (int i = 1; i <= corners; ++i) text += fmt::format(" {}", height * corners + i);
    text += "\n";
  }
  return text;
}

}  // namespace hearth::test
