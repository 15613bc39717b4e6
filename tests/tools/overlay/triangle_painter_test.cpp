// Triangles on the CPU, held against a plain look at every pixel of the picture.

#include "viewer/overlay/triangle_painter.h"

#include <gtest/gtest.h>
#include <imgui/imgui.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <random>
#include <vector>

#include "settings/options.h"
#include "support/canvas.h"

namespace hearth {
namespace {

constexpr ImU32 kWhite = IM_COL32(255, 255, 255, 255);
const ImVec4 kEverywhere = {0, 0, 16384, 16384};

/// Eight by four texels, all of them different.
const std::vector<std::uint8_t>& texels() {
  static const std::vector<std::uint8_t> kTexels = [] {
    std::vector<std::uint8_t> cover;
    for (int i = 0; i < 32; ++i) cover.push_back(static_cast<std::uint8_t>(255 - 8 * i));
    return cover;
  }();
  return kTexels;
}

GlyphAtlas atlas() { return {8, 4, texels()}; }

/// The highest byte of a pixel means nothing, so it may be any.
void fill(const PixelRows& rows, const Image& picture) {
  for (int y = 0; y < rows.height; ++y)
    for (int x = 0; x < rows.width; ++x) *rows.at(x, y) = 0xB5000000 | toXrgb(picture.at(x, y));
}

/// Lists as ImGui makes them.
class Drawing {
 public:
  Drawing() : list_(nullptr) {}

  void triangle(const ImDrawVert& a, const ImDrawVert& b, const ImDrawVert& c) {
    for (const ImDrawVert& vertex : {a, b, c}) {
      list_.IdxBuffer.push_back(static_cast<ImDrawIdx>(list_.VtxBuffer.Size));
      list_.VtxBuffer.push_back(vertex);
    }
  }

  /// Of two triangles, from the left top corner on.
  void rectangle(ImVec2 from, ImVec2 to, ImVec2 uvFrom, ImVec2 uvTo, ImU32 color) {
    const auto first = static_cast<ImDrawIdx>(list_.VtxBuffer.Size);
    for (const int i : {0, 1, 2, 0, 2, 3})
      list_.IdxBuffer.push_back(static_cast<ImDrawIdx>(first + i));
    list_.VtxBuffer.push_back({from, uvFrom, color});
    list_.VtxBuffer.push_back({{to.x, from.y}, {uvTo.x, uvFrom.y}, color});
    list_.VtxBuffer.push_back({to, uvTo, color});
    list_.VtxBuffer.push_back({{from.x, to.y}, {uvFrom.x, uvTo.y}, color});
  }

  /// All triangles since the last one.
  ImDrawCmd& command(const ImVec4& clip = kEverywhere) {
    ImDrawCmd command;
    command.ClipRect = clip;
    command.IdxOffset = begin_;
    command.ElemCount = static_cast<unsigned>(list_.IdxBuffer.Size) - begin_;
    begin_ = static_cast<unsigned>(list_.IdxBuffer.Size);
    list_.CmdBuffer.push_back(command);
    return list_.CmdBuffer.back();
  }

  ImDrawList& list() { return list_; }

  Image painted(const Image& start) {
    test::Canvas picture(start.width(), start.height());
    fill(picture, start);
    ImDrawList* lists[] = {&list_};
    ImDrawData data;
    data.CmdLists = lists;
    data.CmdListsCount = 1;
    TrianglePainter().paint(data, atlas(), picture);
    return picture.image();
  }

