#include "desktop/run_walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "cli/recording_file.h"
#include "desktop/bookmarks_file.h"
#include "desktop/disk.h"
#include "desktop/live_level.h"
#include "desktop/screenshot_files.h"
#include "desktop/window.h"
#include "desktop/window_place.h"
#include "folders/user_folders.h"
#include "inputs/inputs.h"
#include "inputs/moved_light.h"
#include "measure/budget.h"
#include "model/orbit_view.h"
#include "render/renderer.h"
#include "viewer/edit/movers_edit.h"
#include "viewer/edit/shots_edit.h"
#include "viewer/input/actions.h"
#include "viewer/preferences/config.h"
#include "viewer/walk/walk_loop.h"

namespace hearth {

namespace {

/// A walk that is about to begin: from where, how it is shown, and whose input it takes.
struct Plan {
  RecordedStart start;
  WalkSettings settings;
  std::optional<Recording> replay;
};

/// Recordings are of one version of a level, and saved light is of one geometry.
bool isReloaded(const OptionValues& values) {
  return !values.has(Option::Record) && !values.has(Option::Replay) &&
         !values.has(Option::LightFrom);
}

tl::expected<Plan, std::string> planFor(const Scene& scene,
                                        const std::optional<ModelFigures>& model,
                                        const OptionValues& values) {
  Plan plan;
  if (const auto size = values.text(Option::Size)) plan.settings.size = parseSize(*size);
  plan.settings.fov = values.number(Option::Fov).value_or(plan.settings.fov);
  plan.settings.frameCap = values.number(Option::FrameCap).value_or(plan.settings.frameCap);
  plan.settings.view.mode = lightModeFrom(values);
  plan.settings.options = values;
  plan.settings.canBake = isReloaded(values);
  if (values.has(Option::Replay)) {
    auto recording = readReplay(values);
    if (!recording) return tl::unexpected(recording.error());
    plan.start = recording->start;
    plan.replay = std::move(*recording);
    return plan;
  }
  const auto camera = cameraFor(scene, values, kFirstWindowSize);
  if (!camera) return tl::unexpected(camera.error());
  if (model) plan.settings.model = {*model, viewFrom(*camera, model->box)};
  plan.start = {scene[camera->sector].name, camera->eye, camera->angle, camera->pitch};
  plan.settings.fov = camera->fov;
  return plan;
}

std::optional<std::string> mistakeInWalkOptions(const OptionValues& values) {
  if (isModel(values.level))
    for (const Option option : {Option::Record, Option::Replay, Option::Headless})
      if (values.has(option))
        return fmt::format(
            "{}: {} is a model, which is turned and not walked: leave the option out",
            row(option).name, values.level);
  if (values.has(Option::TargetMs))
    for (const Option option : std::vector<Option>{Option::Quality} + drawOptions())
      if (values.has(option))
        return fmt::format("give --target-ms or {}, not both", row(option).name);
  if (values.has(Option::Headless) && !values.has(Option::Replay))
    return "--headless: give --replay, which alone needs no window";
  if (!values.has(Option::Replay)) return std::nullopt;
  for (const Option option :
       {Option::Start, Option::Camera, Option::Sector, Option::Shot, Option::Mover, Option::Record})
    if (values.has(option)) return fmt::format("give --replay or {}, not both", row(option).name);
  return std::nullopt;
}

std::string words(const RecordedState& state) {
  const Walker& walker = state.walker;
  return fmt::format("sector {}, feet {},{},{}, angle {}, pitch {}", state.sector, walker.feet.x,
                     walker.feet.y, walker.feet.z, walker.angle, walker.pitch);
}

/// Where a replay has ended, and whether that is where it was recorded to end.
ExitStatus judge(const Scene& scene, const WalkSession& session, const Recording& recording) {
  const RecordedState end = recordedState(scene, session.walker());
  fmt::print("{} ticks, end: {}\n", recording.inputs.size(), words(end));
  if (end == recording.end) {
    fmt::print("as recorded, to the bit\n");
    return ExitStatus::Done;
  }
  fmt::print("not as recorded: {}\n", words(recording.end));
  return ExitStatus::Differs;
}

ExitStatus replayHeadless(const Scene& scene, WalkSession& session, const Recording& recording) {
  for (const WalkInput& input : recording.inputs) session.tick(input);
  return judge(scene, session, recording);
}

using SharedLevel = std::shared_ptr<const LoadedLevel>;
using SharedSource = std::shared_ptr<const LevelSource>;

/// Where the place of the window is kept. Pictures of a size of their own have windows that fit.
std::optional<std::filesystem::path> windowFile(const Plan& plan) {
  const auto folder = stateFolder();
  if (!folder || plan.settings.size) return std::nullopt;
  return *folder / "window.json";
}

WindowSettings windowSettings(const Plan& plan, const OptionValues& values) {
  WindowSettings settings;
  settings.pictureSize = plan.settings.size;
  if (values.text(Option::Scale) == "integer") settings.scaling = Scaling::Integer;
  if (const auto file = windowFile(plan)) settings.place = readWindowPlace(*file);
  settings.waitsForDisplay = values.text(Option::Vsync) != "off";
  return settings;
}

/// Writes the walk so far where `--record` says.
ExitStatus keepWalk(const Scene& scene, const RecordedStart& start, const WalkSession& session,
                    const OptionValues& values) {
  const std::optional<std::string> path = values.text(Option::Record);
  if (!path) return ExitStatus::Done;
  const auto written =
      writeRecordingFile(*path, {start, session.inputs(), recordedState(scene, session.walker())});
  return written ? ExitStatus::Done : fail(written.error());
}

Eye firstEye(const Scene& scene, const Plan& plan, const WalkSession& session) {
  if (!plan.settings.model) return eyeOf(scene, session.walker());
  const OrbitView& view = plan.settings.model->view;
  return {session.walker().sector, view.eye(), view.angle, view.pitch};
}

/// Where the walk begins. With a model nobody walks; its origin is in the air of its level.
tl::expected<Walker, std::string> firstWalker(const Scene& scene, const Plan& plan) {
  if (!plan.settings.model) return walkerAtStart(scene, plan.start);
  return Walker{.sector = scene.level().meshes.front().sector, .feet = {}, .velocity = {}};
}

/// Adds options with which a frame of the level as authored fits the time.
void fitFrames(double milliseconds, const Renderer& renderer, const Eye& eye, const Plan& plan,
               WalkWindow& window, Workers* workers, OptionValues& options) {
  const auto [width, height] =
      plan.settings.size.value_or(window.windowSize().value_or(kFirstWindowSize));
  const Camera camera{eye.sector,        eye.point, eye.angle, eye.pitch,
                      plan.settings.fov, width,     height};
  const FittingFrame fitting = frameFitting(renderer, camera, milliseconds,
                                            workersFor({width, height}, workers), steadySeconds);
  fmt::print("picked {}\n", words(fitting));
  std::fflush(stdout);  // before the walk, not after it
  for (const Option option : notStandard(fitting.draw))
    options.set(option, valueOf(fitting.draw, option));
}

/// What the user has set. Mistakes there are told, and do not stop the walk.
Config configOfUser() {
  const auto file = configFile();
  Disk disk;
  return file ? readConfig(disk, *file) : Config{};
}

void addConfig(const Config& config, WalkSettings& settings) {
  settings.preferences = config.preferences;
  for (const Diagnostic& warning : config.warnings) settings.notes.push_back(format(warning));
  printDiagnostics(config.warnings);
}

ExitStatus walkInWindow(const SharedLevel& loaded, const SharedSource& source, const Plan& plan,
                        WalkSession& session, const OptionValues& values) {
  const Scene scene = loaded->scene();
  auto window = WalkWindow::open(loaded->level.name + " - baking", windowSettings(plan, values));
  if (!window)
    return fail(fmt::format("no window can be opened: {}; `{} shot` needs no display",
                            window.error(), values.program));
  LiveLevel live(values, loaded, source,
                 isReloaded(values) ? LiveLevel::Reload::Yes : LiveLevel::Reload::No);
  const auto lit = live.awaitFirst(WalkWindow::answerDesktop);
  if (!lit) return fail(lit.error());
  Disk disk;
  WalkSettings settings = plan.settings;
  if (isReloaded(values) && !settings.model) settings.lightsFile = loaded->lights;
  addConfig(configOfUser(), settings);
  settings.config = configFile().value_or("");
  if (const auto file = bookmarksFile(loaded->path); file && !settings.model)
    settings.bookmarks = Bookmarks(disk, *file);
  settings.writeShot = [&disk, &live](const Bookmark& bookmark) {
    return writeShot(disk, *live.shown()->loaded, bookmark);
  };
  if (isReloaded(values))
    settings.writeMover = [&disk, &live](const MoverEdit& edit) {
      return writeMover(disk, *live.shown()->loaded, edit);
    };
  Workers workers(threadsFrom(values));
  if (const auto target = values.number(Option::TargetMs)) {
    fitFrames(*target, (*lit)->renderer, firstEye(scene, plan, session), plan, *window, &workers,
              settings.options);
    live.setOptions(settings.options);
  }

  ScreenshotFiles screenshots(".", std::filesystem::path(values.level).stem().string());
  WalkLoop loop(scene, live.shown()->renderer, session, {*window, disk, screenshots, &workers},
                settings, source);
  if (plan.replay) loop.replay(plan.replay->inputs);
  // A recording that cannot be written is refused before the walk, not after it.
  if (keepWalk(scene, plan.start, session, values) != ExitStatus::Done) return ExitStatus::BadInput;
  while (loop.round()) live.update(loop, session, *window);
  if (const auto file = windowFile(plan)) keepWindowPlace(*file, window->place());
  loop.awaitScreenshots();
  if (!plan.replay) return keepWalk(scene, plan.start, session, values);
  if (!loop.isReplayOver()) return fail("--replay: left before its end");
  return judge(scene, session, *plan.replay);
}

}  // namespace

ExitStatus runWalk(const OptionValues& values) {
  if (const auto mistake = mistakeInWalkOptions(values)) return fail(*mistake);
  OpenedLevel opened = loadAndReportWithSource(values);
  if (!opened.result.loaded) return ExitStatus::BadInput;
  const auto loaded = std::make_shared<const LoadedLevel>(*std::move(opened.result.loaded));
  const auto shares = moverSharesFor(loaded->level, values);
  if (!shares) return fail(shares.error());
  if (values.has(Option::Record) && std::ranges::count(*shares, 0.0) != std::ssize(*shares))
    return fail(
        "--record: a recording begins with all movers where the level has them; leave out "
        "--mover, or --shot with movers");
  MovingLevel level(loaded->scene(), *shares);
  const auto plan = planFor(level.scene(), opened.model, values);
  if (!plan) return fail(plan.error());
  const auto walker = firstWalker(level.scene(), *plan);
  if (!walker) return fail(fmt::format("--replay: {}", walker.error()));
  WalkSession session(
      std::move(level), *walker,
      values.has(Option::Record) ? WalkSession::Record::Yes : WalkSession::Record::No);
  if (values.has(Option::Headless))
    return replayHeadless(session.level().scene(), session, *plan->replay);
  const SharedSource source = takeSource(opened);
  return walkInWindow(loaded, source, *plan, session, values);
}

std::string keyHelpOfUser() { return keyHelp(configOfUser().preferences.keys); }

}  // namespace hearth
