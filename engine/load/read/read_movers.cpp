#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "load/json/fields.h"
#include "load/read/read.h"
#include "load/suggest.h"

namespace hearth {

namespace {

constexpr std::array<std::string_view, 7> kMoverKeys{"sectors", "part",    "to",   "speed",
                                                     "wait",    "trigger", "zones"};
constexpr NumberRange kSpeed{1e-6, kWorldLimit};  // metres a second

/// The place of a value among `names`; none after a mistake.
template <std::size_t count>
std::optional<std::size_t> readChoice(Report& report, JsonValue value,
                                      const std::array<std::string_view, count>& names,
                                      std::string_view what, std::string_view all) {
  if (!value.isString()) {
    reportWrongType(report, value, all);
    return std::nullopt;
  }
  const auto found = std::ranges::find(names, value.text());
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  report.error(value.place(), fmt::format("\"{}\" is no {}", value.text(), what),
               suggest(value.text(), names, ""));
  return std::nullopt;
}

bool readPart(Report& report, const Fields& fields, FlatPart& part) {
  const auto value = fields.require("part", "say which flat moves: \"floor\" or \"ceiling\"");
  if (!value) return false;
  const auto choice =
      readChoice(report, *value, kFlatPartNames, "part", "\"floor\" or \"ceiling\"");
  if (choice) part = static_cast<FlatPart>(*choice);
  return choice.has_value();
}

bool readTo(Report& report, const Fields& fields, MoverDescription& mover) {
  const auto value = fields.require("to", "give the height that the flat moves to");
  if (!value) return false;
  mover.toPlace = value->place();
  const std::optional<double> to = readNumber(report, *value, kCoordinate);
  mover.to = to.value_or(0);
  return to.has_value();
}

bool readMovedSectors(Report& report, const Fields& fields, MoverDescription& mover) {
  const auto value = fields.require("sectors", "name the sectors whose flat moves");
  if (!value) return false;
  mover.sectors = readReferences(report, *value);
  if (value->isArray() && value->size() == 0)
    report.error(value->place(), "a mover without sectors", "name at least one");
  return !mover.sectors.empty();
}

/// Zones count only where the player's feet are asked for.
void readZones(Report& report, const Fields& fields, MoverDescription& mover) {
  const std::optional<JsonValue> value = fields.find("zones");
  if (value) mover.zones = readReferences(report, *value);
  const bool isAsked = mover.trigger == MoverTrigger::Enter;
  if (isAsked && !value)
    report.error(fields.value().place(), "\"trigger\": \"enter\" without \"zones\"",
                 "name the sectors that start it");
  else if (isAsked && value->isArray() && value->size() == 0)
    report.error(value->place(), "no zones", "name the sectors that start it");
  else if (!isAsked && value)
    report.warning(value->place(), "\"zones\" start nothing without \"trigger\": \"enter\"",
                   "give that trigger, or remove them", "mover-zones");
}

MoverDescription readMover(Report& report, const JsonValue::Member& member) {
  const Fields fields(report, member.value, kMoverKeys);
  MoverDescription mover;
  mover.name = member.key.text();
  mover.place = member.key.place();
  mover.isReadable = fields.isObject() && readMovedSectors(report, fields, mover);
  mover.isReadable &= readPart(report, fields, mover.part);
  mover.isReadable &= readTo(report, fields, mover);
  fields.read("speed", kSpeed, mover.speed);
  fields.read("wait", kLength, mover.wait);
  if (const auto trigger = fields.find("trigger"))
    if (const auto choice = readChoice(report, *trigger, kMoverTriggerNames, "trigger",
                                       "\"use\", \"enter\", \"loop\" or \"none\""))
      mover.trigger = static_cast<MoverTrigger>(*choice);
  if (fields.isObject()) readZones(report, fields, mover);
  return mover;
}

}  // namespace

void readMovers(Report& report, JsonValue value, LevelDescription& level) {
  if (!value.isObject()) return reportWrongType(report, value, "an object of movers by name");
  for (const JsonValue::Member& member : value.members())
    level.movers.push_back(readMover(report, member));
}

}  // namespace hearth
