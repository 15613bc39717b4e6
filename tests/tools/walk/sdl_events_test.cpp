// SDL's events in the viewer's words.

#include "desktop/sdl_events.h"

#include <SDL.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace hearth {
namespace {

template <typename Kind>
Kind taken(const SDL_Event& event) {
  const auto own = eventFrom(event);
  const auto* kind = own ? std::get_if<Kind>(&*own) : nullptr;
  EXPECT_TRUE(kind) << event.type;
  return kind ? *kind : Kind{};
}

SDL_Event ofType(Uint32 type) {
  SDL_Event event{};
  event.type = type;
  return event;
}

TEST(SdlKeys, HaveTheSameNamesHere) {
  std::vector<std::string> names;
  for (int code = 0; code < SDL_NUM_SCANCODES; ++code) {
    const std::string name = SDL_GetScancodeName(static_cast<SDL_Scancode>(code));
    EXPECT_EQ(nameOf(static_cast<Key>(code)), name) << code;
    if (!name.empty()) names.push_back(name);
  }
  const std::vector<std::string_view> all = allKeyNames();
  EXPECT_EQ(std::vector<std::string>(all.begin(), all.end()), names);
  for (std::string name : names)
    for (const bool isSmall : {false, true}) {
      if (isSmall)
        for (char& letter : name) letter = static_cast<char>(SDL_tolower(letter));
      ASSERT_TRUE(keyNamed(name)) << name;
      EXPECT_EQ(static_cast<int>(*keyNamed(name)), SDL_GetScancodeFromName(name.data())) << name;
    }
  for (const char* name : {"", "Spcae", "Keypad"}) EXPECT_FALSE(keyNamed(name)) << name;
}

TEST(SdlKeys, HaveTheSameNumbersHere) {
  for (const auto& [key, code] : {std::pair{Key::None, SDL_SCANCODE_UNKNOWN},
                                  {Key::A, SDL_SCANCODE_A},
                                  {Key::Z, SDL_SCANCODE_Z},
                                  {Key::Digit1, SDL_SCANCODE_1},
                                  {Key::Digit3, SDL_SCANCODE_3},
                                  {Key::Return, SDL_SCANCODE_RETURN},
                                  {Key::Space, SDL_SCANCODE_SPACE},
                                  {Key::Equals, SDL_SCANCODE_EQUALS},
                                  {Key::Backslash, SDL_SCANCODE_BACKSLASH},
                                  {Key::F1, SDL_SCANCODE_F1},
                                  {Key::F12, SDL_SCANCODE_F12},
                                  {Key::Insert, SDL_SCANCODE_INSERT},
                                  {Key::Up, SDL_SCANCODE_UP},
                                  {Key::KeypadMinus, SDL_SCANCODE_KP_MINUS},
                                  {Key::KeypadEnter, SDL_SCANCODE_KP_ENTER},
                                  {Key::LeftCtrl, SDL_SCANCODE_LCTRL},
                                  {Key::LeftAlt, SDL_SCANCODE_LALT},
                                  {Key::RightCtrl, SDL_SCANCODE_RCTRL},
                                  {Key::RightAlt, SDL_SCANCODE_RALT}})
    EXPECT_EQ(static_cast<int>(key), code) << nameOf(key);
}

TEST(SdlEvents, TellOfKeys) {
  SDL_Event event = ofType(SDL_KEYDOWN);
  event.key.keysym = {SDL_SCANCODE_Z, SDLK_y, KMOD_LCTRL, 0};  // on a German keyboard
  event.key.repeat = 1;
  const auto down = taken<KeyEvent>(event);
  EXPECT_EQ(down.key, Key::Z);
  EXPECT_TRUE(down.isDown);
  EXPECT_TRUE(down.isRepeat);
  EXPECT_EQ(down.letter, 'y');
  EXPECT_TRUE(down.hasCtrl);
  EXPECT_FALSE(down.hasShift);
  EXPECT_FALSE(down.hasAlt);
  event = ofType(SDL_KEYUP);
  event.key.keysym = {SDL_SCANCODE_RSHIFT, SDLK_RSHIFT, KMOD_RSHIFT | KMOD_LALT, 0};
  const auto up = taken<KeyEvent>(event);
  EXPECT_EQ(up.key, Key::RightShift);
  EXPECT_FALSE(up.isDown);
  EXPECT_FALSE(up.isRepeat);
  EXPECT_EQ(up.letter, 0);
  EXPECT_FALSE(up.hasCtrl);
  EXPECT_TRUE(up.hasShift);
  EXPECT_TRUE(up.hasAlt);
}

TEST(SdlEvents, TellWhatIsTyped) {
  SDL_Event event = ofType(SDL_TEXTINPUT);
  SDL_strlcpy(event.text.text, "\u00e9", sizeof event.text.text);
  EXPECT_EQ(taken<TypedText>(event).text, "\u00e9");
}

TEST(SdlEvents, TellOfTheMouse) {
  SDL_Event event = ofType(SDL_MOUSEMOTION);
  event.motion = {SDL_MOUSEMOTION, 0, 0, 0, 0, 3, 4, 5, -6};
  const auto motion = taken<MouseMotion>(event);
  EXPECT_EQ((std::vector{motion.x, motion.y, motion.right, motion.down}),
            (std::vector{3, 4, 5, -6}));
  for (const auto& [code, button] : {std::pair{SDL_BUTTON_LEFT, MouseButton::Left},
                                     {SDL_BUTTON_RIGHT, MouseButton::Right},
                                     {SDL_BUTTON_MIDDLE, MouseButton::Middle},
                                     {SDL_BUTTON_X1, MouseButton::Other}})
    for (const Uint32 type : {SDL_MOUSEBUTTONDOWN, SDL_MOUSEBUTTONUP}) {
      event = ofType(type);
      event.button.button = static_cast<Uint8>(code);
      event.button.x = 7;
      event.button.y = 8;
      const auto own = taken<MouseButtonEvent>(event);
      EXPECT_EQ(own.button, button);
      EXPECT_EQ(own.isDown, type == SDL_MOUSEBUTTONDOWN);
      EXPECT_EQ((std::pair{own.x, own.y}), (std::pair{7, 8}));
    }
  event = ofType(SDL_MOUSEWHEEL);
  event.wheel.x = 1;
  event.wheel.y = -2;
  EXPECT_EQ(taken<WheelTurn>(event).right, 1);
  EXPECT_EQ(taken<WheelTurn>(event).up, -2);
}

TEST(SdlEvents, TellOfGamepads) {
  for (const auto& [code, axis] : {std::pair{SDL_CONTROLLER_AXIS_LEFTX, GamepadAxis::LeftX},
                                   {SDL_CONTROLLER_AXIS_LEFTY, GamepadAxis::LeftY},
                                   {SDL_CONTROLLER_AXIS_RIGHTX, GamepadAxis::RightX},
                                   {SDL_CONTROLLER_AXIS_RIGHTY, GamepadAxis::RightY},
                                   {SDL_CONTROLLER_AXIS_TRIGGERLEFT, GamepadAxis::LeftTrigger},
                                   {SDL_CONTROLLER_AXIS_TRIGGERRIGHT, GamepadAxis::RightTrigger}}) {
    SDL_Event event = ofType(SDL_CONTROLLERAXISMOTION);
    event.caxis.axis = static_cast<Uint8>(code);
    event.caxis.value = -32768;
    EXPECT_EQ(taken<GamepadMotion>(event).axis, axis);
    EXPECT_EQ(taken<GamepadMotion>(event).value, -32768);
  }
  SDL_Event event = ofType(SDL_CONTROLLERBUTTONDOWN);
  for (const auto& [code, button] : {std::pair{SDL_CONTROLLER_BUTTON_A, GamepadButton::A},
                                     {SDL_CONTROLLER_BUTTON_B, GamepadButton::B},
                                     {SDL_CONTROLLER_BUTTON_X, GamepadButton::X},
                                     {SDL_CONTROLLER_BUTTON_Y, GamepadButton::Y}}) {
    event.cbutton.button = static_cast<Uint8>(code);
    EXPECT_EQ(taken<GamepadButtonEvent>(event).button, button);
    EXPECT_TRUE(taken<GamepadButtonEvent>(event).isDown);
  }
  event.type = SDL_CONTROLLERBUTTONUP;
  EXPECT_FALSE(taken<GamepadButtonEvent>(event).isDown);
  event.cbutton.button = SDL_CONTROLLER_BUTTON_BACK;
  EXPECT_FALSE(eventFrom(event)) << "a button that asks for nothing";
  taken<GamepadRemoved>(ofType(SDL_CONTROLLERDEVICEREMOVED));
}

TEST(SdlEvents, TellOfTheWindow) {
  SDL_Event event = ofType(SDL_WINDOWEVENT);
  for (const auto& [id, own] : {std::pair{SDL_WINDOWEVENT_FOCUS_LOST, WindowEvent::FocusLost},
                                {SDL_WINDOWEVENT_LEAVE, WindowEvent::MouseLeft},
                                {SDL_WINDOWEVENT_EXPOSED, WindowEvent::Changed},
                                {SDL_WINDOWEVENT_SIZE_CHANGED, WindowEvent::Changed}}) {
    event.window.event = static_cast<Uint8>(id);
    EXPECT_EQ(taken<WindowEvent>(event), own);
  }
  EXPECT_EQ(taken<WindowEvent>(ofType(SDL_QUIT)), WindowEvent::CloseAsked);
}

TEST(SdlEvents, AreLeftOutWhereNothingComesOfThem) {
  for (const Uint32 type : {SDL_CONTROLLERDEVICEADDED, SDL_CLIPBOARDUPDATE, SDL_USEREVENT})
    EXPECT_FALSE(eventFrom(ofType(type)));
}

}  // namespace
}  // namespace hearth