 private:
  ImDrawList list_;
  unsigned begin_ = 0;
};

ImDrawVert vertex(float x, float y, ImU32 color = kWhite, ImVec2 uv = {0, 0}) {
  return {{x, y}, uv, color};
}

// --- The reference -------------------------------------------------------------------------------

struct Place {
  std::int64_t x;
  std::int64_t y;
};

struct PlainVertex {
  Place at;     ///< 1/16 pixel
  Place texel;  ///< 1/256 texel
  std::array<int, 4> color;
};

PlainVertex plain(const ImDrawVert& vertex) {
  const auto texel = [](float fraction, int side) {
    return std::llround(std::min(std::max(0.0, double{fraction} * 256 * side), 256.0 * side - 1));
  };
  PlainVertex result{{std::llround(16.0 * vertex.pos.x), std::llround(16.0 * vertex.pos.y)},
                     {texel(vertex.uv.x, 8), texel(vertex.uv.y, 4)},
                     {}};
  for (std::size_t i = 0; i < 4; ++i)
    result.color.at(i) = static_cast<int>(vertex.col >> (8 * i) & 255);
  return result;
}

std::int64_t cross(Place a, Place b, Place p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/// On the inner side of an edge from `a` to `b`, or on it and it is at the top or left.
bool isInside(Place a, Place b, Place p) {
  const std::int64_t side = cross(a, b, p);
  return side > 0 || (side == 0 && (b.y < a.y || (b.y == a.y && b.x > a.x)));
}

void plainPixel(const std::array<PlainVertex, 3>& t, int x, int y, Image& picture) {
  const Place p{16 * x + 8, 16 * y + 8};
  const std::int64_t area = cross(t[0].at, t[1].at, t[2].at);
  const std::array<std::int64_t, 3> weight = {
      cross(t[1].at, t[2].at, p), cross(t[2].at, t[0].at, p), cross(t[0].at, t[1].at, p)};
  for (std::size_t i = 0; i < 3; ++i)
    if (!isInside(t.at(i).at, t.at((i + 1) % 3).at, p)) return;
  const auto mean = [&](auto part) {
    return weight[0] * part(t[0]) + weight[1] * part(t[1]) + weight[2] * part(t[2]);
  };
  const auto u = mean([](const PlainVertex& at) { return at.texel.x; }) / area / 256;
  const auto v = mean([](const PlainVertex& at) { return at.texel.y; }) / area / 256;
  std::array<double, 4> color{};
  for (std::size_t i = 0; i < 4; ++i)
    color.at(i) = static_cast<double>(
        (2 * mean([i](const PlainVertex& at) { return at.color.at(i); }) + area) / (2 * area));
  const double alpha = std::round(color[3] * texels()[static_cast<std::size_t>(8 * v + u)] / 255.0);
  Rgb& pixel = picture.at(x, y);
  const auto mixed = [alpha](std::uint8_t below, double above) {
    return static_cast<std::uint8_t>(std::round((above * alpha + below * (255 - alpha)) / 255));
  };
  pixel = {mixed(pixel.r, color[0]), mixed(pixel.g, color[1]), mixed(pixel.b, color[2])};
}

bool isMeant(const ImDrawVert& v) {
  return std::abs(v.pos.x) <= 32768 && std::abs(v.pos.y) <= 32768 && std::isfinite(v.uv.x) &&
         std::isfinite(v.uv.y);
}

/// Every triangle, one after the other, at every pixel of the picture.
Image plainlyPainted(const ImDrawList& list, Image picture) {
  for (const ImDrawCmd& command : list.CmdBuffer)
    for (unsigned i = 0; i + 2 < command.ElemCount; i += 3) {
      std::array<PlainVertex, 3> triangle{};
      bool isDrawn = true;
      for (unsigned corner = 0; corner < 3; ++corner) {
        const std::uint64_t at = std::uint64_t{command.IdxOffset} + i + corner;
        const std::uint64_t number =
            at < static_cast<std::uint64_t>(list.IdxBuffer.Size)
                ? std::uint64_t{command.VtxOffset} + list.IdxBuffer[static_cast<int>(at)]
                : std::numeric_limits<std::uint64_t>::max();
        isDrawn &= number < static_cast<std::uint64_t>(list.VtxBuffer.Size) &&
                   isMeant(list.VtxBuffer[static_cast<int>(number)]);
        if (isDrawn) triangle.at(corner) = plain(list.VtxBuffer[static_cast<int>(number)]);
      }
      if (!isDrawn) continue;
      if (cross(triangle[0].at, triangle[1].at, triangle[2].at) < 0)
        std::swap(triangle[1], triangle[2]);
      const ImVec4& clip = command.ClipRect;
      for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
          if (x + 0.5 >= clip.x && x + 0.5 < clip.z && y + 0.5 >= clip.y && y + 0.5 < clip.w)
            plainPixel(triangle, x, y, picture);
    }
  return picture;
}

// --- Against it ----------------------------------------------------------------------------------

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}

