#include "import/doom/light_table.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

namespace hearth::doom {

namespace {

using Json = nlohmann::ordered_json;

template <typename Shining>
struct NumberKey {
  std::string_view key;
  double Shining::*member;
  double least;
  double most;
};

constexpr double kMax = 1e6;

constexpr std::array kGlowNumbers{NumberKey<Glow>{"intensity", &Glow::intensity, 0, kMax},
                                  NumberKey<Glow>{"falloff", &Glow::falloff, 0, kMax},
                                  NumberKey<Glow>{"reach", &Glow::reach, 0.1, kMax},
                                  NumberKey<Glow>{"height", &Glow::height, 0, kMax},
                                  NumberKey<Glow>{"every", &Glow::every, 0.25, kMax},
                                  NumberKey<Glow>{"emit", &Glow::emit, 0, kMax}};
constexpr std::array kSkyNumbers{NumberKey<SkyGlow>{"intensity", &SkyGlow::intensity, 0, kMax}};
constexpr std::array kSunNumbers{NumberKey<SunGlow>{"angle", &SunGlow::angle, -kMax, kMax},
                                 NumberKey<SunGlow>{"pitch", &SunGlow::pitch, 1, 90},
                                 NumberKey<SunGlow>{"intensity", &SunGlow::intensity, 0, kMax},
                                 NumberKey<SunGlow>{"size", &SunGlow::size, 0, 20}};

bool isComment(const std::string& key) { return key.starts_with("//") || key.starts_with("$"); }

bool isColor(const Json& value) {
  if (!value.is_string()) return false;
  const std::string text = value.get<std::string>();
  return text.size() == 7 && text[0] == '#' &&
         text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
}

/// What is wrong with one key, or nothing. `numbers` are all keys besides the colour.
template <typename Numbers, typename Shining>
std::optional<std::string> take(const Numbers& numbers, const std::string& key, const Json& value,
                                Shining& shining) {
  if (key == "color") {
    if (!isColor(value)) return "write it as \"#rrggbb\"";
    shining.color = value.get<std::string>();
    return std::nullopt;
  }
  std::string known = "color";
  for (const auto& number : numbers) {
    known += fmt::format(", {}", number.key);
    if (key != number.key) continue;
    const double n = value.is_number() ? value.get<double>() : std::nan("");
    if (!(n >= number.least && n <= number.most))
      return fmt::format("write a number of {:g} to {:g}", number.least, number.most);
    shining.*number.member = n;
    return std::nullopt;
  }
  return fmt::format("there is no such key; these are known: {}", known);
}

class TableReader {
 public:
  tl::expected<LightTable, std::string> read(const Json& json) {
    if (!json.is_object()) return tl::unexpected(std::string("/: it is no JSON object"));
    for (const auto& [group, glows] : json.items()) {
      if (isComment(group)) continue;
      if (group == "sky")
        read(kSkyNumbers, "/sky", glows, table_.sky);
      else if (group == "sun")
        read(kSunNumbers, "/sun", glows, table_.sun.emplace());
      else if (!glows.is_object() || (group != "things" && group != "walls" && group != "flats"))
        return tl::unexpected(fmt::format(
            "/{}: write objects \"things\", \"walls\", \"flats\", \"sky\" and \"sun\"", group));
      else
        for (const auto& [name, glow] : glows.items())
          if (!isComment(name)) readGlow(group, name, glow);
    }
    if (mistake_) return tl::unexpected(*mistake_);
    return std::move(table_);
  }

 private:
  void readGlow(const std::string& group, const std::string& name, const Json& json) {
    const std::string place = fmt::format("/{}/{}", group, name);
    Glow glow;
    read(kGlowNumbers, place, json, glow);
    if (group == "walls")
      table_.walls[name] = glow;
    else if (group == "flats")
      table_.flats[name] = glow;
    else if (const auto type = typeOf(name))
      table_.things[*type] = glow;
    else
      refuse(place + ": things have numbers of 1 to 65535");
  }

  template <typename Numbers, typename Shining>
  void read(const Numbers& numbers, const std::string& place, const Json& json, Shining& shining) {
    if (!json.is_object()) return refuse(place + ": it is no JSON object");
    for (const auto& [key, value] : json.items()) {
      if (isComment(key)) continue;
      if (const auto mistake = take(numbers, key, value, shining))
        return refuse(fmt::format("{}/{}: {}", place, key, *mistake));
    }
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
