#include "viewer/walk/walk_loop.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <utility>

#include "settings/channels.h"
#include "settings/settings.h"
#include "settings/shell_text.h"
#include "viewer/preferences/config.h"
#include "viewer/walk/captions.h"

namespace hearth {

namespace {

constexpr double kMessageSeconds = 3;
constexpr double kFirstNotesSeconds = 15;
/// The longest rest: ticks that are due must not wait for a frame.
constexpr double kTickSeconds = 1.0 / kTicksPerSecond;

std::string_view nameOf(LightMode mode) {
  switch (mode) {
    case LightMode::Both:
      return "both";
    case LightMode::None:
      return "none";
    case LightMode::Only:
      return "only";
  }
  return "";
}

/// With black at the right.
void widen(Image& picture, int width) {
  if (picture.width() == width) return;
  Image wide(width, picture.height());
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) wide.at(x, y) = picture.at(x, y);
  picture = std::move(wide);
}

void copy(const Image& picture, const PixelRows& rows) {
  const Rgb* from = picture.pixels().data();
  for (int row = 0; row < rows.height; ++row)
    for (std::uint32_t* to = rows.at(0, row); to != rows.at(0, row) + rows.width; ++to, ++from)
      *to = std::uint32_t{from->r} << 16 | std::uint32_t{from->g} << 8 | from->b;
}

}  // namespace

WalkLoop::WalkLoop(const Scene& scene, const Renderer& renderer, WalkSession& session,
                   const WalkHost& host, const WalkSettings& settings,
                   std::shared_ptr<const LevelSource> source)
    : scene_(scene),
      renderer_(&renderer),
      source_(std::move(source)),
      session_(session),
      window_(host.window),
      storage_(host.storage),
      screenshots_(host.screenshots),
      settings_(settings),
      seen_(scene.level()),
      panel_(bakeSettingsFrom(scene, settings.options)) {
  frame_.view = settings.view;
  if (settings.lightsFile) editLights(*settings.lightsFile);
  controls_.setPreferences(settings.preferences);
  written_ = settings.preferences;
  title_.reserve(scene.level().name.size() + 64);  // so that no frame has to
  window_.setTitle(scene.level().name);
}

void WalkLoop::goOnIn(const Scene& scene, const Renderer& renderer,
                      std::shared_ptr<const LevelSource> source) {
  scene_ = scene;
  renderer_ = &renderer;
  source_ = std::move(source);
  seen_ = SeenSectors(scene.level(), seen_);
  panel_.forget();
  shown_.reset();
}

void WalkLoop::choose(const OptionValues& options) {
  settings_.options = options;
  isChoiceNew_ = true;
}

std::optional<OptionValues> WalkLoop::takeChoice() {
  if (!std::exchange(isChoiceNew_, false)) return std::nullopt;
  return settings_.options;
}

void WalkLoop::editLights(const std::filesystem::path& file) {
  panel_.editLights(storage_, file, limitsFrom(settings_.options));
}

void WalkLoop::setNotes(std::vector<std::string> mistakes,
                        const std::optional<StageProgress>& bake) {
  notes_ = std::move(mistakes);
  if (bake) notes_.push_back(progressText(*bake));
  figures_.bake = bake;
}

bool WalkLoop::round() {
  while (const std::optional<Event> event = window_.poll()) take(*event);
  const double now = window_.seconds();
  passTime(now);
  updateMessage(now);
  updateNotes(now);
  if (!hasLeft_) drawOrRest(now);
  return !hasLeft_;
}

// --- Events --------------------------------------------------------------------------------------

void WalkLoop::take(const Event& event) {
  if (const auto* window = std::get_if<WindowEvent>(&event)) take(*window);
  if (panel_.take(event, panelSubject(), settings_.preferences)) return;
  if (const auto* button = std::get_if<MouseButtonEvent>(&event); button && button->isDown)
    captureMouse(true);
  if (const std::optional<Action> action = controls_.take(event)) act(*action);
}

void WalkLoop::take(WindowEvent event) {
  if (event == WindowEvent::CloseAsked) return leave();
  shown_.reset();
  if (event != WindowEvent::FocusLost) return;
  controls_.release();
  panel_.releasePointer();
  captureMouse(false);
  capturesMouseAgain_ = false;
}

