#include "viewer/overlay/overlay.h"

#include <SDL_keycode.h>
#include <SDL_scancode.h>
#include <imgui/imgui.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <cstddef>

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
  SDL_Scancode place;
};
constexpr std::array kImGuiKeys = {
    KeyPlace{ImGuiKey_Tab, SDL_SCANCODE_TAB},
    KeyPlace{ImGuiKey_LeftArrow, SDL_SCANCODE_LEFT},
    KeyPlace{ImGuiKey_RightArrow, SDL_SCANCODE_RIGHT},
    KeyPlace{ImGuiKey_UpArrow, SDL_SCANCODE_UP},
    KeyPlace{ImGuiKey_DownArrow, SDL_SCANCODE_DOWN},
    KeyPlace{ImGuiKey_PageUp, SDL_SCANCODE_PAGEUP},
    KeyPlace{ImGuiKey_PageDown, SDL_SCANCODE_PAGEDOWN},
    KeyPlace{ImGuiKey_Home, SDL_SCANCODE_HOME},
    KeyPlace{ImGuiKey_End, SDL_SCANCODE_END},
    KeyPlace{ImGuiKey_Insert, SDL_SCANCODE_INSERT},
    KeyPlace{ImGuiKey_Delete, SDL_SCANCODE_DELETE},
    KeyPlace{ImGuiKey_Backspace, SDL_SCANCODE_BACKSPACE},
    KeyPlace{ImGuiKey_Space, SDL_SCANCODE_SPACE},
    KeyPlace{ImGuiKey_Enter, SDL_SCANCODE_RETURN},
    KeyPlace{ImGuiKey_Escape, SDL_SCANCODE_ESCAPE},
    KeyPlace{ImGuiKey_KeyPadEnter, SDL_SCANCODE_KP_ENTER},
    KeyPlace{ImGuiKey_A, SDL_SCANCODE_A},
    KeyPlace{ImGuiKey_C, SDL_SCANCODE_C},
    KeyPlace{ImGuiKey_V, SDL_SCANCODE_V},
    KeyPlace{ImGuiKey_X, SDL_SCANCODE_X},
    KeyPlace{ImGuiKey_Y, SDL_SCANCODE_Y},
    KeyPlace{ImGuiKey_Z, SDL_SCANCODE_Z},
};

/// Keys of which no text field knows anything.
bool isFunctionKey(SDL_Scancode place) {
  return place >= SDL_SCANCODE_F1 && place <= SDL_SCANCODE_F12;
}

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
  for (const auto& [key, place] : kImGuiKeys) io.KeyMap[key] = place;

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

bool Overlay::take(const SDL_Event& event) {
  if (!isOpen_) return false;
  refresh();
  ImGui::SetCurrentContext(context_.get());
  ImGuiIO& io = ImGui::GetIO();
  switch (event.type) {
    case SDL_MOUSEMOTION:
      io.MousePos = {static_cast<float>(event.motion.x), static_cast<float>(event.motion.y)};
      return true;
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP:
      takeButton(event.button);
      return true;
    case SDL_MOUSEWHEEL:
      io.MouseWheelH += static_cast<float>(event.wheel.x);
      io.MouseWheel += static_cast<float>(event.wheel.y);
      return true;
    case SDL_TEXTINPUT:
      io.AddInputCharactersUTF8(event.text.text);
      return true;
    case SDL_KEYDOWN:
      takeKey(event.key);
      return io.WantTextInput && !isFunctionKey(event.key.keysym.scancode);
    case SDL_KEYUP:  // also for the walk, in which no key is to stay held
      takeKey(event.key);
      return false;
    case SDL_WINDOWEVENT:
      if (event.window.event == SDL_WINDOWEVENT_FOCUS_LOST) release();
      if (event.window.event == SDL_WINDOWEVENT_LEAVE) io.MousePos = {-FLT_MAX, -FLT_MAX};
      return false;
    default:
      return false;
  }
}

void Overlay::takeKey(const SDL_KeyboardEvent& key) {
  ImGuiIO& io = ImGui::GetIO();
  const auto place = static_cast<std::size_t>(key.keysym.scancode);
  if (place >= std::size(io.KeysDown)) return;
  io.KeysDown[place] = key.type == SDL_KEYDOWN;
  io.KeyShift = (key.keysym.mod & KMOD_SHIFT) != 0;
  io.KeyCtrl = (key.keysym.mod & KMOD_CTRL) != 0;
  io.KeyAlt = (key.keysym.mod & KMOD_ALT) != 0;
}

void Overlay::takeButton(const SDL_MouseButtonEvent& button) {
  constexpr std::array kOrder = {SDL_BUTTON_LEFT, SDL_BUTTON_RIGHT, SDL_BUTTON_MIDDLE};
  static_assert(kOrder.size() == kButtons);
  ImGui::GetIO().MousePos = {static_cast<float>(button.x), static_cast<float>(button.y)};
  const auto found = std::ranges::find(kOrder, static_cast<int>(button.button));
  if (found == kOrder.end()) return;
  const auto number = static_cast<std::size_t>(found - kOrder.begin());
  isHeld_[number] = button.type == SDL_MOUSEBUTTONDOWN;
  wasPressed_[number] |= isHeld_[number];
}

// --- Frames --------------------------------------------------------------------------------------

bool Overlay::isStale(double now) const {
  const bool isOld = now < drawn_ || now >= drawn_ + kRefreshSeconds;
  return isOpen_ && (framesLeft_ > 0 || isOld);
}

int Overlay::leaves(int pictureWidth) const {
  return isOpen_ ? std::max(0, pictureWidth - panelWidth_) : pictureWidth;
}

void Overlay::draw(double now, const std::function<void()>& sections, Image& picture) {
  if (const int scale = letterScale(picture.height()); scale != scale_) begin(scale);
  ImGui::SetCurrentContext(context_.get());
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(picture.width()), static_cast<float>(picture.height())};
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
