#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "patch_builder.h"

namespace hearth::doom {

/// A patch in a texture, by its index.
struct Placed {
  int left;
  int top;
  int patch;
};

inline std::string palette() {
  LumpBuilder lump;
  for (int i = 0; i < 256; ++i) lump.bytes({colorOf(i).r, colorOf(i).g, colorOf(i).b});
  return lump.content();
}

inline std::string patchNames(const std::vector<std::string>& names) {
  LumpBuilder lump;
  lump.int32(static_cast<std::int64_t>(names.size()));
  for (const std::string& name : names) lump.name(name);
  return lump.content();
}

/// `countSaid` is how many patches the definition says it has.
inline std::string definition(std::string_view name, int width, int height,
                              const std::vector<Placed>& patches,
                              std::optional<int> countSaid = {}) {
  LumpBuilder bytes;
  bytes.name(name).int32(1).int16(width).int16(height).int32(-1);
  bytes.int16(countSaid.value_or(static_cast<int>(patches.size())));
  for (const Placed& placed : patches)
    bytes.int16(placed.left).int16(placed.top).int16(placed.patch).int16(1).int16(0);
  return bytes.content();
}

inline std::string texturesOf(const std::vector<std::string>& definitions) {
  LumpBuilder lump;
  lump.int32(static_cast<std::int64_t>(definitions.size()));
  std::size_t begin = 4 + 4 * definitions.size();
  for (const std::string& bytes : definitions) {
    lump.int32(static_cast<std::int64_t>(begin));
    begin += bytes.size();
  }
  for (const std::string& bytes : definitions) lump.append(bytes);
  return lump.content();
}

inline std::string flatOf(int color, std::size_t size = 4096) {
  return LumpBuilder().repeat(color, size).content();
}

}  // namespace hearth::doom
