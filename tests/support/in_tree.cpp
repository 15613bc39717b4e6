#include "support/in_tree.h"

namespace hearth::test {

std::filesystem::path inTree(const std::filesystem::path& file) {
  return std::filesystem::path(HEARTH_SOURCE_DIR) / file;
}

}  // namespace hearth::test
