#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/command.h"
#include "cli/info/contents.h"
#include "cli/info/info_json.h"
#include "cli/info/info_text.h"
#include "inputs/inputs.h"
#include "inputs/moved_light.h"
#include "measure/light_difference.h"

namespace hearth {

namespace {

ExitStatus runInfo(const OptionValues& values) {
  if (values.has(Option::Surfaces) && !values.has(Option::Json))
    return fail("--surfaces: they are printed as JSON only; give --json, too");
  const OpenedLevel opened = loadAndReportWithSource(values);
  if (!opened.result.loaded) return ExitStatus::BadInput;
  const LoadedLevel& authored = *opened.result.loaded;
  const auto shares = moverSharesFor(authored.level, values);
  if (!shares) return fail(shares.error());
  const auto moved = loadedAt(authored, opened.source, *shares, values);
  if (!moved) return fail(moved.error());
  const LoadedLevel& loaded = **moved;
  const auto bake = bakeFor(loaded.scene(), values);
  if (!bake) return fail(bake.error());
  Contents contents = contentsOf(loaded, opened.source, *bake);
  contents.movers = moverContents(authored, *shares);
  if (restStatesFor(*shares, values).count() > 1) {
    const auto blended = MovedLight(authored, opened.source, values).at(loaded, *shares);
    if (!blended) return fail(blended.error());
    contents.blend = differenceOf(*blended, bake->light);
  }
  if (!values.has(Option::Json)) {
    printInfo(loaded, contents);
    return ExitStatus::Done;
  }
  nlohmann::ordered_json object = infoToJson(loaded, contents);
  if (values.has(Option::Surfaces))
    object["bake"]["surfaces"] = texelGridsToJson(loaded.scene(), bake->light);
  fmt::print("{}\n", object.dump(2));
  return ExitStatus::Done;
}

}  // namespace

Command infoCommand() {
  return {"info",
          "bakes, and prints what the level holds, which features it requires and which engine "
          "features it pays for",
          std::vector<Option>{Option::Mover, Option::MoverStages, Option::Json, Option::Surfaces} +
              bakeOptions(),
          {},
          runInfo};
}

}  // namespace hearth
