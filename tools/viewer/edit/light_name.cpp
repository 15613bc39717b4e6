#include "viewer/edit/light_name.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "text/json_text.h"

namespace hearth {

std::string commentAt(std::string_view json, std::size_t object) {
  const std::vector<MemberRange> members = membersAt(json, object);
  const auto comment = commentIn(json, members);
  return comment ? nlohmann::json::parse(members[*comment].value.of(json)) : "";
}

std::string lightName(std::size_t light, const std::string& comment) {
  return comment.empty() ? fmt::format("light {}", light) : fmt::format("{} {}", light, comment);
}

}  // namespace hearth
