#include "measure/machine.h"

#include <fstream>
#include <string_view>

#include "math/parallel.h"

namespace hearth {

namespace {

/// Linux names the processor in /proc/cpuinfo.
std::string processorName() {
  constexpr std::string_view kKey = "model name\t: ";
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with(kKey)) return line.substr(kKey.size());
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
