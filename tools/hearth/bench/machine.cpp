#include "hearth/bench/machine.h"

#include <fstream>

#include "light/parallel.h"

namespace hearth {

namespace {

/// Linux tells in /proc/cpuinfo.
std::string processorName() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

}  // namespace

Machine thisMachine() { return {processorName(), availableThreads(), "g++ " __VERSION__}; }

}  // namespace hearth