  int below(int end) { return static_cast<int>(engine_() % static_cast<unsigned>(end)); }
  float between(float from, float to) {
    return from + (to - from) * static_cast<float>(below(1 << 20)) / (1 << 20);
  }
  ImU32 color() { return static_cast<ImU32>(engine_()); }
  /// Often on a pixel's border or centre, sometimes far outside.
  float place() {
    const int kind = below(8);
    if (kind == 0) return between(-3000, 3000);
    if (kind < 4) return between(-4, 24);
    return static_cast<float>(below(56) - 8) / 2;
  }
  ImVec2 point() { return {place(), place()}; }
  ImVec2 uv() { return {static_cast<float>(below(9)) / 8, between(-0.1F, 1.1F)}; }

  Image picture() {
    Image picture(1 + below(40), 1 + below(20));
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x) picture.at(x, y) = {byte(), byte(), byte()};
    return picture;
  }

 private:
  std::uint8_t byte() { return static_cast<std::uint8_t>(below(256)); }

  std::mt19937 engine_;
};

void expectAsPlain(Drawing& drawing, const Image& picture, int seed) {
  ASSERT_EQ(drawing.painted(picture), plainlyPainted(drawing.list(), picture)) << "seed " << seed;
}

TEST(Triangles, CoverAndMixAsALookAtEveryPixelSays) {
  for (int seed = 0; seed < 1500; ++seed) {
    Random random(static_cast<unsigned>(seed));
    Drawing drawing;
    for (int i = 0; i < 4; ++i) {
      std::array<ImDrawVert, 3> corners{};
      for (ImDrawVert& corner : corners) corner = {random.point(), random.uv(), random.color()};
      drawing.triangle(corners[0], corners[1], corners[2]);
    }
    drawing.command();
    expectAsPlain(drawing, random.picture(), seed);
  }
}

TEST(Triangles, OfRectanglesAreTheSameAsOthers) {
  for (int seed = 0; seed < 1500; ++seed) {
    Random random(static_cast<unsigned>(seed));
    Drawing drawing;
    for (int i = 0; i < 4; ++i) {
      const ImVec2 uv = random.uv();
      const bool isPlain = random.below(3) == 0;
      const ImU32 opaque = random.below(2) == 0 ? IM_COL32_A_MASK : 0;
      drawing.rectangle(random.point(), random.point(), uv, isPlain ? uv : random.uv(),
                        random.color() | opaque);
    }
    drawing.command();
    expectAsPlain(drawing, random.picture(), seed);
  }
}

TEST(Triangles, AreCutByTheirClipRectangle) {
  for (int seed = 0; seed < 1000; ++seed) {
    Random random(static_cast<unsigned>(seed));
    Drawing drawing;
    for (int i = 0; i < 3; ++i) {
      drawing.rectangle({0, 0}, {20, 20}, {0, 0}, {1, 1}, random.color());
      drawing.triangle(vertex(-9, -3, random.color()), vertex(40, 4, random.color()),
                       vertex(3, 30, random.color()));
      const ImVec2 from = random.point();
      const ImVec2 to = random.point();
      drawing.command({from.x, from.y, to.x, to.y});
    }
    expectAsPlain(drawing, random.picture(), seed);
  }
}

