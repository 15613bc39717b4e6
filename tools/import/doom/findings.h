#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace hearth::doom {

/// What an import did with a part that has no equivalent in a Hearth level.
enum class Outcome : std::uint8_t { Repaired, Dropped };

/// The kind of part of a map that a finding is about; parts are numbered within their kind.
enum class Part : std::uint8_t { Line, Sector, Thing, Texture };

struct Finding {
  Outcome outcome;
  Part part;
  std::size_t number;  ///< of no meaning for textures
  std::string what;    ///< what was found, and what was done
};

using Findings = std::vector<Finding>;

}  // namespace hearth::doom
