#include "viewer/walk/walk_loop.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "settings/channels.h"
#include "settings/settings.h"

namespace hearth {

namespace {

/// On the terminal.
std::string lineOf(const Screenshots::News& news) {
  return news.isSaved ? fmt::format("{}: {}", news.text, news.note) : news.text;
}

/// None while the picture shows neither what the camera sees nor the map.
std::optional<MarkerSpace> markerSpaceOf(const WalkFrame& frame) {
  const WalkView& view = frame.view;
  if (view.isMapShown)
    return MarkerSpace(mapScale(frame.size.width, frame.size.height, frame.eye, view.mapMetres));
  return isOfCamera(view.channel) ? std::optional(MarkerSpace(frame.camera)) : std::nullopt;
}

/// None of a level in which nothing can move.
std::unique_ptr<MovedView> movedViewOf(const Scene& authored, const Renderer& renderer,
                                       const OptionValues& options) {
  if (authored.level().movers.empty()) return nullptr;
  return std::make_unique<MovedView>(authored, renderer, moverLightFrom(options));
}

}  // namespace

WalkLoop::WalkLoop(const Scene& scene, const Renderer& renderer, WalkSession& session,
                   const WalkHost& host, const WalkSettings& settings,
                   std::shared_ptr<const LevelSource> source)
    : moved_(movedViewOf(scene, renderer, settings.options)),
      scene_(moved_ ? moved_->scene() : scene),
      source_(std::move(source)),
      session_(session),
      window_(host.window),
      storage_(host.storage),
      screenshots_(host.screenshots),
      workers_(host.workers),
      settings_(settings),
      config_(host.storage, settings.config, settings.preferences),
      bookmarks_(session, settings_),
      notices_(settings.notes),
      screen_(scene_, moved_ ? moved_->renderer() : renderer, session, host),
      panel_(bakeSettingsFrom(scene, settings.options)) {
  frame_.view = settings.view;
  if (settings.lightsFile) editLights(*settings.lightsFile);
  if (const auto& model = settings.model)
    model_.emplace(ModelTurn{model->figures, Orbit(model->figures.box, model->view)});
  controls_.setPreferences(settings.preferences);
}

void WalkLoop::continueIn(const Scene& scene, const Renderer& renderer,
                          std::shared_ptr<const LevelSource> source) {
  const auto before =
      std::exchange(moved_, movedViewOf(scene, renderer, settings_.options));  // is still shown
  scene_ = moved_ ? moved_->scene() : scene;
  source_ = std::move(source);
  screen_.continueIn(scene_, moved_ ? moved_->renderer() : renderer);
  panel_.forget();
}

void WalkLoop::continueWith(const ModelFigures& model) {
  model_->figures = model;
  if (!model_->orbit.continueIn(model.box)) goHome();
}

void WalkLoop::replay(std::span<const WalkInput> inputs) {
  replay_ = inputs;
  bookmarks_.forbidJumps();
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
  std::vector<std::string> notes = std::move(mistakes);
  if (bake) notes.push_back(progressText(*bake));
  notices_.setNotes(std::move(notes));
  screen_.setBake(bake);
}

bool WalkLoop::round() {
  while (const std::optional<Event> event = window_.poll()) handle(*event);
  const double now = window_.seconds();
  passTime(now);
  updateNotices(now);
  if (hasLeft_) return false;
  moveFlats();
  aimCamera();
  grant(screen_.show(frame_, panelSubject(), panel_, settings_, now));
  session_.hold(panel_.heldMover());
  return true;
}

// --- Events --------------------------------------------------------------------------------------

void WalkLoop::handle(const Event& event) {
  if (const auto* window = std::get_if<WindowEvent>(&event)) handle(*window);
  if (panel_.handle(event, panelSubject(), settings_.preferences)) return;
  if (model_)
    model_->controls.handle(event, settings_.preferences.keys);
  else if (const auto* button = std::get_if<MouseButtonEvent>(&event); button && button->isDown)
    captureMouse(true);
  if (const std::optional<Action> action = controls_.handle(event)) act(*action);
}

void WalkLoop::handle(WindowEvent event) {
  if (event == WindowEvent::CloseAsked) return leave();
  screen_.redraw();
  if (event != WindowEvent::FocusLost) return;
  controls_.release();
  if (model_) model_->controls.release();
  panel_.releasePointer();
  captureMouse(false);
  capturesMouseAgain_ = false;
}

void WalkLoop::act(Action action) {
  if (model_ && !isOfModels(action)) return;
  WalkView& view = frame_.view;
  switch (action) {
    case Action::ShowBoth:
      view.show(LightMode::Both);
      break;
    case Action::ShowTextures:
      view.show(LightMode::None);
      break;
    case Action::ShowLight:
      view.show(LightMode::Only);
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
      screen_.keepNext();
      break;
    case Action::Overlay:
      togglePanel();
      break;
    case Action::Bookmark:
      say(bookmarks_.addHere(session_.level().scene()));
      break;
    case Action::NextBookmark:
      say(bookmarks_.goToNext(session_.level().scene()));
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
  say("lights are not saved: F1 and Ctrl+S save them, leaving again drops them");
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
  if (model_) model_->controls.release();
  screen_.redraw();
  if (panel_.isOpen()) capturesMouseAgain_ = controls_.isMouseCaptured();
  captureMouse(!panel_.isOpen() && capturesMouseAgain_);
}

// --- Time ----------------------------------------------------------------------------------------

void WalkLoop::passTime(double now) {
  const auto [ticks, fraction] = clock_.advance(now);
  for (int ticksDue = ticks; ticksDue > 0 && !hasLeft_; --ticksDue) {
    if (model_)
      tickModel(ticksDue);
    else if (isReplayOver() || session_.isFull())
      hasLeft_ = true;
    else
      session_.tick(nextInput(ticksDue));
  }
  fractionOfTick_ = fraction;
}

void WalkLoop::tickModel(int ticksDue) {
  model_->orbit.tick(model_->controls.nextTick(ticksDue));
  if (model_->controls.takeHome()) goHome();
}

/// To the view from which the whole model shows.
void WalkLoop::goHome() {
  const std::optional<ImageSize> window = window_.windowSize();
  const ImageSize size = settings_.size.value_or(window.value_or(ImageSize{1, 1}));
  model_->orbit.show(frontView(scene_.level().meshFaces, settings_.fov, size));
}

WalkInput WalkLoop::nextInput(int ticksDue) {
  if (!replay_) return controls_.nextTick(ticksDue, session_.walker().pitch);
  const WalkInput input = replay_->front();
  replay_ = replay_->subspan(1);
  return input;
}

void WalkLoop::updateNotices(double now) {
  notices_.update(now);
  if (const auto news = screenshots_.news()) {
    window_.print(lineOf(*news));
    notices_.say(news->text, now);
  }
  frame_.message = notices_.message();
  frame_.notes = notices_.notes();
}

void WalkLoop::awaitScreenshots() {
  while (const auto news = screenshots_.awaitNews()) window_.print(lineOf(*news));
}

// --- Pictures ------------------------------------------------------------------------------------

/// To where they stand between the last two ticks.
void WalkLoop::moveFlats() {
  if (!moved_) return;
  session_.findShares(fractionOfTick_, frame_.shares);
  moved_->moveTo(frame_.shares);
  moved_->light(workers_);
}

std::span<const std::vector<double>> WalkLoop::wantedLight() const {
  return moved_ ? moved_->wanted() : std::span<const std::vector<double>>();
}

void WalkLoop::addLight(std::shared_ptr<const RestLight> rest) {
  moved_->add(std::move(rest));
  screen_.redraw();
}

/// Of geometry the panel covers nothing, if it leaves any room.
void WalkLoop::aimCamera() {
  const std::optional<ImageSize> window = window_.windowSize();
  if (!window) return;
  frame_.size = settings_.size.value_or(*window);
  frame_.eye = eyeOfFrame(0);
  const Eye eye = eyeOfFrame(settings_.preferences.viewBob);
  const int beside = isGeometry(frame_.view.channel) ? panel_.widthBeside(frame_.size.width) : 0;
  frame_.camera = {eye.sector,         eye.point,
                   eye.angle,          eye.pitch,
                   settings_.fov,      beside > 0 ? beside : frame_.size.width,
                   frame_.size.height, 0};
  // A level in which nothing moves is not drawn again and again.
  if (std::ranges::any_of(scene_.level().sprites, isAnimated))
    frame_.camera.seconds = session_.seconds(fractionOfTick_);
}

Eye WalkLoop::eyeOfFrame(double bob) const {
  if (!model_) return session_.eye(scene_, fractionOfTick_, bob);
  const OrbitView view = model_->orbit.at(fractionOfTick_);
  return {scene_.level().meshes.front().sector, model_->orbit.eyeAt(fractionOfTick_), view.angle,
          view.pitch};
}

// --- The panel -----------------------------------------------------------------------------------

PanelSubject WalkLoop::panelSubject() const {
  const bool canJump = bookmarks_.canJump();
  return {scene_,
          screen_.renderer(),
          source_.get(),
          frame_.camera,
          frame_.size,
          markerSpaceOf(frame_),
          !frame_.view.isMapShown && isOfCamera(frame_.view.channel),
          {canJump, settings_.writeShot != nullptr},
          frame_.shares,
          {canJump, canJump && settings_.writeMover},
          model_ ? &model_->figures : nullptr};
}

void WalkLoop::grant(const PanelRequests& requests) {
  isChoiceNew_ |= requests.optionsChanged;
  if (requests.copied) {
    window_.copy(*requests.copied);
    say("copied " + *requests.copied);
  }
  if (settings_.preferences != controls_.preferences())
    controls_.setPreferences(settings_.preferences);
  if (requests.preferencesChanged)
    if (const auto written = config_.write(settings_.preferences); !written) say(written.error());
  if (requests.bookmark) say(bookmarks_.grant(*requests.bookmark, session_.level().scene()));
  if (requests.mover) write(*requests.mover);
}

/// The level shows it once it is loaded anew.
void WalkLoop::write(const MoverEdit& edit) {
  const auto written = settings_.writeMover(edit);
  if (written) panel_.noteWritten(edit);
  say(written ? fmt::format("wrote the mover {}", edit.name) : written.error());
}

}  // namespace hearth