void WalkLoop::act(Action action) {
  WalkView& view = frame_.view;
  switch (action) {
    case Action::ShowBoth:
      show(LightMode::Both);
      break;
    case Action::ShowTextures:
      show(LightMode::None);
      break;
    case Action::ShowLight:
      show(LightMode::Only);
      break;
    case Action::Map:
      view.isMapShown = !view.isMapShown;
      break;
    case Action::ZoomIn:
      view.mapMetres = zoomedIn(view.mapMetres);
      break;
    case Action::ZoomOut:
      view.mapMetres = zoomedOut(view.mapMetres);
      break;
    case Action::Keys:
      view.areKeysShown = !view.areKeysShown;
      break;
    case Action::FullScreen:
      window_.toggleFullScreen();
      break;
    case Action::Screenshot:
      wantsScreenshot_ = true;
      shown_.reset();
      break;
    case Action::Overlay:
      togglePanel();
      break;
    case Action::Bookmark:
      bookmark(settings_.bookmarks.freeName());
      break;
    case Action::NextBookmark:
      goToNextBookmark();
      break;
    case Action::Leave:
      if (panel_.letGo()) break;
      if (panel_.isOpen()) return togglePanel();
      if (!controls_.isMouseCaptured()) leave();
      captureMouse(false);
      break;
    default:  // what the next tick does
      break;
  }
}

/// Asks once where that loses edits.
void WalkLoop::leave() {
  hasLeft_ = hasAskedToSave_ || !panel_.hasUnsavedLights();
  if (hasLeft_) return;
  hasAskedToSave_ = true;
  say("lights are not saved: F1 and Ctrl+S save them, leaving again drops them", window_.seconds());
}

void WalkLoop::show(LightMode mode) {
  frame_.view.mode = mode;
  frame_.view.channel = {};
}

void WalkLoop::captureMouse(bool isCaptured) {
  if (controls_.isMouseCaptured() == isCaptured) return;
  controls_.captureMouse(isCaptured);
  window_.captureMouse(isCaptured);
}

/// The panel needs the mouse; the walk gets it back where it had it.
void WalkLoop::togglePanel() {
  panel_.toggle();
  if (!panel_.isOpen() && panel_.hasUnsavedLights())
    say("lights are not saved: F1 and Ctrl+S save them");
  hasAskedToSave_ = false;
  shown_.reset();
  if (panel_.isOpen()) capturesMouseAgain_ = controls_.isMouseCaptured();
  captureMouse(!panel_.isOpen() && capturesMouseAgain_);
}

// --- Bookmarks ---------------------------------------------------------------------------------

void WalkLoop::bookmark(const std::string& name) {
  const auto added =
      settings_.bookmarks.add(bookmarkOf(scene_, session_.walker(), settings_.fov, name));
  say(added ? fmt::format("bookmarked as {}", name) : added.error());
}

void WalkLoop::goToNextBookmark() {
  const std::vector<Bookmark>& all = settings_.bookmarks.all();
  if (all.empty()) return say("there are no bookmarks yet");
  const std::size_t next = nextBookmark_ % all.size();
  nextBookmark_ = next + 1;
  goTo(all[next]);
}

/// A recording has no jumps: it would not lead where it led.
void WalkLoop::goTo(const Bookmark& bookmark) {
  if (!canJump()) return say("no jumps in a walk that is recorded or replayed");
  const auto walker = walkerAt(scene_, bookmark);
  if (!walker) return say(walker.error());
  session_.goOnIn(scene_, *walker);
  settings_.fov = bookmark.fov;
  say(bookmark.name);
}

// --- Time ----------------------------------------------------------------------------------------

void WalkLoop::passTime(double now) {
  const auto [ticks, fraction] = clock_.advance(now);
  for (int ticksDue = ticks; ticksDue > 0 && !hasLeft_; --ticksDue) {
    if (isReplayOver() || session_.isFull())
      hasLeft_ = true;
    else
      session_.tick(nextInput(ticksDue));
  }
  fractionOfTick_ = fraction;
}

WalkInput WalkLoop::nextInput(int ticksDue) {
  if (!replay_) return controls_.nextTick(ticksDue, session_.walker().pitch);
  const WalkInput input = replay_->front();
  replay_ = replay_->subspan(1);
  return input;
}

void WalkLoop::say(std::string message, double now) {
  frame_.message = std::move(message);
  messageBegin_ = now;
}

void WalkLoop::updateMessage(double now) {
  if (now < messageBegin_ || now >= messageBegin_ + kMessageSeconds) frame_.message.clear();
  if (const auto news = screenshots_.news()) {
    tell(*news);
    say(news->text, now);
  }
}

