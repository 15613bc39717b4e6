// Random edits of random lights files: all of them undone give the first text, redone the last.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "viewer/edit/curve_edit.h"
#include "viewer/edit/lights_edit.h"

namespace hearth {
namespace {

class Dice {
 public:
  explicit Dice(unsigned seed) : bits_(seed) {}

  std::size_t below(std::size_t count) { return bits_() % count; }
  bool toss() { return below(2) == 0; }
  template <typename T>
  const T& oneOf(const std::vector<T>& values) {
    return values[below(values.size())];
  }
  double number() { return static_cast<double>(below(20'000)) / 1000; }

 private:
  std::mt19937 bits_;
};

/// What a file of lights may look like: blanks, line ends, comments, spellings.
class TextWriter {
 public:
  explicit TextWriter(Dice& dice)
      : dice_(dice),
        feed_(dice.oneOf<std::string>({"", "\n", "\r\n"})),
        blank_(dice.oneOf<std::string>({"", " ", "\t", "  "})) {}

  std::string file() {
    const std::string mark = dice_.toss() ? "" : "\xEF\xBB\xBF";
    if (dice_.toss()) return mark + list() + feed_;
    return mark + "{" + gap() + comment() + "\"lights\"" + colon() + list() + gap() + "," + gap() +
           "\"$kept\"" + colon() + R"([{"x":[]},"]\"}"])" + gap() + "}" + feed_;
  }

 private:
  std::string gap() {
    std::string text;
    for (std::size_t i = dice_.below(3); i > 0; --i) text += dice_.toss() ? feed_ : blank_;
    return text;
  }
  std::string colon() { return gap() + ":" + gap(); }
  std::string comment() {
    return dice_.toss() ? "" : "\"//\"" + colon() + R"("a, {b} \"]\"")" + gap() + "," + gap();
  }
  std::string number() {
    return dice_.oneOf<std::string>({"1.50", "1e1", "0", "-0", "3", "12.0E-1", "7.125"});
  }
  std::string curve() {
    std::string text = "[";
    for (std::size_t i = 0, count = 1 + dice_.below(3); i < count; ++i)
      text += (i > 0 ? gap() + "," : "") + gap() + fmt::format("[{}{},{}1e1]", i, gap(), gap());
    return text + gap() + "]";
  }
  std::string light() {
    std::vector<std::string> members;
    for (const char* key : {"x", "y", "z"}) members.push_back(member(key, number()));
    if (dice_.toss())
      members.push_back(dice_.toss() ? member("falloff", "0.40") : member("curve", curve()));
    if (dice_.toss()) members.push_back(member("color", "\"#Ff8000\""));
    if (dice_.toss()) members.push_back(member("sector", R"("ha\u006cl")"));
    std::rotate(members.begin(), members.begin() + static_cast<long>(dice_.below(members.size())),
                members.end());
    std::string text = "{" + gap() + comment();
    for (std::size_t i = 0; i < members.size(); ++i)
      text += (i > 0 ? gap() + "," + gap() : "") + members[i];
    return text + gap() + "}";
  }
  std::string member(const std::string& key, const std::string& value) {
    return "\"" + key + "\"" + colon() + value;
  }
  std::string list() {
    std::string text = "[" + gap();
    for (std::size_t i = 0, count = dice_.below(4); i < count; ++i)
      text += (i > 0 ? gap() + "," + gap() : "") + light();
    return text + gap() + "]";
  }

  Dice& dice_;
  std::string feed_;
  std::string blank_;
};

/// What a light says, but not where in the file.
auto meaning(const LightDescription& light) {
  return std::tuple(light.source, light.sector ? light.sector->name : "");
}

std::vector<decltype(meaning({}))> meanings(const LightsDescription& lights) {
  std::vector<decltype(meaning({}))> all;
  std::ranges::transform(lights.lights, std::back_inserter(all), meaning);
  return all;
}

/// Beside a curve there are neither intensity nor falloff.
void makeStrong(LightSource& source, double intensity, double falloff) {
  source.intensity = intensity;
  source.falloff = falloff;
  source.curve.clear();
}

