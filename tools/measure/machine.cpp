#include "measure/machine.h"

#include <fstream>

#include "math/parallel.h"

namespace hearth {

namespace {

/// Linux names the processor in /proc/cpuinfo.
std::string processorName() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

#ifdef __clang__
constexpr const char* kCompiler = __VERSION__;  // begins with its name
#else
constexpr const char* kCompiler = "g++ " __VERSION__;
#endif

}  // namespace

Machine thisMachine() { return {processorName(), availableThreads(), kCompiler}; }

}  // namespace hearth
