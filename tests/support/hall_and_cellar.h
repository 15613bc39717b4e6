#pragma once

#include <string>

#include "support/level_text.h"

namespace hearth::test {

/// The text of a level: a lit hall, a cellar without a lamp and a door between them, which opens by
/// the use key and stays open; and in the hall a lift that the player starts by stepping on it. The
/// player stands in the hall and looks at the door. `things` is a list of them.
inline std::string hallAndCellarText(const std::string& things = "[]") {
  const std::string solid = "{'texture':'#808080'}";
  const std::string toDoor = "{'next':'door','texture':'#604020'}";
  const std::string toHall = "{'next':'hall','texture':'#604020'}";
  const std::string toLift = "{'next':'lift','texture':'#604020'}";
  return "{'player': {'x':3,'y':2,'z':1.6,'angle':0}, 'things': " + things +
         ","
         " 'movers': {'gate': {'sectors':'door','part':'ceiling','to':2,'trigger':'use'},"
         "            'lift': {'sectors':'lift','part':'floor','to':1,'trigger':'enter',"
         "                     'zones':'lift'}},"
         " 'sectors': {" +
         sectorText("hall", "0,0, 4,0, 4,4, 0,4", 0, 3,
                    "[" + solid + "," + toDoor + "," + solid + "," + toLift + "]") +
         "," +
         sectorText(
             "door", "4,0, 4.5,0, 4.5,4, 4,4", 0, 0,
             "[" + solid + ",{'next':'cellar','texture':'#604020'}," + solid + "," + toHall + "]") +
         "," +
         sectorText("cellar", "4.5,0, 9,0, 9,4, 4.5,4", 0, 3,
                    "[" + solid + "," + solid + "," + solid + "," + toDoor + "]") +
         "," +
         sectorText("lift", "-2,0, 0,0, 0,4, -2,4", 0, 3,
                    "[" + solid + "," + toHall + "," + solid + "," + solid + "]") +
         "}}";
}

inline constexpr std::string_view kHallLights =
    "[{'x':2,'y':2,'z':1.5,'intensity':200,'falloff':0.25}]";

inline SourcedResult hallAndCellar(const std::string& things = "[]") {
  return levelWithSourceFrom(hallAndCellarText(things), kHallLights);
}

}  // namespace hearth::test