TEST(Triangles, ThatCannotBeMeantAreLeftOut) {
  constexpr std::array kWild = {std::numeric_limits<float>::quiet_NaN(),
                                std::numeric_limits<float>::infinity(),
                                -std::numeric_limits<float>::infinity(),
                                std::numeric_limits<float>::max(),
                                -std::numeric_limits<float>::max(),
                                32768.0F,
                                -32768.0F,
                                32769.0F,
                                1e-40F};
  for (int seed = 0; seed < 2000; ++seed) {
    Random random(static_cast<unsigned>(seed));
    const auto wild = [&](float& value) {
      if (random.below(4) == 0) value = kWild.at(static_cast<std::size_t>(random.below(9)));
    };
    Drawing drawing;
    for (int i = 0; i < 4; ++i) {
      drawing.rectangle(random.point(), random.point(), random.uv(), random.uv(), random.color());
      drawing.triangle(vertex(random.place(), 3), vertex(9, random.place()), vertex(1, 1));
    }
    for (ImDrawVert& corner : drawing.list().VtxBuffer)
      for (float* value : {&corner.pos.x, &corner.pos.y, &corner.uv.x, &corner.uv.y})
        if (random.below(4) == 0) wild(*value);
    for (ImDrawIdx& index : drawing.list().IdxBuffer)
      if (random.below(16) == 0) index = static_cast<ImDrawIdx>(random.below(1 << 16));
    ImVec4 clip = kEverywhere;
    for (float* value : {&clip.x, &clip.y, &clip.z, &clip.w}) wild(*value);
    ImDrawCmd& command = drawing.command(clip);
    if (random.below(4) == 0) command.VtxOffset = static_cast<unsigned>(random.below(64));
    if (random.below(4) == 0) command.IdxOffset = static_cast<unsigned>(random.below(128));
    if (random.below(8) == 0) command.VtxOffset = ~0U;
    if (random.below(8) == 0) command.IdxOffset = ~0U;
    if (random.below(4) == 0) command.ElemCount = static_cast<unsigned>(random.below(1 << 20));
    expectAsPlain(drawing, random.picture(), seed);
  }
}

// --- By hand -------------------------------------------------------------------------------------

TEST(Triangles, WithCommonEdgesCoverEachPixelOnce) {
  for (int seed = 0; seed < 300; ++seed) {
    Random random(static_cast<unsigned>(seed));
    // All around a point, which is often the centre of a pixel.
    const ImVec2 middle{static_cast<float>(8 + random.below(16)) / 2,
                        static_cast<float>(8 + random.below(16)) / 2};
    const std::array<ImVec2, 6> around = {{{-30, -30},
                                           {random.between(0, 15), -30},
                                           {50, -30},
                                           {50, 50},
                                           {random.between(0, 15), 50},
                                           {-30, 50}}};
    constexpr ImU32 kOne = IM_COL32(1, 0, 0, 255);
    std::array<std::array<int, 16>, 16> sums{};
    for (std::size_t i = 0; i < 6; ++i) {
      Drawing one;
      one.triangle({middle, {0, 0}, kOne}, {around.at(i), {0, 0}, kOne},
                   {around.at((i + 1) % 6), {0, 0}, kOne});
      one.command();
      const Image picture = one.painted(Image(16, 16));
      for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x)
          sums.at(static_cast<std::size_t>(y)).at(static_cast<std::size_t>(x)) +=
              picture.at(x, y).r;
    }
    for (const auto& row : sums)
      for (const int sum : row) ASSERT_EQ(sum, 1) << "seed " << seed;
  }
}

TEST(Triangles, WithoutAnAreaCoverNothing) {
  const Image picture(9, 9, {1, 2, 3});
  Drawing drawing;
  drawing.triangle(vertex(1, 1), vertex(1, 1), vertex(1, 1));
  drawing.triangle(vertex(0, 0), vertex(4, 4), vertex(8, 8));
  drawing.triangle(vertex(0, 4.5F), vertex(4, 4.5F), vertex(8, 4.5F));
  drawing.rectangle({2, 2}, {2, 8}, {0, 0}, {0, 0}, kWhite);
  drawing.command();
  EXPECT_EQ(drawing.painted(picture), picture);
}

TEST(Triangles, BlendByTheirAlphaAndThatOfTheTexel) {
  Drawing drawing;
  drawing.rectangle({0, 0}, {1, 1}, {0, 0}, {0, 0}, IM_COL32(200, 100, 0, 51));
  drawing.rectangle({1, 0}, {2, 1}, {0.125F, 0}, {0.125F, 0}, IM_COL32(255, 0, 0, 255));
  drawing.command();
  const Image picture = drawing.painted(Image(2, 1, {100, 100, 200}));
  EXPECT_EQ(picture.at(0, 0), (Rgb{120, 100, 160}));  // a fifth
  EXPECT_EQ(picture.at(1, 0), (Rgb{250, 3, 6}));      // 247 of 255
}

