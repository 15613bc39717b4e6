#include "viewer/edit/movers_edit.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "text/json_text.h"
#include "viewer/edit/level_file.h"

namespace hearth {

namespace {

/// In the order in which levels have them.
constexpr std::array<std::string_view, 6> kEditedMoverKeys{"sectors", "part", "to",
                                                           "speed",   "wait", "trigger"};

/// Where the member's value begins, in an object that has it.
std::size_t memberIn(std::string_view json, std::size_t object, std::string_view key) {
  const std::vector<MemberRange> members = membersAt(json, object);
  return std::ranges::find(members, key, &MemberRange::name)->value.begin;
}

std::string withMoverMember(std::string_view text, std::string_view mover,
                            const SpelledMember& member) {
  const std::size_t movers = memberIn(text, rootOf(text), "movers");
  const auto key = std::ranges::find(kEditedMoverKeys, member.key);
  const Replacement change =
      withMember(text, memberIn(text, movers, mover), member, {kEditedMoverKeys.begin(), key});
  return std::string(text).replace(change.offset, change.before.size(), change.after);
}

/// The text of a level that has the mover.
std::string withEdit(std::string_view text, const MoverEdit& from, const MoverEdit& to) {
  std::string edited(text);
  if (from.speed != to.speed)
    edited = withMoverMember(edited, to.name, {"speed", fmt::format("{}", to.speed)});
  if (from.trigger != to.trigger)
    edited = withMoverMember(edited, to.name, {"trigger", fmt::format("\"{}\"", name(to.trigger))});
  return edited;
}

}  // namespace

MoverEdit editOf(const Mover& mover) { return {mover.name, mover.trigger, mover.speed}; }

tl::expected<void, std::string> writeMover(Storage& storage, const LoadedLevel& loaded,
                                           const MoverEdit& edit) {
  const std::vector<Mover>& movers = loaded.level.movers;
  const auto mover = std::ranges::find(movers, edit.name, &Mover::name);
  if (mover == movers.end())
    return levelFileError(loaded, fmt::format("has no mover \"{}\"", edit.name));
  if (edit.trigger == MoverTrigger::Enter && mover->zones.empty())
    return levelFileError(loaded, fmt::format("the mover \"{}\" has no zones to enter", edit.name));
  return editLevelFile(storage, loaded,
                       [&](std::string_view text) { return withEdit(text, editOf(*mover), edit); });
}

}  // namespace hearth
