#pragma once

#include <string>

namespace hearth {

/// What figures were taken on.
struct Machine {
  std::string processor;  ///< its maker's name for it
  int threads;            ///< that it runs at once
  std::string compiler;   ///< of this program
};

Machine thisMachine();

}  // namespace hearth
