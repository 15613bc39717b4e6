#pragma once

#include <string>

namespace hearth {

/// The machine that figures were measured on.
struct Machine {
  std::string processor;  ///< its maker's name for it
  int threads;            ///< that it runs at once
  std::string compiler;   ///< of this program
};

Machine thisMachine();

}  // namespace hearth
