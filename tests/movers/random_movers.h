#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "load/source.h"

/// Random levels in which something moves.
namespace hearth::movers {

/// The random level of a seed with one to four movers, and the text of the same level authored with
/// its movers at any of their ends.
class RandomMovers {
 public:
  /// `folder` holds the textures of random levels. The level is written there, under a name of its
  /// own.
  RandomMovers(std::uint64_t seed, std::filesystem::path folder);
  ~RandomMovers();
  RandomMovers(const RandomMovers&) = delete;
  RandomMovers& operator=(const RandomMovers&) = delete;

  /// No level where no mover was found that suits it.
  const SourcedResult& loaded() const { return loaded_; }
  /// Loads the level whose flats are authored at these ends, and which has no movers.
  LoadResult loadAuthoredAt(std::span<const double> ends) const;

 private:
  std::filesystem::path fileOf(const std::string& variant) const;
  SourcedResult load(const std::string& level) const;

  std::filesystem::path folder_;
  std::string name_;
  std::string level_;  ///< its text
  std::string lights_;
  SourcedResult loaded_;
};

}  // namespace hearth::movers
