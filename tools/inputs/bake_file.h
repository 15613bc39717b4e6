#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "inputs/inputs.h"
#include "level/scene.h"
#include "light/bakery.h"
#include "settings/options.h"

/// Saved bakes as files; engine/light/saved_bake.md describes the format.
namespace hearth {

/// A bake as such a file, or as a part of one that has several.
std::string bytesOf(const Scene& scene, const Bake& bake);

/// Writes a file of one bake or of several: first beside `path`, then renamed, so that a failure
/// leaves the old file or none. The error begins with the path.
tl::expected<void, std::string> writeBakes(const std::string& path, std::string_view bytes);

/// The light of the file that `--light-from` names, which must have been baked for the geometry of
/// the level. The error begins with the path and ends with what to do.
tl::expected<BakedLight, std::string> readBake(const Scene& scene, const OptionValues& values);

}  // namespace hearth
