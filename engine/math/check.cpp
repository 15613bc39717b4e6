#include "math/check.h"

#include <cstdio>
#include <cstdlib>

namespace hearth {

void checkFailed(const char* file, int line, const char* expression, const std::string& values) {
  std::fprintf(stderr, "%s:%d: broken invariant: %s%s%s\n", file, line, expression,
               values.empty() ? "" : " with", values.c_str());
  std::abort();
}

}  // namespace hearth
