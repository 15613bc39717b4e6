#include "desktop/background_baker.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <new>
#include <system_error>
#include <utility>

#include "inputs/inputs.h"
#include "inputs/moved_light.h"
#include "measure/level_bench.h"
#include "settings/mover_light.h"
#include "settings/settings.h"

namespace hearth {

namespace {

/// Texels, once for each light, from which on a draft is shown first: an edit shows at once,
/// and the first picture of a walk may take a quarter of a second.
constexpr std::int64_t kWorthADraft = 30'000;
constexpr std::int64_t kWorthADraftAtFirst = 1'000'000;

/// Bakes that are over sooner are not worth a word.
constexpr double kPatienceSeconds = 0.3;

/// Of this thread, on Linux, and of those that it starts: so that frames do not wait for bakes.
void giveWay() { ::setpriority(PRIO_PROCESS, 0, 10); }

}  // namespace

std::shared_ptr<const LitLevel> redrawn(const LitLevel& lit, const DrawSettings& settings) {
  const bool areAlike = settings.textureFilter == lit.renderer.settings().textureFilter;
  return std::make_shared<const LitLevel>(
      lit.loaded, lit.source, lit.model,
      areAlike ? lit.renderer.textures()
               : drawnTextures(lit.loaded->textures, settings.textureFilter),
      lit.light, settings);
}

BackgroundBaker::BackgroundBaker(const OptionValues& values,
                                 std::shared_ptr<const LoadedLevel> loaded,
                                 std::shared_ptr<const LevelSource> source,
                                 std::chrono::milliseconds nextFile)
    : nextFile_(nextFile),
      values_(values),
      current_(std::move(loaded)),
      source_(std::move(source)),
      thread_([this, stop = stop_.get_token()] { run(stop); }) {}

BackgroundBaker::~BackgroundBaker() {
  const std::scoped_lock lock(mutex_);
  isOver_ = true;
  stop_.request_stop();
  wakeUp_.notify_all();
}

void BackgroundBaker::reload(Changed changed) {
  const std::scoped_lock lock(mutex_);
  asked_ = std::max(changed, asked_.value_or(changed));
  stop_.request_stop();
  wakeUp_.notify_all();
}

void BackgroundBaker::setLights(std::string unsaved) {
  const std::scoped_lock lock(mutex_);
  unsavedLights_ = std::move(unsaved);
  asked_ = std::max(Changed::Lights, asked_.value_or(Changed::Lights));
  if (hasShownDraft_) stop_.request_stop();
  wakeUp_.notify_all();
}

void BackgroundBaker::forgetLights() {
  const std::scoped_lock lock(mutex_);
  unsavedLights_.reset();
}

void BackgroundBaker::setOptions(const OptionValues& values) {
  const std::scoped_lock lock(mutex_);
  values_ = values;
  areOptionsNew_ = true;
  stop_.request_stop();
  wakeUp_.notify_all();
}

void BackgroundBaker::want(std::span<const std::vector<double>> states) {
  const std::scoped_lock lock(mutex_);
  wanted_.assign(states.begin(), states.end());
  wakeUp_.notify_all();
}

std::optional<std::string> BackgroundBaker::unsavedLights() const {
  const std::scoped_lock lock(mutex_);
  return unsavedLights_;
}

OptionValues BackgroundBaker::options() const {
  const std::scoped_lock lock(mutex_);
  return values_;
}

std::optional<LevelNews> BackgroundBaker::news() {
  const std::scoped_lock lock(mutex_);
  if (news_.empty()) return std::nullopt;
  LevelNews oldest = std::move(news_.front());
  news_.pop_front();
  return oldest;
}

std::optional<StageProgress> BackgroundBaker::progress() const {
  const std::scoped_lock lock(mutex_);
  const double seconds = steadySeconds() - bakeBegin_;
  if (!progress_ || seconds < kPatienceSeconds) return std::nullopt;
  return StageProgress{Stage::Baking, progress_->texelsDone(), progress_->texels(), seconds};
}

// --- In the baker's own thread ----------------------------------------------------------------

void BackgroundBaker::run(const std::stop_token& stopOfFirst) {
  giveWay();
  attempt([&] { light(true, stopOfFirst); });
  while (const auto job = nextJob())
    attempt([&] {
      if (job->hasOtherOptions && bakeSettingsFrom(current_->scene(), options()) != litBy_)
        isLit_ = false;
      if (job->changed) load(*job->changed);
      if (!isLit_) light(false, job->stop);
      if (isLit_ && !job->atRest.empty()) lightAtRest(job->atRest, job->stop);
    });
}

void BackgroundBaker::attempt(const std::function<void()>& work) {
  try {
    work();
  } catch (const std::bad_alloc&) {
    refuse("not enough memory; larger --texel needs less");
  } catch (const std::system_error& error) {  // the system gives no more threads
    refuse(error.what());
  }
}

/// Waits until there is something to do; none at the end.
std::optional<BackgroundBaker::Job> BackgroundBaker::nextJob() {
  std::unique_lock lock(mutex_);
  wakeUp_.wait(lock, [this] { return isAsked() || !wanted_.empty(); });
  if (isOver_) return std::nullopt;
  stop_ = std::stop_source();
  hasShownDraft_ = false;
  Job job{std::exchange(asked_, std::nullopt),
          std::exchange(areOptionsNew_, false),
          {},
          stop_.get_token()};
  if (job.changed || job.hasOtherOptions || wanted_.empty()) return job;
  job.atRest = std::move(wanted_.front());
  wanted_.pop_front();
  return job;
}

/// The file's level takes the place of the one at hand, if it is one.
void BackgroundBaker::load(Changed changed) {
  LoadResult result = loaded(changed);
  if (!result.loaded && isAskedWithin(nextFile_)) return;
  LevelNews news;
  mistakes_.clear();
  for (const Diagnostic& diagnostic : result.diagnostics)
    (diagnostic.isError ? mistakes_ : news.warnings).push_back(format(diagnostic));
  if (result.loaded) {
    current_ = std::make_shared<const LoadedLevel>(*std::move(result.loaded));
    isLit_ = false;
  }
  if (!result.loaded || !news.warnings.empty()) tell(std::move(news));
}

bool BackgroundBaker::isAskedWithin(std::chrono::milliseconds time) {
  std::unique_lock lock(mutex_);
  return wakeUp_.wait_for(lock, time, [this] { return isAsked(); });
}

bool BackgroundBaker::isOvertaken() const {
  const std::scoped_lock lock(mutex_);
  return isAsked();
}

void BackgroundBaker::refuse(std::string mistake) {
  refusal_ = std::move(mistake);
  tell({});
}

LoadResult BackgroundBaker::loaded(Changed changed) {
  const OptionValues values = options();
  const LoadLimits limits = limitsFrom(values);
  const std::optional<std::string> lights = unsavedLights();
  if (changed == Changed::Lights && isOfFiles_ && source_) {
    auto source = std::make_shared<LevelSource>(*source_);  // what is shown keeps its own
    if (auto result = reloadLights(*current_, *source, limits, lights)) {
      if (result->loaded) source_ = std::move(source);
      return *std::move(result);
    }
  }
  isOfFiles_ = false;
  OpenedLevel opened = openLevel(values.level, limits, lights);
  isOfFiles_ = opened.result.loaded.has_value();
  if (isOfFiles_) {
    model_ = opened.model;
    source_ = takeSource(opened);
  }
  return std::move(opened.result);
}

void BackgroundBaker::light(bool isFirst, const std::stop_token& stop) {
  const Scene scene = current_->scene();
  const OptionValues values = options();
  if (values.has(Option::LightFrom)) return takeFromFile();
  const auto settings = bakeSettingsFor(scene, values);
  if (!settings) return refuse(settings.error());
  refusal_.reset();
  const auto cache = values.has(Option::NoCache) ? std::nullopt : BakeCache::ofUser();
  const bool isKept = isFirst && cache && showKept(*cache, *settings);

  memory_.keepBakes(current_->level.movers.empty() ? 1 : moverLightFrom(values).states);
  // Also where the light was kept: from then on an edit asks for little.
  Rebake rebake(memory_, scene, *settings, threadsFrom(values));
  if (!isKept && rebake.texelLightsLeft() > (isFirst ? kWorthADraftAtFirst : kWorthADraft)) {
    show(rebake.draft(), true);
    if (isOvertaken()) return;
  }
  auto baked = isKept ? rebake.finish(nullptr, stop) : finish(rebake, stop);
  if (!baked) return;
  isLit_ = true;
  litBy_ = *settings;
  if (isKept) return;
  const auto lit = show(*std::move(baked), false);
  if (cache && !unsavedLights()) cache->keep(scene, *settings, *lit->light);
}

void BackgroundBaker::takeFromFile() {
  auto light = lightFor(current_->scene(), options());
  if (!light) return refuse(light.error());
  isLit_ = true;
  show(*std::move(light), false);
}

/// While its progress can be seen.
std::optional<BakedLight> BackgroundBaker::finish(Rebake& rebake, const std::stop_token& stop) {
  const auto progress = std::make_shared<BakeProgress>();
  setProgress(progress);
  auto baked = rebake.finish(progress.get(), stop);
  setProgress(nullptr);
  return baked;
}

/// The level is lit as authored.
void BackgroundBaker::lightAtRest(const std::vector<double>& shares, const std::stop_token& stop) {
  if (!source_ || shares.size() != current_->level.movers.size()) return;
  const OptionValues values = options();
  const auto moved = loadedAt(*current_, *source_, shares, values);
  if (!moved) return refuse(moved.error());
  auto light = values.has(Option::LightFrom) ? lightInFile((*moved)->scene(), shares)
                                             : lightOf((*moved)->scene(), stop);
  if (!light) return;
  tell({.rest = std::make_shared<const RestLight>(
            RestLight{shares, (*moved)->geometry, *std::move(light)}),
        .restOf = current_});
}

/// Only light that the movers change is found anew, if it was not kept.
std::optional<BakedLight> BackgroundBaker::lightOf(const Scene& moved,
                                                   const std::stop_token& stop) {
  const OptionValues values = options();
  const auto cache =
      values.has(Option::NoCache) || unsavedLights() ? std::nullopt : BakeCache::ofUser();
  if (cache)
    if (auto light = cache->find(moved, litBy_)) return light;
  Rebake rebake(memory_, moved, litBy_, threadsFrom(values));
  auto light = finish(rebake, stop);
  if (light && cache) cache->keep(moved, litBy_, *light);
  return light;
}

/// A state that the file does not hold is lit as the nearest one that it holds.
std::optional<BakedLight> BackgroundBaker::lightInFile(const Scene& moved,
                                                       const std::vector<double>& shares) {
  if (missing_.contains(shares)) return std::nullopt;
  auto light = lightFor(moved, options());
  if (light) return *std::move(light);
  missing_.insert(shares);
  if (missing_.size() == 1)  // of others the same would be told
    tell({.warnings = {fmt::format("with its movers elsewhere: {}", light.error())}});
  return std::nullopt;
}

bool BackgroundBaker::showKept(const BakeCache& cache, const BakeSettings& settings) {
  auto light = cache.find(current_->scene(), settings);
  if (!light) return false;
  show(*std::move(light), false);
  return true;
}

std::shared_ptr<const LitLevel> BackgroundBaker::show(BakedLight light, bool isDraft) {
  LevelNews news;
  news.isDraft = isDraft;
  const OptionValues values = options();
  if (const auto warning = warningIfDark(current_->level, light, values); warning && !isDraft)
    news.warnings.push_back(*warning);
  const DrawSettings settings = drawSettingsFrom(values);
  auto lit = std::make_shared<const LitLevel>(
      current_, source_, model_, texturesFor(settings.textureFilter),
      std::make_shared<const BakedLight>(std::move(light)), settings);
  news.level = lit;
  tell(std::move(news));
  const std::scoped_lock lock(mutex_);
  hasShownDraft_ = isDraft;
  return lit;
}

/// An edit of lights leaves them as they are.
const DrawnTextures& BackgroundBaker::texturesFor(TextureFilter filter) {
  if (!textures_ || filter != filter_ || !images_.sharesWith(current_->textures)) {
    textures_ = drawnTextures(current_->textures, filter);
    images_ = current_->textures;
    filter_ = filter;
  }
  return textures_;
}

void BackgroundBaker::setProgress(std::shared_ptr<const BakeProgress> progress) {
  const std::scoped_lock lock(mutex_);
  progress_ = std::move(progress);
  bakeBegin_ = steadySeconds();
}

void BackgroundBaker::tell(LevelNews news) {
  news.mistakes = mistakes_;
  if (refusal_) news.mistakes.push_back(*refusal_);
  const std::scoped_lock lock(mutex_);
  news_.push_back(std::move(news));
}

}  // namespace hearth