/// Those of the beginning for a while, then only those of the level.
void WalkLoop::updateNotes(double now) {
  if (!begin_) begin_ = now;
  if (now >= *begin_ + kFirstNotesSeconds) settings_.notes.clear();
  frame_.notes = settings_.notes;
  frame_.notes.insert(frame_.notes.end(), notes_.begin(), notes_.end());
}

void WalkLoop::tell(const Screenshots::News& news) {
  window_.print(news.isSaved ? fmt::format("{}: {}", news.text, news.note) : news.text);
}

void WalkLoop::awaitScreenshots() {
  while (const auto news = screenshots_.awaitNews()) tell(*news);
}

// --- Pictures ------------------------------------------------------------------------------------

/// Of geometry the panel covers nothing, if it leaves any room.
Camera WalkLoop::cameraIn(PictureSize picture) const {
  const Eye eye = session_.eye(fractionOfTick_, settings_.preferences.viewBob);
  const int beside = isGeometry(frame_.view.channel) ? panel_.leaves(picture.width) : 0;
  return {eye.sector,    eye.point,     eye.angle,
          eye.pitch,     settings_.fov, beside > 0 ? beside : picture.width,
          picture.height};
}

void WalkLoop::drawOrRest(double now) {
  const std::optional<PictureSize> window = window_.windowSize();
  if (window) {
    frame_.size = settings_.size.value_or(*window);
    frame_.camera = cameraIn(frame_.size);
  }
  if (!window || (shown_ == frame_ && !panel_.isStale(now))) return window_.rest(kTickSeconds);
  const double period = settings_.frameCap > 0 ? 1 / settings_.frameCap : 0;
  const double wait = nextFrame_ - now;
  if (wait > 0 && wait <= period) return window_.rest(std::min(wait, kTickSeconds));
  // Frames keep to their beat; one that is late, or a clock that was set, begins a new one.
  nextFrame_ = (std::abs(wait) < period ? nextFrame_ : now) + period;
  draw(now);
}

void WalkLoop::draw(double now) {
  const Frame drawn = frame_;  // which the overlay may change
  if (isCovered())
    drawImage(now);
  else
    drawRows(now);
  shown_ = drawn;
}

void WalkLoop::drawImage(double now) {
  FrameParts parts;
  double begin = window_.seconds();
  const auto lap = [&] {
    const double end = window_.seconds();
    return end - std::exchange(begin, end);
  };
  const int threads = threadsFor(frame_.size, settings_.threads);
  renderer_->findSpans(frame_.camera, scratch_, picture_, threads);
  parts.find = lap();
  if (frame_.view.channel.empty())
    renderer_->paintSpans(frame_.camera, frame_.view.mode, scratch_, picture_, threads);
  else
    picture_ = drawChannel(scene_, *renderer_, frame_.camera, frame_.view.channel, threads);
  parts.paint = lap();
  if (std::exchange(wantsScreenshot_, false)) screenshots_.take(picture_, cameraText());
  widen(picture_, frame_.size.width);
  seeWhatIsDrawn();
  drawCaptions();
  drawPanel(now);
  parts.cover = lap();
  count(now, begin);
  window_.show(frame_.size, [this](const PixelRows& rows) { copy(picture_, rows); });
  parts.show = lap();
  figures_.frames.add(parts);
}

void WalkLoop::drawRows(double now) {
  const PictureSize size{frame_.camera.width, frame_.camera.height};
  window_.show(size, [&](const PixelRows& rows) {
    renderer_->draw(frame_.camera, frame_.view.mode, scratch_, rows,
                    threadsFor(size, settings_.threads));
    seeWhatIsDrawn();
    count(now, window_.seconds());
  });
}

void WalkLoop::seeWhatIsDrawn() {
  seen_.add(frame_.camera.sector);
  seen_.add(session_.walker().sector);
  scratch_.forEachSpan([this](const Span& span) { seen_.add(span); });
}

void WalkLoop::count(double begin, double end) {
  const auto mean = rate_.count(begin, end);
  if (!mean) return;
  title_.clear();
  fmt::format_to(std::back_inserter(title_), "{} - {:.1f} ms, {:.0f} frames/s", scene_.level().name,
                 1e3 * mean->drawSeconds, mean->framesPerSecond);
  window_.setTitle(title_);
}

