#include "import/doom/light_table.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>

namespace hearth::doom {

namespace {

using Json = nlohmann::ordered_json;

struct NumberKey {
  std::string_view key;
  double Glow::*member;
  double least;
};
constexpr std::array kNumbers{
    NumberKey{"intensity", &Glow::intensity, 0}, NumberKey{"falloff", &Glow::falloff, 0},
    NumberKey{"reach", &Glow::reach, 0.1}, NumberKey{"height", &Glow::height, 0},
    NumberKey{"every", &Glow::every, 0.25}};

constexpr double kMax = 1e6;

bool isComment(const std::string& key) { return key.starts_with("//") || key.starts_with("$"); }

bool isColor(const Json& value) {
  if (!value.is_string()) return false;
  const std::string text = value.get<std::string>();
  return text.size() == 7 && text[0] == '#' &&
         text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
}

/// What is wrong with one key of a glow, or nothing.
std::optional<std::string> take(const std::string& key, const Json& value, Glow& glow) {
  if (key == "color") {
    if (!isColor(value)) return "write it as \"#rrggbb\"";
    glow.color = value.get<std::string>();
    return std::nullopt;
  }
  for (const NumberKey& number : kNumbers) {
    if (key != number.key) continue;
    const double n = value.is_number() ? value.get<double>() : -1;
    if (!(n >= number.least && n <= kMax))
      return fmt::format("write a number of {:g} to {:g}", number.least, kMax);
    glow.*number.member = n;
    return std::nullopt;
  }
  return "there is no such key: color, intensity, falloff, reach, height and every are known";
}

class TableReader {
 public:
  tl::expected<LightTable, std::string> read(const Json& json) {
    if (!json.is_object()) return tl::unexpected(std::string("/: it is no JSON object"));
    for (const auto& [group, glows] : json.items()) {
      if (isComment(group)) continue;
      if (!glows.is_object() || (group != "things" && group != "walls" && group != "flats"))
        return tl::unexpected(
            fmt::format("/{}: write objects \"things\", \"walls\" and \"flats\"", group));
      for (const auto& [name, glow] : glows.items())
        if (!isComment(name)) readGlow(group, name, glow);
    }
    if (mistake_) return tl::unexpected(*mistake_);
    return std::move(table_);
  }

 private:
  void readGlow(const std::string& group, const std::string& name, const Json& json) {
    const std::string place = fmt::format("/{}/{}", group, name);
    if (!json.is_object()) return refuse(place + ": it is no JSON object");
    Glow glow;
    for (const auto& [key, value] : json.items()) {
      if (isComment(key)) continue;
      if (const auto mistake = take(key, value, glow))
        return refuse(fmt::format("{}/{}: {}", place, key, *mistake));
    }
    if (group == "walls")
      table_.walls[name] = glow;
    else if (group == "flats")
      table_.flats[name] = glow;
    else if (const auto type = typeOf(name))
      table_.things[*type] = glow;
    else
      refuse(place + ": things have numbers of 1 to 65535");
  }

  static std::optional<std::uint16_t> typeOf(const std::string& name) {
    std::uint16_t type = 0;
    const char* end = name.data() + name.size();
    const auto [at, error] = std::from_chars(name.data(), end, type);
    if (error != std::errc() || at != end || type == 0) return std::nullopt;
    return type;
  }

  void refuse(std::string mistake) {
    if (!mistake_) mistake_ = std::move(mistake);
  }

  LightTable table_;
  std::optional<std::string> mistake_;
};

}  // namespace

tl::expected<LightTable, std::string> parseLightTable(std::string_view json) {
  try {
    return TableReader().read(Json::parse(json));
  } catch (const Json::parse_error& error) {
    return tl::unexpected(fmt::format("/: it is no JSON: {}", error.what()));
  }
}

}  // namespace hearth::doom
