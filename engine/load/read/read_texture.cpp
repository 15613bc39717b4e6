#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "load/json/fields.h"
#include "load/read/read.h"

namespace hearth {

namespace {

/// Metres of one repeat. Smaller or larger ones have texel coordinates beyond 2^63 somewhere in a
/// world of kWorldLimit.
constexpr NumberRange kScale{1e-6, kWorldLimit};
constexpr NumberRange kOffset{-1e12, 1e12};  // texels

bool isInside(double value, NumberRange range) { return value >= range.min && value <= range.max; }

/// "a,b" as two numbers.
std::optional<Vec2> parsePair(std::string_view text) {
  Vec2 pair;
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, pair.x);
  if (first.ec != std::errc() || first.ptr == end || *first.ptr != ',') return std::nullopt;
  const auto second = std::from_chars(first.ptr + 1, end, pair.y);
  if (second.ec != std::errc() || second.ptr != end) return std::nullopt;
  return pair;
}

std::vector<std::string_view> splitAtBlanks(std::string_view text) {
  std::vector<std::string_view> words;
  while (true) {
    const std::size_t start = text.find_first_not_of(' ');
    if (start == std::string_view::npos) return words;
    const std::size_t end = std::min(text.find(' ', start), text.size());
    words.push_back(text.substr(start, end - start));
    text.remove_prefix(end);
  }
}

/// `"name su,sv ou,ov"`, the last two parts optional.
std::optional<TextureDescription> readShortTexture(Report& report, JsonValue value) {
  const std::vector<std::string_view> words = splitAtBlanks(value.text());
  TextureDescription texture;
  const auto readWord = [&](std::size_t word, NumberRange range, Vec2& target) {
    if (words.size() <= word) return true;
    const std::optional<Vec2> pair = parsePair(words[word]);
    target = pair.value_or(target);
    return pair && isInside(pair->x, range) && isInside(pair->y, range);
  };
  if (words.empty() || words.size() > 3 || !readWord(1, kScale, texture.scale) ||
      !readWord(2, kOffset, texture.offset)) {
    report.error(value.place(), fmt::format("\"{}\" is no texture", value.text()),
                 fmt::format("write \"name\", \"name su,sv\" or \"name su,sv ou,ov\" with scales "
                             "from {} to {}; a name with blanks needs the object form",
                             kScale.min, kScale.max));
    return std::nullopt;
  }
  texture.name = {std::string(words[0]), value.place()};
  return texture;
}

void refuseWallKeys(Report& report, const Fields& fields) {
  for (const std::string_view key : {"along", "zref"})
    if (const std::optional<JsonValue> value = fields.find(key))
      report.error(value->place(), fmt::format("\"{}\" on a floor or ceiling", key),
                   "remove it, only walls have it");
}

}  // namespace

std::optional<TextureDescription> readTexture(Report& report, JsonValue value, TextureUse use) {
  if (value.isString()) return readShortTexture(report, value);
  if (!value.isObject()) {
    reportWrongType(report, value, "a texture (a string or an object)");
    return std::nullopt;
  }
  const Fields fields(report, value, kTextureKeys);
  TextureDescription texture;
  bool isGood = fields.read("scale", kScale, texture.scale);
  isGood &= fields.read("offset", kOffset, texture.offset);
  isGood &= fields.read("along", kCoordinate, texture.along);
  isGood &= fields.read("zref", kCoordinate, texture.zRef);
  if (use == TextureUse::OnFlat) refuseWallKeys(report, fields);
  const std::optional<JsonValue> name = fields.require("name", "name an image");
  const auto text = name ? readName(report, *name) : std::nullopt;
  if (!isGood || !text) return std::nullopt;
  texture.name = {*text, name->place()};
  return texture;
}

}  // namespace hearth
