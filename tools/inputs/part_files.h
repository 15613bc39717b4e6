#pragma once

#include <string>
#include <tl/expected.hpp>

#include "light/bake_part.h"
#include "settings/options.h"

/// Parts of bakes as files; engine/light/bake_part.md describes the format.
namespace hearth {

/// The bake of which the command line asks for a part or for all of them. The error names the
/// option to change.
tl::expected<BakeInParts, std::string> bakeInPartsFor(const Scene& scene,
                                                      const OptionValues& values);

enum class PartOutcome {
  Baked,
  WasThere,  ///< whole and right, so nothing was done
};

/// Bakes the part of `--shard` into the file of `-o`: whole or not at all. The error begins with
/// the path.
tl::expected<PartOutcome, std::string> bakePartFile(const BakeInParts& bake, PartNumber number,
                                                    const OptionValues& values);

/// The light of the files of `--join`, in any order. The error begins with the path or, if parts
/// are missing, with their numbers, and ends with what to do.
tl::expected<BakedLight, std::string> joinPartFiles(const BakeInParts& bake,
                                                    const OptionValues& values);

}  // namespace hearth
