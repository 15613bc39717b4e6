#include "viewer/overlay/overlay.h"

#include <imgui/imgui.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <cstddef>

#include "viewer/input/key.h"

namespace hearth {

namespace {

constexpr float kLetterHeight = 13;  // of ImGui's own font, which is drawn for this size

/// Pixels of a picture's height for each step of the scale.
constexpr int kHeightPerScale = 720;

/// Of the panel, in letters.
constexpr float kPanelLetters = 62;

/// What no event tells: progress, memory, figures.
constexpr double kRefreshSeconds = 0.25;

constexpr double kShortestSeconds = 1e-6;  // ImGui wants time to pass

struct KeyPlace {
  ImGuiKey key;
  Key place;
};
constexpr std::array kImGuiKeys = {
    KeyPlace{ImGuiKey_Tab, Key::Tab},
    KeyPlace{ImGuiKey_LeftArrow, Key::Left},
    KeyPlace{ImGuiKey_RightArrow, Key::Right},
    KeyPlace{ImGuiKey_UpArrow, Key::Up},
    KeyPlace{ImGuiKey_DownArrow, Key::Down},
    KeyPlace{ImGuiKey_PageUp, Key::PageUp},
    KeyPlace{ImGuiKey_PageDown, Key::PageDown},
    KeyPlace{ImGuiKey_Home, Key::Home},
    KeyPlace{ImGuiKey_End, Key::End},
    KeyPlace{ImGuiKey_Insert, Key::Insert},
    KeyPlace{ImGuiKey_Delete, Key::Delete},
    KeyPlace{ImGuiKey_Backspace, Key::Backspace},
    KeyPlace{ImGuiKey_Space, Key::Space},
    KeyPlace{ImGuiKey_Enter, Key::Return},
    KeyPlace{ImGuiKey_Escape, Key::Escape},
    KeyPlace{ImGuiKey_KeyPadEnter, Key::KeypadEnter},
    KeyPlace{ImGuiKey_A, Key::A},
    KeyPlace{ImGuiKey_C, Key::C},
    KeyPlace{ImGuiKey_V, Key::V},
    KeyPlace{ImGuiKey_X, Key::X},
    KeyPlace{ImGuiKey_Y, Key::Y},
    KeyPlace{ImGuiKey_Z, Key::Z},
};

/// Keys of which no text field knows anything.
bool isFunctionKey(Key place) { return place >= Key::F1 && place <= Key::F12; }

/// Square corners: then nearly all that is drawn are upright rectangles, which are cheap.
ImGuiStyle styleOf(int scale) {
  ImGuiStyle style;
  ImGui::StyleColorsDark(&style);
  style.WindowRounding = style.ScrollbarRounding = style.GrabRounding = style.TabRounding = 0;
  style.WindowTitleAlign = {0, 0.5F};
  style.AntiAliasedLinesUseTex = false;  // texels are not mixed
  style.ScaleAllSizes(static_cast<float>(scale));
  return style;
}

/// In letters' pixels and what is round them.
float panelWidth() {
  return std::ceil(kPanelLetters * ImGui::CalcTextSize("M").x +
                   2 * ImGui::GetStyle().WindowPadding.x + ImGui::GetStyle().ScrollbarSize);
}

/// Over the whole height at the right, where neither notes nor messages begin.
void beginPanel(const ImVec2& picture, float width) {
  ImGui::SetNextWindowPos({picture.x - width, 0});
  ImGui::SetNextWindowSize({width, picture.y});
  ImGui::Begin("overlay", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize);
}

}  // namespace

int letterScale(int pictureHeight) { return std::max(1, pictureHeight / kHeightPerScale); }

Overlay::Overlay() { begin(scale_); }

void Overlay::begin(int scale) {
  scale_ = scale;
  context_ = std::shared_ptr<ImGuiContext>(ImGui::CreateContext(), ImGui::DestroyContext);
  ImGui::SetCurrentContext(context_.get());
  ImGui::GetStyle() = styleOf(scale);
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // nothing is written where the user happens to be
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  io.ConfigDragClickToInputText = true;   // a click on a number lets type another
  io.ConfigInputTextCursorBlink = false;  // nothing changes unless something happens
  for (const auto& [key, place] : kImGuiKeys) io.KeyMap[key] = static_cast<int>(place);

  ImFontConfig font;
  font.SizePixels = kLetterHeight * static_cast<float>(scale);
  font.OversampleH = font.OversampleV = 1;
  font.PixelSnapH = true;
  io.Fonts->AddFontDefault(&font);
  unsigned char* cover = nullptr;
  io.Fonts->GetTexDataAsAlpha8(&cover, &atlas_.width, &atlas_.height);
  atlas_.cover = {cover,
                  static_cast<std::size_t>(atlas_.width) * static_cast<std::size_t>(atlas_.height)};
}

void Overlay::toggle() {
  isOpen_ = !isOpen_;
  refresh();
  release();
}

void Overlay::release() {
  ImGui::SetCurrentContext(context_.get());
  ImGui::GetIO().ClearInputKeys();
  ImGui::GetIO().ClearInputCharacters();
  std::ranges::fill(isHeld_, false);
  std::ranges::fill(wasPressed_, false);
}

// --- Events --------------------------------------------------------------------------------------

bool Overlay::handle(const Event& event) {
  if (!isOpen_) return false;
  refresh();
  ImGui::SetCurrentContext(context_.get());
  ImGuiIO& io = ImGui::GetIO();
  if (const auto* key = std::get_if<KeyEvent>(&event)) return handleKey(*key);
  if (is(event, WindowEvent::FocusLost)) release();
  if (is(event, WindowEvent::MouseLeft)) io.MousePos = {-FLT_MAX, -FLT_MAX};
  if (const auto* motion = std::get_if<MouseMotion>(&event)) {
    io.MousePos = {static_cast<float>(motion->x), static_cast<float>(motion->y)};
    return true;
  }
  if (const auto* button = std::get_if<MouseButtonEvent>(&event)) {
    handleButton(*button);
    return true;
  }
  if (const auto* wheel = std::get_if<WheelTurn>(&event)) {
    io.MouseWheelH += static_cast<float>(wheel->right);
    io.MouseWheel += static_cast<float>(wheel->up);
    return true;
  }
  if (const auto* typed = std::get_if<TypedText>(&event)) {
    io.AddInputCharactersUTF8(typed->text.data());
    return true;
  }
  return false;
}

/// A key that is let go of is for the walk, too, in which none is to stay held.
bool Overlay::handleKey(const KeyEvent& key) {
  ImGuiIO& io = ImGui::GetIO();
  io.KeysDown[indexOf(key.key)] = key.isDown;
  io.KeyShift = key.hasShift;
  io.KeyCtrl = key.hasCtrl;
  io.KeyAlt = key.hasAlt;
  return key.isDown && io.WantTextInput && !isFunctionKey(key.key);
}

void Overlay::handleButton(const MouseButtonEvent& button) {
  constexpr std::array kOrder = {MouseButton::Left, MouseButton::Right, MouseButton::Middle};
  static_assert(kOrder.size() == kButtons);
  ImGui::GetIO().MousePos = {static_cast<float>(button.x), static_cast<float>(button.y)};
  const auto found = std::ranges::find(kOrder, button.button);
  if (found == kOrder.end()) return;
  const auto number = static_cast<std::size_t>(found - kOrder.begin());
  isHeld_[number] = button.isDown;
  wasPressed_[number] |= isHeld_[number];
}

// --- Frames --------------------------------------------------------------------------------------

bool Overlay::isStale(double now) const {
  const bool isOld = now < drawn_ || now >= drawn_ + kRefreshSeconds;
  return isOpen_ && (framesLeft_ > 0 || isOld);
}

int Overlay::widthBeside(int pictureWidth) const {
  return isOpen_ ? std::max(0, pictureWidth - panelWidth_) : pictureWidth;
}

void Overlay::draw(double now, const std::function<void()>& sections, const PixelRows& picture) {
  if (const int scale = letterScale(picture.height); scale != scale_) begin(scale);
  ImGui::SetCurrentContext(context_.get());
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(picture.width), static_cast<float>(picture.height)};
  io.DeltaTime = static_cast<float>(std::max(now - drawn_, kShortestSeconds));
  for (std::size_t i = 0; i < kButtons; ++i) io.MouseDown[i] = isHeld_[i] || wasPressed_[i];
  std::ranges::fill(wasPressed_, false);
  ImGui::NewFrame();
  const float width = std::min(io.DisplaySize.x, panelWidth());
  panelWidth_ = static_cast<int>(width);
  beginPanel(io.DisplaySize, width);
  sections();
  hasPopup_ = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
  ImGui::End();
  ImGui::Render();
  painter_.paint(*ImGui::GetDrawData(), atlas_, picture);
  drawn_ = now;
  framesLeft_ = std::max(0, framesLeft_ - 1);
}

}  // namespace hearth
