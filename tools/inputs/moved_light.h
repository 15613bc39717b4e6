#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "inputs/inputs.h"
#include "level/mover.h"
#include "load/load.h"
#include "load/source.h"
#include "settings/options.h"

namespace hearth {

/// The shares of a level's movers, by index: those of `--mover`, else of the shot that `--shot`
/// names, else 0.
tl::expected<std::vector<double>, std::string> moverSharesFor(const Level& level,
                                                              const OptionValues& values);
/// The same of a shot of the level, `--mover` apart.
std::vector<double> moverSharesOf(const Level& level, const Shot& shot);

/// The states at rest that the light at these shares is blended from, by `--mover-stages`.
RestStates restStatesFor(std::span<const double> shares, const OptionValues& values);

/// A level with its movers at some shares: the authored one itself, of which there is no second,
/// or another.
class MovedLevel {
 public:
  /// Keeps a reference.
  explicit MovedLevel(const LoadedLevel& authored) : authored_(&authored) {}
  explicit MovedLevel(LoadedLevel&& moved) : moved_(std::move(moved)) {}

  const LoadedLevel& operator*() const { return moved_ ? *moved_ : *authored_; }
  const LoadedLevel* operator->() const { return &**this; }

 private:
  const LoadedLevel* authored_ = nullptr;
  std::optional<LoadedLevel> moved_;
};

/// The level with its movers at these shares, loaded within the limits of the command line;
/// `authored`, which must outlive it, where all are 0.
tl::expected<MovedLevel, std::string> loadedAt(const LoadedLevel& authored,
                                               const LevelSource& source,
                                               std::span<const double> shares,
                                               const OptionValues& values);

/// The light of a level wherever its movers stand. Each state at rest is taken from the cache or
/// baked once, when its light is first asked for.
class MovedLight {
 public:
  /// All of these must outlive it.
  MovedLight(const LoadedLevel& authored, const LevelSource& source, const OptionValues& values)
      : authored_(authored), source_(source), values_(values) {}

  /// Of the level at some shares: exact at rest, else blended.
  tl::expected<BakedLight, std::string> at(const LoadedLevel& shown,
                                           std::span<const double> shares);

 private:
  struct AtRest {
    Geometry geometry;
    BakedLight light;
  };
  tl::expected<const AtRest*, std::string> atRest(const std::vector<double>& shares);

  const LoadedLevel& authored_;
  const LevelSource& source_;
  const OptionValues& values_;
  std::map<std::vector<double>, AtRest> rests_;  ///< by shares
};

}  // namespace hearth
