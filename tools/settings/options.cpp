#include "settings/options.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "level/mover.h"
#include "load/limits.h"
#include "math/check.h"

namespace hearth {

namespace {

constexpr double kMax = 4e9;  // of counts and bytes

constexpr std::array kTable = {
    OptionRow{Option::Output, "-o", ValueKind::Text, "FILE", 0, 0, "",
              "the file to write; of import, the folder"},
    OptionRow{Option::Camera, "--camera", ValueKind::Text, "X,Y,Z,ANGLE[,PITCH]", 0, 0,
              "the player's", "where the eye is (metres) and looks (degrees; pitch -60..60)"},
    OptionRow{Option::Sector, "--sector", ValueKind::Text, "NAME", 0, 0, "found from the position",
              "the sector that the camera is in"},
    OptionRow{
        Option::Shot, "--shot", ValueKind::Text, "NAME", 0, 0, "",
        "the camera and field of view of one of the level's shots; `shot` takes its size, too"},
    OptionRow{Option::Mover, "--mover", ValueKind::EachText, "NAME=SHARE", 0, 1, "as the shot says",
              "where a mover stands: 0 as authored, 1 at its \"to\"; once for each mover"},
    OptionRow{Option::MoverStages, "--mover-stages", ValueKind::Integer, "COUNT", 0,
              kMaxMoverStages, "0",
              "heights of each mover, evenly between its ends, for which light is baked, too"},
    OptionRow{Option::MoverStates, "--mover-states", ValueKind::Integer, "COUNT", 1, 65536, "32",
              "states of the movers whose light is kept, that of the level as authored among them"},
    OptionRow{Option::Size, "--size", ValueKind::Text, "WxH", 1, kMaxPictureSide,
              "320x200; in a window, as large as that", "size of the picture in pixels"},
    OptionRow{Option::Fov, "--fov", ValueKind::Number, "DEGREES", 1, 179, "90",
              "horizontal field of view"},
    OptionRow{Option::Time, "--time", ValueKind::Number, "SECONDS", 0, kMax, "0",
              "how long animations of sprites have run"},
    OptionRow{Option::Light, "--light", ValueKind::Choice, "both|none|only", 0, 0, "both",
              "what the picture shows of texture and light"},
    OptionRow{
        Option::Channel, "--channel", ValueKind::Choice,
        "grid|outlines|holes|vertices|sector|surface|faces|depth|uv|normal|backs|light|overdraw|"
        "wireframe|world|camera|depthspace|screen|spaces",
        0, 0, "", "marks on the lit level, the renderer's own numbers, or a view of the geometry"},
    OptionRow{Option::Quality, "--quality", ValueKind::Choice, "draft|normal|high|reference", 0, 0,
              "normal: as the level says",
              "settings of bake and frames that go together; single ones given beside it count"},
    OptionRow{Option::TextureFilter, "--texture-filter", ValueKind::Choice,
              "nearest|bilinear|mipmapped", 0, 0, "nearest",
              "what a pixel takes of the texels around it, or of those that it covers"},
    OptionRow{Option::LightFilter, "--light-filter", ValueKind::Choice, "nearest|bilinear", 0, 0,
              "bilinear", "what a pixel takes of the lightmap's texels around it"},
    OptionRow{Option::PixelSize, "--pixel-size", ValueKind::Integer, "PIXELS", 1, 64, "1",
              "draw squares of so many pixels a side instead of pixels"},
    OptionRow{Option::LightFrom, "--light-from", ValueKind::Text, "FILE.bake", 0, 0, "baked anew",
              "light that `hearth bake` saved, or another program wrote"},
    OptionRow{Option::NoCache, "--no-cache", ValueKind::Flag, "", 0, 0, "",
              "bake anew, and keep nothing for the next time"},
    OptionRow{Option::Start, "--start", ValueKind::Text, "X,Y,Z,ANGLE", 0, 0, "the player's",
              "where the walk begins: the eye (metres), and where it looks (degrees)"},
    OptionRow{Option::Scale, "--scale", ValueKind::Choice, "smooth|integer", 0, 0, "smooth",
              "how a picture of another size fills the window: all of it, or by whole pixels"},
    OptionRow{Option::FrameCap, "--frame-cap", ValueKind::Number, "FRAMES", 0, 1000, "0: no limit",
              "frames per second at most"},
    OptionRow{Option::TargetMs, "--target-ms", ValueKind::Number, "MS", 0.01, 1000, "",
              "pick the most accurate settings with which a frame takes no longer"},
    OptionRow{Option::Vsync, "--vsync", ValueKind::Choice, "on|off", 0, 0, "on",
              "wait for the display before each frame"},
    OptionRow{Option::Record, "--record", ValueKind::Text, "FILE", 0, 0, "",
              "write down the walk, to be replayed"},
    OptionRow{Option::Replay, "--replay", ValueKind::Text, "FILE", 0, 0, "",
              "walk as recorded, and tell whether that ends at the same place, to the bit"},
    OptionRow{Option::Headless, "--headless", ValueKind::Flag, "", 0, 0, "",
              "with --replay: at once and without a window"},
    OptionRow{Option::Repeats, "--repeats", ValueKind::Integer, "COUNT", 1, 10000,
              "5; of tradeoff 3", "how often each shot is drawn and the light baked"},
    OptionRow{Option::Peers, "--peers", ValueKind::Flag, "", 0, 0, "",
              "without a level: hold Hearth against other programs, limits and its targets"},
    OptionRow{Option::Only, "--only", ValueKind::Text, "NAME", 0, 0, "all",
              "with --peers: the rows whose names begin so"},
    OptionRow{Option::Json, "--json", ValueKind::Flag, "", 0, 0, "", "print JSON"},
    OptionRow{Option::Surfaces, "--surfaces", ValueKind::Flag, "", 0, 0, "",
              "with --json: print the texel grids of all surfaces that light shows on, too"},
    OptionRow{Option::Quiet, "--quiet", ValueKind::Flag, "", 0, 0, "",
              "print neither progress nor figures; only errors and warnings"},
    OptionRow{Option::Golden, "--golden", ValueKind::Text, "DIR", 0, 0, "the level's own",
              "the folder that holds the folders of golden pictures"},
    OptionRow{Option::Update, "--update", ValueKind::Flag, "", 0, 0, "",
              "keep the pictures as they are drawn now"},
    OptionRow{Option::Check, "--check", ValueKind::Flag, "", 0, 0, "",
              "write nothing; status 1 where the file would change"},
    OptionRow{Option::Grid, "--grid", ValueKind::Flag, "", 0, 0, "",
              "a level drawn as rows of cells, each a character"},
    OptionRow{Option::Report, "--report", ValueKind::Text, "OUT.html", 0, 0, "",
              "write a page that shows all of it; of a check, also when all is as kept"},
    OptionRow{Option::List, "--list", ValueKind::Flag, "", 0, 0, "",
              "only print what is approximated, with its setting and the bound on its error"},
    OptionRow{Option::Csv, "--csv", ValueKind::Flag, "", 0, 0, "", "print CSV"},
    OptionRow{Option::Movers, "--movers", ValueKind::Flag, "", 0, 0, "",
              "measure what stages of movers cost, and nothing else"},
    OptionRow{Option::Areas, "--areas", ValueKind::Flag, "", 0, 0, "",
              "measure what gather errors and bounces cost, and nothing else"},
    OptionRow{Option::Doors, "--doors", ValueKind::Choice, "moving|open|closed", 0, 0, "moving",
              "doors, lifts and floors move; or nothing does, and doors stand so, with lifts down "
              "where they are open"},
    OptionRow{Option::Ambient, "--ambient", ValueKind::Number, "FRACTION", 0, 1, "0.75",
              "the part of the light of a map's sectors that is everywhere in them"},
    OptionRow{Option::AreaLights, "--area-lights", ValueKind::Flag, "", 0, 0, "",
              "the textures and flats that shine do so all over, and so do the sky and a sun"},
    OptionRow{Option::LightTable, "--light-table", ValueKind::Text, "FILE", 0, 0, "its own",
              "JSON that says which things, textures and flats of a map shine, and how"},
    OptionRow{
        Option::Skill, "--skill", ValueKind::Integer, "LEVEL", 1, 5, "3",
        "how hard the game is, from 1 to 5: some things of a map are there in some games only"},
    OptionRow{Option::Multiplayer, "--multiplayer", ValueKind::Flag, "", 0, 0, "",
              "import things of multiplayer games, too"},
    OptionRow{Option::Monsters, "--monsters", ValueKind::Flag, "", 0, 0, "",
              "import monsters, too; they stand and do nothing"},
    OptionRow{Option::Iwad, "--iwad", ValueKind::Text, "FILE.wad", 0, 0, "",
              "the WAD of the game, for what a WAD of maps alone does not have"},
    OptionRow{Option::TimeBudget, "--time-budget", ValueKind::Number, "SECONDS", 0.01, 1e6, "",
              "pick the most accurate settings with which the bake takes no longer"},
    OptionRow{
        Option::Shard, "--shard", ValueKind::Text, "K/N", 1, kMaxParts, "",
        "bake only the K-th of N parts, and write it as X.part; a finished one is left as it is"},
    OptionRow{Option::Join, "--join", ValueKind::Texts, "FILE.part", 0, 0, "",
              "put parts together that were baked with --shard, instead of baking"},
    OptionRow{Option::Texel, "--texel", ValueKind::Number, "METRES", 1e-6, 1e6, "0.125",
              "size of a lightmap's texels"},
    OptionRow{Option::Samples, "--samples", ValueKind::Integer, "COUNT|auto", 1, 4096, "1",
              "samples per texel, a square number; auto: as many as shadows' edges need"},
    OptionRow{Option::SoftSamples, "--soft-samples", ValueKind::Integer, "COUNT", 0, 4096, "36",
              "directions in which a sample looks at a light with a radius, a square number; 0: it "
              "is a point"},
    OptionRow{Option::CutOff, "--cut-off", ValueKind::Number, "LEVELS", 0, 255, "0: nothing",
              "leave a light out from where on it has no more than so many levels"},
    OptionRow{Option::GatherError, "--gather-error", ValueKind::Number, "LEVELS", 0.0625, 64, "1",
              "how far off interpolated light of the sky and of surfaces that shine may be; light "
              "that bounces may be three times as far off"},
    OptionRow{Option::MiddleShadows, "--middle-shadows", ValueKind::Choice, "holes|solid", 0, 0,
              "holes", "of what hangs in openings: with its holes, or as if it had none"},
    OptionRow{Option::Bounces, "--bounces", ValueKind::Integer, "COUNT", 0, 16, "0",
              "reflections of light that are followed"},
    OptionRow{Option::Lambert, "--lambert", ValueKind::Flag, "", 0, 0, "",
              "multiply light by the cosine at the surface"},
    OptionRow{Option::NoLambert, "--no-lambert", ValueKind::Flag, "", 0, 0, "",
              "take light alike at any angle; the default"},
    OptionRow{Option::Threads, "--threads", ValueKind::Integer, "COUNT", 1, 1024, "all cores",
              "threads that bake and draw; neither light nor pictures depend on them"},
    OptionRow{Option::MaxFileBytes, "--max-file-bytes", ValueKind::Integer, "BYTES", 1,
              4294967294.0, "67108864",
              "refuse longer JSON files, and saved bakes that are longer or hold more light"},
    OptionRow{Option::MaxImagePixels, "--max-image-pixels", ValueKind::Integer, "PIXELS", 1, kMax,
              "67108864", "refuse larger images"},
    OptionRow{Option::MaxVertices, "--max-vertices", ValueKind::Integer, "COUNT", 1, kMax,
              "1000000", "refuse levels of more vertices"},
    OptionRow{Option::MaxGridCells, "--max-grid-cells", ValueKind::Integer, "COUNT", 1, kMax,
              "4000000", "refuse grids of more cells"},
    OptionRow{Option::MaxLights, "--max-lights", ValueKind::Integer, "COUNT", 1, kMax, "100000",
              "refuse more lights"},
    OptionRow{Option::MaxSpriteImages, "--max-sprite-images", ValueKind::Integer, "COUNT", 1, kMax,
              "250000", "refuse things of more images"},
    OptionRow{Option::MaxMeshFaces, "--max-mesh-faces", ValueKind::Integer, "COUNT", 1, kMax,
              "4000000", "refuse meshes of more triangles"},
};

static_assert(LoadLimits{}.fileBytes == 67108864 && LoadLimits{}.imagePixels == 67108864 &&
                  LoadLimits{}.vertices == 1000000 && LoadLimits{}.gridCells == 4000000 &&
                  LoadLimits{}.lights == 100000 && LoadLimits{}.spriteImages == 250000 &&
                  LoadLimits{}.meshFaces == 4000000,
              "the table's defaults are those of the loader");

std::optional<double> parseNumber(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

/// A whole number in digits.
std::optional<int> parseCount(std::string_view digits) {
  int value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
  return value;
}

std::optional<std::string> mistakeInChoice(const OptionRow& row, const std::string& value) {
  for (const std::string_view choice : split(row.value, '|'))
    if (choice == value) return std::nullopt;
  return fmt::format("\"{}\" is none of {}", value, row.value);
}

std::optional<std::string> mistakeInNumber(const OptionRow& row, const std::string& value) {
  const std::optional<double> number = parseNumber(value);
  if (!number) return fmt::format("\"{}\" is no number", value);
  if (row.kind == ValueKind::Integer && *number != std::floor(*number))
    return fmt::format("{} is no whole number", value);
  if (*number < row.min || *number > row.max)
    return fmt::format("{} is outside {}..{}", value, row.min, row.max);
  return std::nullopt;
}

std::optional<std::string> mistakeInSize(const OptionRow& row, const std::string& value) {
  if (parseSize(value)) return std::nullopt;
  return fmt::format("\"{}\" is no WIDTHxHEIGHT with both in {}..{}", value, row.min, row.max);
}

std::optional<std::string> mistakeInPartNumber(const OptionRow& row, const std::string& value) {
  if (parsePartNumber(value)) return std::nullopt;
  return fmt::format("\"{}\" is no K/N of whole numbers with {} <= K <= N <= {}", value, row.min,
                     row.max);
}

}  // namespace

const OptionRow& row(Option option) {
  const OptionRow& found = kTable[static_cast<std::size_t>(option)];
  CHECK(found.id == option, found.name);
  return found;
}

std::string helpOf(const OptionRow& row) {
  const bool isNumber = row.kind == ValueKind::Number || row.kind == ValueKind::Integer;
  std::string help(row.help);
  if (isNumber) help += fmt::format(", {}..{}", row.min, row.max);
  if (!row.standard.empty()) help += fmt::format(" (default: {})", row.standard);
  return help;
}

std::optional<std::string> mistakeIn(const OptionRow& row, const std::string& value) {
  if (row.id == Option::Size) return mistakeInSize(row, value);
  if (row.id == Option::Shard) return mistakeInPartNumber(row, value);
  if (row.id == Option::Samples && value == "auto") return std::nullopt;
  switch (row.kind) {
    case ValueKind::Flag:
    case ValueKind::Text:
    case ValueKind::EachText:
    case ValueKind::Texts:
      return std::nullopt;
    case ValueKind::Choice:
      return mistakeInChoice(row, value);
    case ValueKind::Number:
    case ValueKind::Integer:
      return mistakeInNumber(row, value);
  }
  return std::nullopt;
}

std::optional<std::string> OptionValues::text(Option option) const {
  const auto found = values_.find(option);
  return found == values_.end() ? std::nullopt : std::optional(found->second.back());
}

std::vector<std::string> OptionValues::texts(Option option) const {
  const auto found = values_.find(option);
  return found == values_.end() ? std::vector<std::string>{} : found->second;
}

std::optional<double> OptionValues::number(Option option) const {
  const auto found = values_.find(option);
  return found == values_.end() ? std::nullopt : parseNumber(found->second.back());
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0;;) {
    const std::size_t end = text.find(separator, begin);
    parts.push_back(text.substr(begin, end - begin));
    if (end == std::string_view::npos) return parts;
    begin = end + 1;
  }
}

std::optional<ImageSize> parseSize(std::string_view text) {
  const std::vector<std::string_view> parts = split(text, 'x');
  if (parts.size() != 2) return std::nullopt;
  const std::optional<int> width = parseCount(parts[0]);
  const std::optional<int> height = parseCount(parts[1]);
  const auto isSide = [](std::optional<int> side) {
    return side && *side >= 1 && *side <= kMaxPictureSide;
  };
  if (!isSide(width) || !isSide(height)) return std::nullopt;
  return ImageSize{*width, *height};
}

std::optional<PartNumber> parsePartNumber(std::string_view text) {
  const std::vector<std::string_view> parts = split(text, '/');
  if (parts.size() != 2) return std::nullopt;
  const std::optional<int> part = parseCount(parts[0]);
  const std::optional<int> all = parseCount(parts[1]);
  if (!part || !all || *part < 1 || *part > *all || *all > static_cast<int>(kMaxParts))
    return std::nullopt;
  return PartNumber{static_cast<std::uint32_t>(*part), static_cast<std::uint32_t>(*all)};
}

std::optional<std::vector<double>> parseNumbers(std::string_view text) {
  std::vector<double> numbers;
  for (const std::string_view part : split(text, ',')) {
    const std::optional<double> number = parseNumber(part);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

std::vector<Option> limitOptions() {
  return {Option::MaxFileBytes, Option::MaxImagePixels,  Option::MaxVertices, Option::MaxGridCells,
          Option::MaxLights,    Option::MaxSpriteImages, Option::MaxMeshFaces};
}

std::vector<Option> settingOptions() {
  return {Option::Texel,   Option::Samples,     Option::SoftSamples,
          Option::CutOff,  Option::GatherError, Option::MiddleShadows,
          Option::Bounces, Option::Lambert,     Option::NoLambert};
}

std::vector<Option> drawOptions() {
  return {Option::TextureFilter, Option::LightFilter, Option::PixelSize};
}

std::vector<Option> bakeOptions() {
  return std::vector<Option>{Option::Quality} + settingOptions() +
         std::vector<Option>{Option::Threads} + limitOptions();
}

std::vector<Option> lightOptions() {
  return std::vector<Option>{Option::LightFrom, Option::NoCache} + bakeOptions();
}

std::vector<Option> operator+(std::vector<Option> a, const std::vector<Option>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

}  // namespace hearth