/// Whether a frame is kept as a picture, or something is drawn over it.
bool WalkLoop::isCovered() const {
  const WalkView& view = frame_.view;
  return wantsScreenshot_ || panel_.isOpen() || view.isMapShown || view.areKeysShown ||
         !view.channel.empty() || !frame_.notes.empty() || !frame_.message.empty();
}

/// The list of keys and the panel would be in each other's way.
void WalkLoop::drawCaptions() {
  if (frame_.view.isMapShown)
    drawAutomap(picture_, scene_, seen_, session_.eye(fractionOfTick_), frame_.view.mapMetres);
  panel_.drawMarks(panelSubject(), picture_);
  if (frame_.view.areKeysShown && !panel_.isOpen())
    drawKeys(picture_, keyList(settings_.preferences.keys));
  const int width = panel_.leaves(picture_.width());
  if (!frame_.notes.empty() && width > 0) drawNotes(picture_, frame_.notes, width);
  if (!frame_.message.empty()) drawMessage(picture_, frame_.message);
}

// --- The panel -----------------------------------------------------------------------------------

void WalkLoop::drawPanel(double now) {
  if (!panel_.isOpen()) return;
  const bool isPainted = frame_.view.channel.empty();  // span by span, as is counted
  figures_.counters = countersOf(scratch_.found(), isPainted ? scratch_.painted : PaintStats{});
  figures_.lightmapBytes = renderer_->light().stats.bytes;
  figures_.residentBytes = window_.residentBytes();
  grant(panel_.draw(now, panelSubject(), figures_, settings_, frame_.view, picture_), now);
}

PanelSubject WalkLoop::panelSubject() const {
  return {scene_,
          *renderer_,
          source_.get(),
          frame_.camera,
          frame_.size,
          markerSpace(),
          !frame_.view.isMapShown && isOfCamera(frame_.view.channel),
          {canJump(), settings_.writeShot != nullptr}};
}

/// None while the picture shows neither what the camera sees nor the map.
std::optional<MarkerSpace> WalkLoop::markerSpace() const {
  const WalkView& view = frame_.view;
  if (view.isMapShown)
    return MarkerSpace(mapScale(frame_.size.width, frame_.size.height,
                                session_.eye(fractionOfTick_), view.mapMetres));
  return isOfCamera(view.channel) ? std::optional(MarkerSpace(frame_.camera)) : std::nullopt;
}

void WalkLoop::grant(const PanelWishes& wishes, double now) {
  isChoiceNew_ |= wishes.areOptionsNew;
  if (wishes.copied) {
    window_.copy(*wishes.copied);
    say("copied " + *wishes.copied, now);
  }
  if (settings_.preferences != controls_.preferences())
    controls_.setPreferences(settings_.preferences);
  if (wishes.arePreferencesNew) writePreferences();
  if (wishes.bookmark) grant(*wishes.bookmark);
}

void WalkLoop::grant(const BookmarkWish& wish) {
  using What = BookmarkWish::What;
  if (wish.what == What::Add) return bookmark(wish.name);
  const Bookmark mark = *settings_.bookmarks.find(wish.name);
  if (wish.what == What::GoTo) return goTo(mark);
  const bool isRemoved = wish.what == What::Remove;
  const auto done = isRemoved ? settings_.bookmarks.remove(wish.name) : settings_.writeShot(mark);
  if (!done) return say(done.error());
  say(fmt::format("{} {}", isRemoved ? "forgot" : "wrote the shot", wish.name));
}

void WalkLoop::writePreferences() {
  if (settings_.config.empty()) return;
  const auto written = writeConfig(storage_, settings_.config, written_, settings_.preferences);
  if (!written) return say(written.error());
  written_ = settings_.preferences;
}

/// The options with which `hearth shot` draws this picture.
std::string WalkLoop::cameraText() const {
  const Camera& camera = frame_.camera;
  const std::string drawOptions = optionsOf(renderer_->settings());
  const std::string what = frame_.view.channel.empty()
                               ? fmt::format("--light {}", nameOf(frame_.view.mode))
                               : fmt::format("--channel {}", frame_.view.channel);
  return fmt::format("--camera {},{},{},{},{} --sector {} --fov {} --size {}x{} {}{}", camera.eye.x,
                     camera.eye.y, camera.eye.z, camera.angle, camera.pitch,
                     shellWord(scene_[camera.sector].name), camera.fov, camera.width, camera.height,
                     what, drawOptions.empty() ? "" : " " + drawOptions);
}

}  // namespace hearth
