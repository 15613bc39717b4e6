#include "load/link/link.h"

#include <fmt/format.h>

#include <algorithm>

#include "load/suggest.h"

namespace hearth {

SectorNames::SectorNames(const LevelDescription& description) {
  for (std::size_t i = 0; i < description.sectors.size(); ++i) {
    const auto [entry, isNew] = ids_.emplace(description.sectors[i].name, SectorId(i));
    if (!isNew) entry->second.reset();
    names_.push_back(description.sectors[i].name);
  }
}

std::optional<SectorId> SectorNames::link(Report& report, const NameReference& name) const {
  if (const auto found = ids_.find(name.name); found != ids_.end()) return found->second;
  if (report.isFull())
    report.error(name.place, "", "");
  else
    report.error(name.place, fmt::format("there is no sector \"{}\"", name.name),
                 suggest(name.name, names_, "name a sector of this level"));
  return std::nullopt;
}

void SectorNames::reportUnknown(Report& report, const NameReference& name, std::string_view own,
                                std::span<const std::string_view> behind) const {
  std::vector<std::string_view> others = names_;
  std::erase(others, own);
  report.error(name.place, fmt::format("there is no sector \"{}\"", name.name),
               behind.empty()
                   ? suggest(name.name, others, "name a sector of this level")
                   : fmt::format("did you mean \"{}\", which lies there?",
                                 nearestName(name.name, behind).value_or(behind.front())));
}

}  // namespace hearth
