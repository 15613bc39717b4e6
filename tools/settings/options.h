#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "image/image.h"
#include "light/bake_part.h"

namespace hearth {

/// Every option of every command. A name means the same wherever it is taken.
enum class Option {
  Output,
  Camera,
  Sector,
  Shot,
  Mover,
  MoverStages,
  MoverStates,
  Size,
  Fov,
  Time,
  Light,
  Channel,
  Quality,
  TextureFilter,
  LightFilter,
  PixelSize,
  LightFrom,
  NoCache,
  Start,
  Scale,
  FrameCap,
  TargetMs,
  Vsync,
  Record,
  Replay,
  Headless,
  Repeats,
  Peers,
  Only,
  Json,
  Surfaces,
  Quiet,
  Golden,
  Update,
  Check,
  Grid,
  Report,
  List,
  Csv,
  Movers,
  Areas,
  Doors,
  Ambient,
  AreaLights,
  LightTable,
  Skill,
  Multiplayer,
  Monsters,
  Iwad,
  TimeBudget,
  Shard,
  Join,
  Texel,
  Samples,
  SoftSamples,
  CutOff,
  GatherError,
  MiddleShadows,
  Bounces,
  Lambert,
  NoLambert,
  Threads,
  MaxFileBytes,
  MaxImagePixels,
  MaxVertices,
  MaxGridCells,
  MaxLights,
  MaxSpriteImages,
  MaxMeshFaces,
};

enum class ValueKind {
  Flag,
  Text,
  EachText,  ///< may be given several times, each with one text
  Texts,     ///< one or more: all that follows, up to the next option
  Choice,
  Number,
  Integer
};

/// One row of the table from which help and manual are printed and input is checked.
struct OptionRow {
  Option id;
  std::string_view name;  ///< as it is typed
  ValueKind kind;
  std::string_view value;  ///< the placeholder of the value in the help; for a choice, all values
  double min;              ///< of numbers, both included
  double max;
  std::string_view standard;  ///< in words: the default; empty without one
  std::string_view help;
};

/// The rows of the table, by Option.
const OptionRow& row(Option option);

/// The text of an option in help and manual: its meaning, range and default.
std::string helpOf(const OptionRow& row);

/// The mistake in a value, if any.
std::optional<std::string> mistakeIn(const OptionRow& row, const std::string& value);

/// The options that were given, their values checked against the table.
class OptionValues {
 public:
  std::string program = "hearth";   ///< as it was called: a word for the shell
  std::string level;                ///< the level file
  std::vector<std::string> levels;  ///< in its place, of a command that takes several

  void set(Option option, std::string value) { values_[option] = {std::move(value)}; }
  void setAll(Option option, std::vector<std::string> values) {
    values_[option] = std::move(values);
  }
  void unset(Option option) { values_.erase(option); }
  bool has(Option option) const { return values_.contains(option); }
  /// The last of several.
  std::optional<std::string> text(Option option) const;
  std::vector<std::string> texts(Option option) const;
  std::optional<double> number(Option option) const;

 private:
  std::map<Option, std::vector<std::string>> values_;  ///< at least one each
};

/// Pixels of a picture's side: 2^14 squared still fits the renderer's ints.
inline constexpr int kMaxPictureSide = 16384;

/// From `WxH`.
std::optional<ImageSize> parseSize(std::string_view text);

/// From `K/N`.
std::optional<PartNumber> parsePartNumber(std::string_view text);

/// The parts of a text between separators; at least one.
std::vector<std::string_view> split(std::string_view text, char separator);

/// Numbers separated by commas, all of them finite.
std::optional<std::vector<double>> parseNumbers(std::string_view text);

// Groups of options that commands share.

/// Options that all commands share: limits of loading.
std::vector<Option> limitOptions();
/// How to bake: what light depends on.
std::vector<Option> settingOptions();
/// How to draw: what pictures may be less accurate in.
std::vector<Option> drawOptions();
/// How to bake, on how many threads, and limits of loading.
std::vector<Option> bakeOptions();
/// Where light is taken from, how to bake, and limits of loading.
std::vector<Option> lightOptions();
std::vector<Option> operator+(std::vector<Option> a, const std::vector<Option>& b);

}  // namespace hearth
