#include "import/doom/thing_types.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string_view>

namespace hearth::doom {

namespace {

constexpr double kTicsPerSecond = 35;

/// What is picked up or lies dead; one walks through it.
constexpr ThingType item(std::uint16_t number, const char* name, const char* sprite,
                         const char* idle) {
  return {number, name, sprite, idle, 20, 16};
}
constexpr ThingType solid(std::uint16_t number, const char* name, const char* sprite,
                          const char* idle, int radius = 16, int height = 16) {
  return {number, name, sprite, idle, radius, height, true};
}
constexpr ThingType hanging(std::uint16_t number, const char* name, const char* sprite,
                            const char* idle, int height, bool isSolid) {
  return {number, name, sprite, idle, isSolid ? 16 : 20, height, isSolid, true};
}
constexpr ThingType monster(std::uint16_t number, const char* name, const char* sprite,
                            const char* idle, int radius, int height, bool hangs = false) {
  return {number, name, sprite, idle, radius, height, true, hangs, true};
}
constexpr ThingType unseen(std::uint16_t number, const char* name) {
  return {number, name, "", "", 0, 0};
}

constexpr std::array kTypes{
    unseen(1, "start of player 1"),
    unseen(2, "start of player 2"),
    unseen(3, "start of player 3"),
    unseen(4, "start of player 4"),
    unseen(11, "deathmatch start"),
    unseen(14, "teleport landing"),
    unseen(87, "spawn spot"),
    unseen(89, "monster spawner"),

    monster(3004, "zombieman", "POSS", "A10 B10", 20, 56),
    monster(9, "shotgun guy", "SPOS", "A10 B10", 20, 56),
    monster(65, "chaingunner", "CPOS", "A10 B10", 20, 56),
    monster(84, "Wolfenstein SS", "SSWV", "A10 B10", 20, 56),
    monster(3001, "imp", "TROO", "A10 B10", 20, 56),
    monster(3002, "demon", "SARG", "A10 B10", 30, 56),
    monster(58, "spectre", "SARG", "A10 B10", 30, 56),
    monster(3006, "lost soul", "SKUL", "A10* B10*", 16, 56),
    monster(3005, "cacodemon", "HEAD", "A", 31, 56),
    monster(69, "hell knight", "BOS2", "A10 B10", 24, 64),
    monster(3003, "baron of hell", "BOSS", "A10 B10", 24, 64),
    monster(68, "arachnotron", "BSPI", "A10 B10", 64, 64),
    monster(71, "pain elemental", "PAIN", "A", 31, 56),
    monster(66, "revenant", "SKEL", "A10 B10", 20, 56),
    monster(67, "mancubus", "FATT", "A15 B15", 48, 64),
    monster(64, "arch-vile", "VILE", "A10 B10", 20, 56),
    monster(7, "spider mastermind", "SPID", "A10 B10", 128, 100),
    monster(16, "cyberdemon", "CYBR", "A10 B10", 40, 110),
    monster(72, "commander Keen", "KEEN", "A", 16, 72, true),
    solid(88, "boss brain", "BBRN", "A"),

    item(2001, "shotgun", "SHOT", "A"),
    item(82, "super shotgun", "SGN2", "A"),
    item(2002, "chaingun", "MGUN", "A"),
    item(2003, "rocket launcher", "LAUN", "A"),
    item(2004, "plasma gun", "PLAS", "A"),
    item(2005, "chainsaw", "CSAW", "A"),
    item(2006, "BFG", "BFUG", "A"),

    item(2007, "clip", "CLIP", "A"),
    item(2048, "box of bullets", "AMMO", "A"),
    item(2008, "shells", "SHEL", "A"),
    item(2049, "box of shells", "SBOX", "A"),
    item(2010, "rocket", "ROCK", "A"),
    item(2046, "box of rockets", "BROK", "A"),
    item(2047, "energy cell", "CELL", "A"),
    item(17, "energy cell pack", "CELP", "A"),
    item(8, "backpack", "BPAK", "A"),

    item(2011, "stimpack", "STIM", "A"),
    item(2012, "medikit", "MEDI", "A"),
    item(2014, "health bonus", "BON1", "A6 B6 C6 D6 C6 B6"),
    item(2015, "armor bonus", "BON2", "A6 B6 C6 D6 C6 B6"),
    item(2018, "green armor", "ARM1", "A6 B7*"),
    item(2019, "blue armor", "ARM2", "A6 B6*"),
    item(2013, "supercharge", "SOUL", "A6* B6* C6* D6* C6* B6*"),
    item(83, "megasphere", "MEGA", "A6* B6* C6* D6*"),
    item(2022, "invulnerability", "PINV", "A6* B6* C6* D6*"),
    item(2023, "berserk", "PSTR", "A*"),
    item(2024, "partial invisibility", "PINS", "A6* B6* C6* D6*"),
    item(2025, "radiation suit", "SUIT", "A*"),
    item(2026, "computer map", "PMAP", "A6* B6* C6* D6* C6* B6*"),
    item(2045, "light visor", "PVIS", "A6* B6"),

    item(5, "blue keycard", "BKEY", "A10 B10*"),
    item(6, "yellow keycard", "YKEY", "A10 B10*"),
    item(13, "red keycard", "RKEY", "A10 B10*"),
    item(38, "red skull key", "RSKU", "A10 B10*"),
    item(39, "yellow skull key", "YSKU", "A10 B10*"),
    item(40, "blue skull key", "BSKU", "A10 B10*"),

    solid(2035, "barrel", "BAR1", "A6 B6", 10, 42),
    solid(70, "burning barrel", "FCAN", "A4* B4* C4*"),
    item(34, "candle", "CAND", "A*"),
    solid(35, "candelabra", "CBRA", "A*"),
    solid(44, "tall blue torch", "TBLU", "A4* B4* C4* D4*"),
    solid(45, "tall green torch", "TGRN", "A4* B4* C4* D4*"),
    solid(46, "tall red torch", "TRED", "A4* B4* C4* D4*"),
    solid(55, "short blue torch", "SMBT", "A4* B4* C4* D4*"),
    solid(56, "short green torch", "SMGT", "A4* B4* C4* D4*"),
    solid(57, "short red torch", "SMRT", "A4* B4* C4* D4*"),
    solid(85, "tall lamp", "TLMP", "A4* B4* C4* D4*"),
    solid(86, "short lamp", "TLP2", "A4* B4* C4* D4*"),
    solid(2028, "floor lamp", "COLU", "A*"),
    solid(48, "tall column", "ELEC", "A"),
    solid(30, "tall green column", "COL1", "A"),
    solid(31, "short green column", "COL2", "A"),
    solid(32, "tall red column", "COL3", "A"),
    solid(33, "short red column", "COL4", "A"),
    solid(36, "column with a heart", "COL5", "A14 B14"),
    solid(37, "column with a skull", "COL6", "A"),
    solid(41, "evil eye", "CEYE", "A6* B6* C6* B6*"),
    solid(42, "floating skulls", "FSKU", "A6* B6* C6*"),
    solid(43, "burnt tree", "TRE1", "A"),
    solid(54, "large tree", "TRE2", "A", 32),
    solid(47, "stalagmite", "SMIT", "A"),
    solid(25, "impaled human", "POL1", "A"),
    solid(26, "twitching impaled human", "POL6", "A6 B8"),
    solid(27, "skull on a pole", "POL4", "A"),
    solid(28, "five skulls on a pole", "POL2", "A"),
    solid(29, "skulls and candles", "POL3", "A6* B6*"),

    hanging(49, "twitching hanged victim", "GOR1", "A10 B15 C8 B6", 68, true),
    hanging(50, "hanged victim, arms out", "GOR2", "A", 84, true),
    hanging(51, "hanged victim, one-legged", "GOR3", "A", 84, true),
    hanging(52, "hanging pair of legs", "GOR4", "A", 68, true),
    hanging(53, "hanging leg", "GOR5", "A", 52, true),
    hanging(63, "twitching hanged victim", "GOR1", "A10 B15 C8 B6", 68, false),
    hanging(59, "hanged victim, arms out", "GOR2", "A", 84, false),
    hanging(61, "hanged victim, one-legged", "GOR3", "A", 52, false),
    hanging(60, "hanging pair of legs", "GOR4", "A", 68, false),
    hanging(62, "hanging leg", "GOR5", "A", 52, false),
    hanging(73, "hanged victim, guts removed", "HDB1", "A", 88, true),
    hanging(74, "hanged victim, guts and brain removed", "HDB2", "A", 88, true),
    hanging(75, "hanging torso, looking down", "HDB3", "A", 64, true),
    hanging(76, "hanging torso, open skull", "HDB4", "A", 64, true),
    hanging(77, "hanging torso, looking up", "HDB5", "A", 64, true),
    hanging(78, "hanging torso, brain removed", "HDB6", "A", 64, true),

    item(10, "bloody mess", "PLAY", "W"),
    item(12, "bloody mess", "PLAY", "W"),
    item(15, "dead player", "PLAY", "N"),
    item(18, "dead zombieman", "POSS", "L"),
    item(19, "dead shotgun guy", "SPOS", "L"),
    item(20, "dead imp", "TROO", "M"),
    item(21, "dead demon", "SARG", "N"),
    item(22, "dead cacodemon", "HEAD", "L"),
    item(23, "dead lost soul", "SKUL", "K"),
    item(24, "pool of blood and bones", "POL5", "A"),
    item(79, "pool of blood", "POB1", "A"),
    item(80, "pool of blood", "POB2", "A"),
    item(81, "pool of brains", "BRS1", "A"),
};

struct IdleFrame {
  char letter;
  int tics;
  bool isBright;
};

bool isDigit(char c) { return c >= '0' && c <= '9'; }

std::vector<IdleFrame> idleFrames(std::string_view text) {
  std::vector<IdleFrame> frames;
  for (const char c : text) {
    if (c == '*')
      frames.back().isBright = true;
    else if (isDigit(c))
      frames.back().tics = 10 * frames.back().tics + (c - '0');
    else if (c != ' ')
      frames.push_back({c, 0, false});
  }
  return frames;
}

int stepsOf(const IdleFrame& frame, int ticsPerStep) {
  return std::max(1, static_cast<int>(std::lround(static_cast<double>(frame.tics) / ticsPerStep)));
}

int countSteps(const std::vector<IdleFrame>& frames, int ticsPerStep) {
  return std::accumulate(frames.begin(), frames.end(), 0, [&](int sum, const IdleFrame& f) {
    return sum + stepsOf(f, ticsPerStep);
  });
}

}  // namespace

std::span<const ThingType> thingTypes() { return kTypes; }

const ThingType* findThingType(std::uint16_t number) {
  const auto found = std::ranges::find(kTypes, number, &ThingType::number);
  return found == kTypes.end() ? nullptr : &*found;
}

Animation animationOf(const ThingType& type) {
  const std::vector<IdleFrame> idle = idleFrames(type.idle);
  Animation animation;
  animation.isBright = std::ranges::all_of(idle, &IdleFrame::isBright);
  if (idle.size() < 2) {
    for (const IdleFrame& frame : idle) animation.frames.push_back(frame.letter);
    return animation;
  }
  int ticsPerStep = 0;
  for (const IdleFrame& frame : idle) ticsPerStep = std::gcd(ticsPerStep, frame.tics);
  while (countSteps(idle, ticsPerStep) > kMaxFrames) ++ticsPerStep;
  for (const IdleFrame& frame : idle)
    animation.frames.insert(animation.frames.end(),
                            static_cast<std::size_t>(stepsOf(frame, ticsPerStep)), frame.letter);
  animation.framesPerSecond = kTicsPerSecond / ticsPerStep;
  return animation;
}

}  // namespace hearth::doom