/// As the panel changes curves, and with the first point or without the last.
void changeCurve(LightSource& source, Dice& dice) {
  std::vector<CurvePoint>& curve = source.curve;
  if (curve.empty()) {
    makeStrong(source, 255, 0);
    curve = {{dice.number(), dice.number()}};
    return;
  }
  const std::size_t point = dice.below(curve.size());
  switch (dice.below(3)) {
    case 0:
      curve = withPointBehind(curve, point);
      break;
    case 1:
      if (curve.size() == 1)
        makeStrong(source, 255, dice.number());
      else
        curve = withoutPoint(curve, point);
      break;
    default:
      curve[point].level = dice.number();
      break;
  }
}

LightDescription changed(LightDescription light, Dice& dice) {
  LightSource& source = light.source;
  switch (dice.below(7)) {
    case 0:
      source.position = {dice.number(), source.position.y, dice.number()};
      break;
    case 1:
      makeStrong(source, source.intensity, dice.number());
      break;
    case 2:
      makeStrong(source, dice.number(), source.falloff);
      break;
    case 3:
      source.color[dice.below(3)] = static_cast<std::uint8_t>(dice.below(256));
      break;
    case 4:
      source.radius = dice.number();
      break;
    case 5:
      changeCurve(source, dice);
      break;
    default:
      light.sector = dice.toss() ? std::optional(NameReference{"hall \"2\"", {}}) : std::nullopt;
      break;
  }
  return light;
}

const std::vector<std::string> kComments{"", "a lamp", "a \"b\", {c]", "\u00e4\n"};

/// One edit of any kind; what the lights then are to mean is worked out beside it.
void editAtRandom(LightsEdit& edit, Dice& dice) {
  std::vector<LightDescription> expected = edit.lights().lights;
  const std::size_t kind = expected.empty() ? 0 : dice.below(9);
  std::optional<std::string> mistake;
  if (kind == 0) {
    const LightDescription light = changed({}, dice);
    expected.push_back(light);
    mistake = edit.add(light, dice.oneOf(kComments));
  } else if (kind == 1) {
    const std::size_t light = dice.below(expected.size());
    expected.erase(expected.begin() + static_cast<long>(light));
    mistake = edit.remove(light);
  } else if (kind == 8) {
    const std::size_t light = dice.below(expected.size());
    const std::string& comment = dice.oneOf(kComments);
    mistake = edit.setComment(light, comment);
    EXPECT_EQ(edit.commentOf(light), comment);
  } else {
    const std::size_t light = dice.below(expected.size());
    if (kind == 2) edit.beginDrag();
    for (std::size_t i = kind == 2 ? 4 : 1; i > 0 && !mistake; --i) {
      expected[light] = changed(expected[light], dice);
      mistake = edit.set(light, expected[light]);
    }
    if (kind == 2) edit.endDrag();
  }
  EXPECT_FALSE(mistake) << mistake.value_or("");
  LightsDescription wanted;
  wanted.lights = expected;
  EXPECT_EQ(meanings(edit.lights()), meanings(wanted));
}

TEST(RandomEdits, UndoneGiveTheFirstTextAndRedoneTheLast) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Dice dice(seed);
    const std::string first = TextWriter(dice).file();
    auto opened = LightsEdit::open(first, "random.json");
    ASSERT_TRUE(opened) << opened.error() << '\n' << first;
    LightsEdit edit = *std::move(opened);
    for (int i = 0; i < 100; ++i) editAtRandom(edit, dice);
    const std::string last = edit.bytes();
    const auto reread = LightsEdit::open(last, "random.json");
    ASSERT_TRUE(reread) << reread.error();
    EXPECT_EQ(meanings(reread->lights()), meanings(edit.lights()));

    int steps = 0;
    for (; edit.canUndo(); ++steps) edit.undo();
    EXPECT_EQ(edit.bytes(), first);
    EXPECT_GT(steps, 70) << "few edits change nothing";
    EXPECT_LE(steps, 100);
    while (edit.canRedo()) edit.redo();
    EXPECT_EQ(edit.bytes(), last);
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace hearth
