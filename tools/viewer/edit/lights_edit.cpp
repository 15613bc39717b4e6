#include "viewer/edit/lights_edit.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "load/json/read_document.h"
#include "load/read/read.h"
#include "text/json_text.h"

namespace hearth {

namespace {

/// In the order in which a light, or a sun, has them.
constexpr std::array<std::string_view, 13> kLightKeys{
    "angle",     "pitch",   "x",     "y",     "z",    "sector", "radius",
    "intensity", "falloff", "curve", "color", "spot", "size"};
constexpr std::array<std::string_view, 4> kSpotKeys{"angle", "pitch", "inner", "outer"};

/// The shortest that reads as the same number.
std::string spelled(double number) { return fmt::format("{}", number + 0.0); }  // not -0

std::string spelled(const std::uint8_t (&color)[3]) {
  return fmt::format("\"#{:02x}{:02x}{:02x}\"", color[0], color[1], color[2]);
}

std::string spelled(const std::vector<CurvePoint>& curve) {
  std::string text;
  for (const CurvePoint& point : curve)
    text += fmt::format("{}[{}, {}]", text.empty() ? "" : ", ", spelled(point.distance),
                        spelled(point.level));
  return fmt::format("[{}]", text);
}

std::array<double, kSpotKeys.size()> numbersOf(const Spot& spot) {
  return {spot.angle(), spot.pitch(), spot.inner(), spot.outer()};
}

std::string spelled(const Spot& spot) {
  std::string text;
  const auto numbers = numbersOf(spot);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    text +=
        fmt::format("{}\"{}\": {}", i == 0 ? "" : ", ", kSpotKeys.at(i), spelled(numbers.at(i)));
  return fmt::format("{{{}}}", text);
}

/// Bytes that are no UTF-8 are not kept.
std::string spelled(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

struct Member {
  std::string_view key;
  std::optional<std::string> value;  ///< spelled; none: the light has no such key
};

/// What differs of two areas, key by key.
std::vector<Member> changesOfArea(const LightSource& from, const LightSource& to) {
  std::vector<Member> members;
  if (from.intensity != to.intensity) members.push_back({"intensity", spelled(to.intensity)});
  if (!std::ranges::equal(from.color, to.color)) members.push_back({"color", spelled(to.color)});
  return members;
}

/// What differs of two suns, key by key.
std::vector<Member> changesOfSun(const LightSource& from, const LightSource& to) {
  std::vector<Member> members;
  const auto add = [&members](std::string_view key, double before, double after) {
    if (before != after) members.push_back({key, spelled(after)});
  };
  add("angle", from.sun->angle(), to.sun->angle());
  add("pitch", from.sun->pitch(), to.sun->pitch());
  add("intensity", from.intensity, to.intensity);
  if (!std::ranges::equal(from.color, to.color)) members.push_back({"color", spelled(to.color)});
  add("size", from.sun->size(), to.sun->size());
  return members;
}

/// What differs, key by key.
std::vector<Member> changes(const LightDescription& from, const LightDescription& to) {
  if (from.source.isArea()) return changesOfArea(from.source, to.source);
  if (from.source.sun) return changesOfSun(from.source, to.source);
  std::vector<Member> members;
  const auto add = [&members](std::string_view key, const auto& before, const auto& after) {
    if (before != after) members.push_back({key, spelled(after)});
  };
  add("x", from.source.position.x, to.source.position.x);
  add("y", from.source.position.y, to.source.position.y);
  add("z", from.source.position.z, to.source.position.z);
  const auto nameOf = [](const LightDescription& light) {
    return light.sector ? std::optional(light.sector->name) : std::nullopt;
  };
  if (nameOf(from) != nameOf(to))
    members.push_back(
        {"sector", to.sector ? std::optional(spelled(to.sector->name)) : std::nullopt});
  add("radius", from.source.radius, to.source.radius);
  if (to.source.curve.empty()) {
    if (!from.source.curve.empty()) members.push_back({"curve", std::nullopt});
    add("intensity", from.source.intensity, to.source.intensity);
    add("falloff", from.source.falloff, to.source.falloff);
  } else {  // beside which there are neither
    if (from.source.curve.empty())
      for (const std::string_view key : {"intensity", "falloff"})
        members.push_back({key, std::nullopt});
    add("curve", from.source.curve, to.source.curve);
  }
  if (!std::ranges::equal(from.source.color, to.source.color))
    members.push_back({"color", spelled(to.source.color)});
  if (from.source.spot && !to.source.spot) members.push_back({"spot", std::nullopt});
  if (!from.source.spot && to.source.spot) members.push_back({"spot", spelled(*to.source.spot)});
  return members;
}

std::vector<std::string_view> keysBefore(std::string_view key) {
  return {kLightKeys.begin(), std::ranges::find(kLightKeys, key)};
}

bool hasMember(std::string_view json, std::size_t light, std::string_view key) {
  const std::vector<MemberRange> members = membersAt(json, light);
  return std::ranges::find(members, key, &MemberRange::name) != members.end();
}

/// Of what has no such member it takes nothing out.
Replacement with(std::string_view json, std::size_t light, const Member& member) {
  if (!member.value)
    return hasMember(json, light, member.key) ? withoutMember(json, light, member.key)
                                              : Replacement{light, "", ""};
  return withMember(json, light, {std::string(member.key), *member.value}, keysBefore(member.key));
}

/// One number of the light's spot.
Replacement withSpotNumber(std::string_view json, std::size_t light, std::string_view key,
                           double number) {
  const std::vector<MemberRange> ofLight = membersAt(json, light);
  const std::size_t spot = std::ranges::find(ofLight, "spot", &MemberRange::name)->value.begin;
  const std::vector<MemberRange> members = membersAt(json, spot);
  if (members.size() == 1 && members[0].name != key)
    return {members[0].value.end, "", fmt::format(R"(, "{}": {})", key, spelled(number))};
  return withMember(json, spot, {std::string(key), spelled(number)},
                    {kSpotKeys.begin(), kSpotKeys.end()});
}

/// Where the value under a key begins, if there is one.
std::optional<std::size_t> valueIn(const Document& document, std::string_view key) {
  const JsonValue root(document, 0, 0);
  if (root.isArray()) return key == "lights" ? std::optional(root.place().offset) : std::nullopt;
  const std::vector<JsonValue::Member> members = root.members();
  const auto found = std::ranges::find_if(
      members, [&](const JsonValue::Member& member) { return member.key.text() == key; });
  if (found == members.end()) return std::nullopt;
  return found->value.place().offset;
}

/// What is written of an added light in any case.
std::vector<SpelledMember> placeOf(const LightSource& light) {
  if (light.isArea()) return {};
  if (light.sun)
    return {{"angle", spelled(light.sun->angle())}, {"pitch", spelled(light.sun->pitch())}};
  return {{"x", spelled(light.position.x)},
          {"y", spelled(light.position.y)},
          {"z", spelled(light.position.z)}};
}

std::string_view kindWords(const LightSource& light) {
  if (light.isEmitter()) return "emitters";
  return light.isSky ? "a sky" : "suns";
}

std::string objectOf(const std::vector<SpelledMember>& members) {
  std::string text;
  for (const SpelledMember& member : members)
    text += fmt::format("{}\"{}\": {}", text.empty() ? " " : ", ", member.key, member.value);
  return fmt::format("{{{} }}", text);
}

/// A light of which that is all.
LightDescription plainAt(const LightSource& light) {
  LightDescription plain;
  plain.source.position = light.position;
  if (light.sun) plain.source.sun.emplace(light.sun->angle(), light.sun->pitch(), 0);
  plain.source.isSky = light.isSky;
  plain.source.texture = light.texture;
  if (light.isSky) plain.source.intensity = 0;
  return plain;
}

}  // namespace

tl::expected<LightsEdit, std::string> LightsEdit::open(std::string_view bytes, std::string file,
                                                       const LoadLimits& limits) {
  const bool hasMark = bytes.starts_with(kByteOrderMark);
  if (hasMark) bytes.remove_prefix(kByteOrderMark.size());
  LightsEdit edit(std::string(bytes), std::move(file), limits, hasMark);
  if (auto mistake = edit.read()) return tl::unexpected(*std::move(mistake));
  return edit;
}

std::string LightsEdit::bytes() const {
  return std::string(hasByteOrderMark_ ? kByteOrderMark : "") + history_.text();
}

std::string LightsEdit::commentOf(std::size_t light) const {
  return commentAt(history_.text(), offsetOf(light));
}

/// Reads the text; what is wrong with it, if anything.
std::optional<std::string> LightsEdit::read() {
  Report report;
  std::array<Document, 1> documents;
  documents[0].file = file_;
  LightsDescription lights;
  if (readText(history_.text(), documents[0], 0, report))
    lights = readLights(report, JsonValue(documents[0], 0, 0), limits_);
  if (report.hasErrors()) return format(report.resolve(documents).front());
  lights_ = std::move(lights);
  list_ = *valueIn(documents[0], "lights");
  suns_ = valueIn(documents[0], "suns");
  emit_ = valueIn(documents[0], "emit");
  return std::nullopt;
}

/// `change` replaces in the text; in a drag from what it was before.
template <typename Change>
std::optional<std::string> LightsEdit::edit(Change&& change) {
  const bool isInDrag = isDragging();
  if (isInDrag) {
    history_.takeBackStep();
    read();
  } else {
    history_.beginStep();
  }
  change();
  std::optional<std::string> mistake = read();
  if (mistake) {
    history_.takeBackStep();
    read();
  }
  if (!isInDrag) history_.endStep();
  return mistake;
}

std::optional<std::string> LightsEdit::set(std::size_t light, const LightDescription& to) {
  return edit([&] {
    const std::optional<Spot>& spot = lights_.at(light).source.spot;
    for (const Member& member : changes(lights_.at(light), to))
      history_.replace(with(history_.text(), offsetOf(light), member));
    if (spot && to.source.spot) changeSpot(light, *spot, *to.source.spot);
  });
}

void LightsEdit::changeSpot(std::size_t light, const Spot& from, const Spot& to) {
  const auto before = numbersOf(from);
  const auto after = numbersOf(to);
  for (std::size_t i = 0; i < after.size(); ++i)
    if (before.at(i) != after.at(i))
      history_.replace(
          withSpotNumber(history_.text(), offsetOf(light), kSpotKeys.at(i), after.at(i)));
}

std::optional<std::string> LightsEdit::setComment(std::size_t light, const std::string& comment) {
  return edit([&] {
    if (commentOf(light) == comment) return;
    history_.replace(comment.empty()
                         ? withoutComment(history_.text(), offsetOf(light))
                         : withComment(history_.text(), offsetOf(light), spelled(comment)));
  });
}

std::optional<std::string> LightsEdit::add(const LightDescription& light,
                                           const std::string& comment) {
  const bool isSun = light.source.sun.has_value();
  if (!light.source.hasPlace() && history_.text()[rootOf(history_.text())] == '[')
    return fmt::format(
        "the file is an array of lights: write {{ \"lights\": [...] }} to give it {}",
        kindWords(light.source));
  const std::string& texture = light.source.texture;
  if (std::ranges::any_of(lights_.emitters, [&](const LightDescription& emitter) {
        return light.source.isEmitter() && emitter.source.texture == texture;
      }))
    return fmt::format("\"{}\" shines already", texture);
  return edit([&] {
    std::vector<SpelledMember> members;
    if (!comment.empty()) members.push_back({"//", spelled(comment)});
    std::ranges::copy(placeOf(light.source), std::back_inserter(members));
    for (const Member& member : changes(plainAt(light.source), light))
      if (member.value) members.push_back({std::string(member.key), *member.value});
    if (light.source.isSky) return addMember("sky", objectOf(members));
    if (light.source.isEmitter()) return addEmitter(texture, objectOf(members));
    if (isSun && !suns_) addMember("suns", "[]");
    history_.replace(withObject(history_.text(), isSun ? *suns_ : list_, members));
  });
}

/// To the file.
void LightsEdit::addMember(std::string_view key, std::string_view value) {
  const std::string_view text = history_.text();
  const std::vector<MemberRange> members = membersAt(text, rootOf(text));
  history_.replace(
      members.size() == 1
          ? Replacement{members[0].value.end, "", fmt::format(R"(, "{}": {})", key, value)}
          : withMember(text, rootOf(text), {std::string(key), std::string(value)},
                       {"version", "lights", "suns", "sky"}));
  read();
}

void LightsEdit::addEmitter(const std::string& texture, const std::string& value) {
  const std::string quoted = spelled(texture);
  const SpelledMember member{quoted.substr(1, quoted.size() - 2), value};
  if (!emit_) return addMember("emit", objectOf({member}));
  std::vector<std::string_view> others;
  for (const LightDescription& emitter : lights_.emitters) others.push_back(emitter.source.texture);
  history_.replace(withMember(history_.text(), *emit_, member, others));
}

std::optional<std::string> LightsEdit::remove(std::size_t light) {
  return edit([&] {
    const std::string_view text = history_.text();
    const LightSource& source = lights_.at(light).source;
    if (source.isEmitter())
      history_.replace(withoutMember(text, *emit_, source.texture));
    else if (source.isSky)
      history_.replace(withoutMember(text, rootOf(text), "sky"));
    else if (source.sun)
      history_.replace(withoutElement(text, *suns_, light - lights_.firstSun()));
    else
      history_.replace(withoutElement(text, list_, light));
  });
}

void LightsEdit::undo() {
  history_.undo();
  read();
}

void LightsEdit::redo() {
  history_.redo();
  read();
}

double toMillimetres(double metres) { return std::round(1000 * metres) / 1000; }

std::string commentAt(std::string_view json, std::size_t object) {
  const std::vector<MemberRange> members = membersAt(json, object);
  const auto comment = commentIn(json, members);
  return comment ? nlohmann::json::parse(members[*comment].value.of(json)) : "";
}

std::string lightName(std::size_t light, const LightSource& source, const std::string& comment) {
  if (!comment.empty()) return fmt::format("{} {}", light, comment);
  if (source.isEmitter()) return fmt::format("emitter {}", source.texture);
  return source.isSky ? "sky" : fmt::format("{} {}", source.sun ? "sun" : "light", light);
}

}  // namespace hearth
