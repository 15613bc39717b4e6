#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/command.h"
#include "cli/info/contents.h"
#include "cli/info/info_json.h"
#include "cli/info/info_text.h"
#include "inputs/inputs.h"

namespace hearth {

namespace {

ExitStatus runInfo(const OptionValues& values) {
  if (values.has(Option::Surfaces) && !values.has(Option::Json))
    return fail("--surfaces: they are printed as JSON only; give --json, too");
  const OpenedLevel opened = loadAndReportWithSource(values);
  const std::optional<LoadedLevel>& loaded = opened.result.loaded;
  if (!loaded) return ExitStatus::BadInput;
  const auto bake = bakeFor(loaded->scene(), values);
  if (!bake) return fail(bake.error());
  const Contents contents = contentsOf(*loaded, opened.source, *bake);
  if (!values.has(Option::Json)) {
    printInfo(*loaded, contents);
    return ExitStatus::Done;
  }
  nlohmann::ordered_json object = infoToJson(*loaded, contents);
  if (values.has(Option::Surfaces))
    object["bake"]["surfaces"] = texelGridsToJson(loaded->scene(), bake->light);
  fmt::print("{}\n", object.dump(2));
  return ExitStatus::Done;
}

}  // namespace

Command infoCommand() {
  return {"info",
          "bakes, and prints what the level holds, which features it requires and which engine "
          "features it pays for",
          std::vector<Option>{Option::Json, Option::Surfaces} + bakeOptions(),
          {},
          runInfo};
}

}  // namespace hearth
