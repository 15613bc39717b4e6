#include "viewer/input/key.h"

#include <algorithm>
#include <array>

namespace hearth {

namespace {

/// Keys with consecutive numbers.
struct KeyRun {
  std::size_t first;
  std::string_view names;  ///< with kBetweenNames between them
};
constexpr char kBetweenNames = '~';
constexpr std::array kKeyRuns = {
    KeyRun{4,
           "A~B~C~D~E~F~G~H~I~J~K~L~M~N~O~P~Q~R~S~T~U~V~W~X~Y~Z~1~2~3~4~5~6~7~8~9~0~Return~"
           "Escape~Backspace~Tab~Space~-~=~[~]~\\~#~;~'~`~,~.~/~CapsLock~F1~F2~F3~F4~F5~F6~F7~"
           "F8~F9~F10~F11~F12~PrintScreen~ScrollLock~Pause~Insert~Home~PageUp~Delete~End~"
           "PageDown~Right~Left~Down~Up~Numlock~Keypad /~Keypad *~Keypad -~Keypad +~"
           "Keypad Enter~Keypad 1~Keypad 2~Keypad 3~Keypad 4~Keypad 5~Keypad 6~Keypad 7~"
           "Keypad 8~Keypad 9~Keypad 0~Keypad ."},
    KeyRun{101,
           "Application~Power~Keypad =~F13~F14~F15~F16~F17~F18~F19~F20~F21~F22~F23~F24~"
           "Execute~Help~Menu~Select~Stop~Again~Undo~Cut~Copy~Paste~Find~Mute~VolumeUp~"
           "VolumeDown"},
    KeyRun{133, "Keypad ,~Keypad = (AS400)"},
    KeyRun{153,
           "AltErase~SysReq~Cancel~Clear~Prior~Return~Separator~Out~Oper~Clear / Again~CrSel~"
           "ExSel"},
    KeyRun{176,
           "Keypad 00~Keypad 000~ThousandsSeparator~DecimalSeparator~CurrencyUnit~"
           "CurrencySubUnit~Keypad (~Keypad )~Keypad {~Keypad }~Keypad Tab~Keypad Backspace~"
           "Keypad A~Keypad B~Keypad C~Keypad D~Keypad E~Keypad F~Keypad XOR~Keypad ^~"
           "Keypad %~Keypad <~Keypad >~Keypad &~Keypad &&~Keypad |~Keypad ||~Keypad :~"
           "Keypad #~Keypad Space~Keypad @~Keypad !~Keypad MemStore~Keypad MemRecall~"
           "Keypad MemClear~Keypad MemAdd~Keypad MemSubtract~Keypad MemMultiply~"
           "Keypad MemDivide~Keypad +/-~Keypad Clear~Keypad ClearEntry~Keypad Binary~"
           "Keypad Octal~Keypad Decimal~Keypad Hexadecimal"},
    KeyRun{224,
           "Left Ctrl~Left Shift~Left Alt~Left GUI~Right Ctrl~Right Shift~Right Alt~Right GUI"},
    KeyRun{257,
           "ModeSwitch~AudioNext~AudioPrev~AudioStop~AudioPlay~AudioMute~MediaSelect~WWW~Mail~"
           "Calculator~Computer~AC Search~AC Home~AC Back~AC Forward~AC Stop~AC Refresh~"
           "AC Bookmarks~BrightnessDown~BrightnessUp~DisplaySwitch~KBDIllumToggle~"
           "KBDIllumDown~KBDIllumUp~Eject~Sleep~App1~App2~AudioRewind~AudioFastForward~"
           "SoftLeft~SoftRight~Call~EndCall"}};

/// Empty where there is no key.
constexpr auto kKeyNames = [] {
  std::array<std::string_view, kKeyCount> byNumber;
  for (const KeyRun& run : kKeyRuns) {
    std::size_t number = run.first;
    for (std::string_view left = run.names; !left.empty(); ++number) {
      byNumber[number] = left.substr(0, left.find(kBetweenNames));
      left.remove_prefix(std::min(left.size(), byNumber[number].size() + 1));
    }
  }
  return byNumber;
}();

char smallLetter(char letter) {
  const bool isCapital = letter >= 'A' && letter <= 'Z';
  return isCapital ? static_cast<char>(letter - 'A' + 'a') : letter;
}

}  // namespace

std::string nameOf(Key key) { return std::string(kKeyNames[indexOf(key)]); }

std::optional<Key> keyNamed(std::string_view name) {
  const auto found = std::ranges::find_if(kKeyNames, [name](std::string_view other) {
    return std::ranges::equal(name, other, {}, smallLetter, smallLetter);
  });
  if (name.empty() || found == kKeyNames.end()) return std::nullopt;
  return static_cast<Key>(found - kKeyNames.begin());
}

std::vector<std::string_view> allKeyNames() {
  std::vector<std::string_view> names;
  for (const std::string_view name : kKeyNames)
    if (!name.empty()) names.push_back(name);
  return names;
}

}  // namespace hearth