/// Of levels of a channel, rounded to the nearest: there is no half of 255.
std::uint8_t exactMix(int below, int above, int alpha) {
  return static_cast<std::uint8_t>((above * alpha + below * (255 - alpha) + 127) / 255);
}

/// Pictures of a row for each colour that is drawn, over all levels of each channel.
constexpr int kColorStep = 5;
constexpr int kColors = 255 / kColorStep + 1;

std::array<int, 3> colorAbove(int row) {
  const int level = row * kColorStep;
  return {level, 255 - level, (level + 130) % 256};
}

Rgb colorBelow(int column) {
  const auto times = [column](int odd) { return static_cast<std::uint8_t>(column * odd); };
  return {times(1), times(3), times(5)};
}

Image allLevels() {
  Image picture(256, kColors);
  for (int y = 0; y < kColors; ++y)
    for (int x = 0; x < 256; ++x) picture.at(x, y) = colorBelow(x);
  return picture;
}

Image withColors(const Image& levels, int alpha) {
  Drawing drawing;
  for (int y = 0; y < kColors; ++y) {
    const auto [r, g, b] = colorAbove(y);
    const auto top = static_cast<float>(y);
    drawing.rectangle({0, top}, {256, top + 1}, {0, 0}, {0, 0}, IM_COL32(r, g, b, alpha));
  }
  drawing.command();
  return drawing.painted(levels);
}

TEST(Triangles, OfRectanglesMixEveryLevelByEveryAlphaRoundedExactly) {
  const Image levels = allLevels();
  for (int alpha = 0; alpha < 256; ++alpha) {
    const Image picture = withColors(levels, alpha);
    int wrong = 0;
    for (int y = 0; y < kColors; ++y)
      for (int x = 0; x < 256; ++x) {
        const Rgb below = colorBelow(x);
        const auto [r, g, b] = colorAbove(y);
        const Rgb exact{exactMix(below.r, r, alpha), exactMix(below.g, g, alpha),
                        exactMix(below.b, b, alpha)};
        wrong += picture.at(x, y) == exact ? 0 : 1;
      }
    ASSERT_EQ(wrong, 0) << "alpha " << alpha;
  }
}

TEST(Triangles, ShowEveryTexelOfTheAtlasOnceWhereThatIsTheirSize) {
  Drawing drawing;
  drawing.rectangle({3, 2}, {11, 6}, {0, 0}, {1, 1}, kWhite);
  drawing.command();
  const Image picture = drawing.painted(Image(13, 9));
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 8; ++x)
      EXPECT_EQ(picture.at(3 + x, 2 + y).g, texels()[static_cast<std::size_t>(8 * y + x)]);
}

TEST(Triangles, OfCallbacksAreNotDrawn) {
  const Image picture(4, 4);
  Drawing drawing;
  drawing.rectangle({0, 0}, {4, 4}, {0, 0}, {0, 0}, kWhite);
  drawing.command().UserCallback = [](const ImDrawList*, const ImDrawCmd*) { FAIL(); };
  EXPECT_EQ(drawing.painted(picture), picture);
}

TEST(Triangles, FillTheLargestPicturesToTheirEdges) {
  for (const auto& [width, height] : {ImageSize{kMaxPictureSide, 1}, {1, kMaxPictureSide}}) {
    Drawing drawing;
    drawing.rectangle({-32768, -32768}, {32768, 32768}, {0, 0}, {0, 0}, kWhite);
    drawing.triangle(vertex(-32768, -32768, IM_COL32(9, 9, 9, 255)),
                     vertex(32768, -32768, IM_COL32(9, 9, 9, 255)),
                     vertex(32768, 32768, IM_COL32(9, 9, 9, 255)));
    drawing.command();
    const Image picture = drawing.painted(Image(width, height));
    for (int y = 0; y < height; y += 1023)
      for (int x = 0; x < width; x += 1023)
        ASSERT_EQ(picture.at(x, y).r, x >= y ? 9 : 255) << x << ',' << y;
  }
}

}  // namespace
}  // namespace hearth
