#pragma once

#include <string>
#include <tl/expected.hpp>

#include "inputs/inputs.h"
#include "level/scene.h"
#include "light/bakery.h"
#include "settings/options.h"

/// Saved bakes as files; engine/light/saved_bake.md describes the format.
namespace hearth {

/// Writes the bake of a level to `path`: first beside it, then renamed, so that a failure leaves
/// the old file or none. The error begins with the path.
tl::expected<void, std::string> writeBake(const std::string& path, const Scene& scene,
                                          const Bake& bake);

/// The light of the file that `--light-from` names, which must have been baked for the geometry of
/// the level. The error begins with the path and ends with what to do.
tl::expected<BakedLight, std::string> readBake(const Scene& scene, const OptionValues& values);

}  // namespace hearth
