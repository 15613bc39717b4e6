#include "desktop/live_level.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <set>
#include <system_error>
#include <utility>

#include "level/locate.h"
#include "math/tolerance.h"
#include "settings/settings.h"

namespace hearth {

namespace {

namespace fs = std::filesystem;

double secondsSinceSaved(const fs::path& file) {
  std::error_code error;
  const fs::file_time_type saved = fs::last_write_time(file, error);
  return std::chrono::duration<double>(fs::file_time_type::clock::now() - saved).count();
}

void printToStderr(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) fmt::print(stderr, "{}\n", line);
}

/// The sector of a name if it contains the point, else the first that does.
std::optional<SectorId> sectorAt(const Scene& scene, const std::string& name, Vec3 point) {
  std::optional<SectorId> found;
  for (const Sector& sector : scene.level().sectors) {
    if (found && sector.name != name) continue;
    if (contains(scene, sector, point, kPositionSlack)) found = sector.id;
  }
  return found;
}

}  // namespace

std::optional<Walker> carriedOver(const Scene& from, const Walker& walker, const Scene& to) {
  const Eye eye = eyeOf(from, walker);
  Walker carried;
  if (const auto feet = sectorAt(to, from[walker.sector].name, walker.feet)) {
    carried = walker;
    carried.sector = *feet;
    return carried;
  }
  if (const auto head = sectorAt(to, from[eye.sector].name, eye.point))
    carried = walkerAt(to, *head, eye.point, eye.angle, eye.pitch);
  else if (const auto& player = to.level().player)
    carried = walkerAt(to, player->sector, player->eye, player->angle, 0);
  else
    return std::nullopt;
  carried.isFlying = walker.isFlying;
  return carried;
}

LiveLevel::LiveLevel(const OptionValues& values, const std::shared_ptr<const LoadedLevel>& loaded,
                     std::shared_ptr<const LevelSource> source, Reload reload,
                     std::chrono::milliseconds nextFile)
    : reload_(reload),
      baker_(values, loaded, std::move(source), nextFile),
      draw_(drawSettingsFrom(values)) {
  watch(*loaded);
}

/// Also the lights that are not there yet.
void LiveLevel::watch(const LoadedLevel& loaded) {
  if (reload_ == Reload::No) return;
  watched_ = loaded.files;
  const auto found = std::ranges::find(watched_, loaded.lights);
  lightsFile_ = static_cast<std::size_t>(found - watched_.begin());
  if (found == watched_.end()) watched_.push_back(loaded.lights);
  watch_.watch(watched_);
}

tl::expected<std::shared_ptr<const LitLevel>, std::string> LiveLevel::awaitFirst(
    const std::function<void()>& wait) {
  while (true) {
    if (const auto news = baker_.news()) {
      printToStderr(news->warnings);
      if (!news->mistakes.empty()) return tl::unexpected(news->mistakes.front());
      if (news->level) return shown_ = news->level;
    }
    wait();
  }
}

void LiveLevel::setOptions(const OptionValues& values) {
  if (reload_ == Reload::Yes) baker_.setOptions(values);
  wanted_.clear();  // a state may have been baked just then, and was stopped
  draw_ = drawSettingsFrom(values);
  if (shown_->renderer.settings() != draw_) shown_ = redrawn(*shown_, draw_);
}

void LiveLevel::update(WalkLoop& loop, WalkSession& session, WindowHost& outside) {
  if (!report_.empty()) outside.print(std::exchange(report_, ""));
  if (const auto options = loop.takeChoice()) {
    const auto before = shown_;  // which the loop still draws
    setOptions(*options);
    loop.continueIn(shown_->loaded->scene(), shown_->renderer, shown_->source);
  }
  LightsEditor* const lights = loop.lightsEditor();
  if (reload_ == Reload::Yes) reload(watch_.changes(), lights);
  if (lights)
    if (auto text = lights->takeText()) baker_.setLights(*std::move(text));
  while (const auto news = baker_.news()) take(*news, loop, session);
  wantLight(loop);
  loop.setNotes(mistakes_, baker_.progress());
}

void LiveLevel::reload(const FileWatch::Changes& changes, LightsEditor* lights) {
  std::set<std::size_t> written = changes.watched;
  if (lights && written.contains(lightsFile_) && !hasOtherLights(*lights))
    written.erase(lightsFile_);
  // What was missing may have come.
  if (written.empty() && (!changes.other || mistakes_.empty())) return;
  const bool areLights = written == std::set{lightsFile_};
  baker_.reload(areLights ? BackgroundBaker::Changed::Lights : BackgroundBaker::Changed::Anything);
  if (!written.empty()) saved_ = watched_[*written.begin()];
}

/// Whether the file, which has been written, has lights that do not show yet and are to.
bool LiveLevel::hasOtherLights(LightsEditor& lights) {
  const bool hasOthers = lights.noteWritten();
  if (!lights.isUnsaved()) baker_.forgetLights();
  return hasOthers;
}

void LiveLevel::take(const LevelNews& news, WalkLoop& loop, WalkSession& session) {
  // What stands over the picture is enough of lights that are being moved.
  const bool isOfFiles = !loop.lightsEditor() || !loop.lightsEditor()->isUnsaved();
  if (isOfFiles) printToStderr(news.warnings);
  if (isOfFiles && mistakes_ != news.mistakes) printToStderr(news.mistakes);
  mistakes_ = news.mistakes;
  if (news.rest && news.restOf == shown_->loaded) loop.addLight(news.rest);
  if (!news.level) return;
  wanted_.clear();
  if (news.level->loaded != shown_->loaded) {
    if (!continueIn(*news.level, session)) {
      mistakes_ = {"there is no room where you stand, and the level has no player to start with"};
      return printToStderr(mistakes_);
    }
    watch(*news.level->loaded);
    if (loop.lightsEditor()) loop.editLights(news.level->loaded->lights);
  }
  const auto before = std::exchange(shown_, news.level);  // which the loop still draws
  if (shown_->renderer.settings() != draw_) shown_ = redrawn(*shown_, draw_);
  loop.continueIn(shown_->loaded->scene(), shown_->renderer, shown_->source);
  if (shown_->model && shown_->loaded != before->loaded) loop.continueWith(*shown_->model);
  if (saved_)
    report_ = fmt::format("{}: {} {:.3f} s after it was saved", saved_->filename().string(),
                          news.isDraft ? "a draft is shown" : "shown", secondsSinceSaved(*saved_));
  if (!news.isDraft) saved_.reset();
}

bool LiveLevel::continueIn(const LitLevel& next, WalkSession& session) {
  MovingLevel level(next.loaded->scene(), session.level());
  const auto walker = carriedOver(session.level().scene(), session.walker(), level.scene());
  if (walker) session.continueIn(std::move(level), *walker);
  return walker.has_value();
}

/// Of states that show now. What is wanted no more is not baked.
void LiveLevel::wantLight(const WalkLoop& loop) {
  const auto wanted = loop.wantedLight();
  if (std::ranges::equal(wanted, wanted_)) return;
  wanted_.assign(wanted.begin(), wanted.end());
  baker_.want(wanted_);
}

}  // namespace hearth
