#include "image/image_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <string>
#include <vector>

#include "support/in_tree.h"

namespace hearth {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::int64_t kMaxPixels = 1 << 20;

class ImageFile : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path path(const std::string& name) const { return folder_ / name; }

  std::filesystem::path fileOf(const std::string& name, const Bytes& bytes) const {
    std::ofstream(path(name), std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    return path(name);
  }

  static Bytes bytesOf(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return Bytes(std::istreambuf_iterator<char>(stream), {});
  }

  /// A picture in which every row, column and channel differs from its neighbours.
  static Image ramp(int width, int height) {
    Image image(width, height);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        image.at(x, y) = {static_cast<std::uint8_t>(7 * x), static_cast<std::uint8_t>(11 * y),
                          static_cast<std::uint8_t>(x + 3 * y)};
      }
    }
    return image;
  }

 private:
  std::filesystem::path folder_ = std::filesystem::temp_directory_path() /
                                  ("hearth_image_file_test." + std::to_string(getpid()));
};

void append(Bytes& bytes, std::uint32_t bigEndian) {
  for (const int shift : {24, 16, 8, 0}) {
    bytes.push_back(static_cast<std::uint8_t>(bigEndian >> shift));
  }
}

std::uint32_t crc32(const Bytes& bytes, std::size_t begin) {
  std::uint32_t crc = ~std::uint32_t{0};
  for (std::size_t i = begin; i < bytes.size(); ++i) {
    crc ^= bytes[i];
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xEDB88320U : 0U);
  }
  return ~crc;
}

void appendChunk(Bytes& png, const std::string& kind, const Bytes& data) {
  append(png, static_cast<std::uint32_t>(data.size()));
  const std::size_t begin = png.size();
  png.insert(png.end(), kind.begin(), kind.end());
  png.insert(png.end(), data.begin(), data.end());
  append(png, crc32(png, begin));
}

/// A PNG of one stored (uncompressed) block; `rows` hold a filter byte 0 each before their pixels.
Bytes png(std::uint32_t width, std::uint32_t height, std::uint8_t depth, std::uint8_t colourType,
          const Bytes& rows) {
  Bytes header;
  append(header, width);
  append(header, height);
  header.insert(header.end(), {depth, colourType, 0, 0, 0});

  const auto low = static_cast<std::uint8_t>(rows.size() & 0xFF);
  const auto high = static_cast<std::uint8_t>(rows.size() >> 8);
  Bytes data{0x78,
             0x01,
             0x01,
             low,
             high,
             static_cast<std::uint8_t>(~low),
             static_cast<std::uint8_t>(~high)};
  data.insert(data.end(), rows.begin(), rows.end());
  std::uint32_t a = 1;
  std::uint32_t b = 0;
  for (const std::uint8_t byte : rows) {
    a = (a + byte) % 65521;
    b = (b + a) % 65521;
  }
  append(data, b << 16 | a);

  Bytes bytes{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  appendChunk(bytes, "IHDR", header);
  appendChunk(bytes, "IDAT", data);
  appendChunk(bytes, "IEND", {});
  return bytes;
}

TEST_F(ImageFile, ReadsBackWhatItWrote) {
  const Image image = ramp(13, 7);
  ASSERT_TRUE(writePng(path("a.png"), image));
  const auto read = readImage(path("a.png"), kMaxPixels);
  ASSERT_TRUE(read) << read.error();
  EXPECT_EQ(*read, image);
}

TEST_F(ImageFile, WritesTheSameBytesForTheSamePicture) {
  ASSERT_TRUE(writePng(path("a.png"), ramp(64, 32)));
  ASSERT_TRUE(writePng(path("b.png"), ramp(64, 32)));
  EXPECT_EQ(bytesOf(path("a.png")), bytesOf(path("b.png")));
}

TEST_F(ImageFile, ReplacesAnOlderFileAndLeavesNothingBeside) {
  fileOf("a.png", {1, 2, 3});
  ASSERT_TRUE(writePng(path("a.png"), ramp(2, 2)));
  EXPECT_TRUE(readImage(path("a.png"), kMaxPixels));
  EXPECT_FALSE(std::filesystem::exists(path("a.png.tmp")));
}

TEST_F(ImageFile, SaysWhichFileCouldNotBeWritten) {
  const auto written = writePng(path("no_such_folder/a.png"), ramp(2, 2));
  ASSERT_FALSE(written);
  EXPECT_NE(written.error().find("no_such_folder/a.png"), std::string::npos) << written.error();
}

TEST_F(ImageFile, RefusesToReplaceWhatIsNoFile) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  std::filesystem::create_directory(path("folder"));
  for (const char* name : {"pipe", "folder"}) {
    const auto written = writePng(path(name), ramp(2, 2));
    ASSERT_FALSE(written) << name;
    EXPECT_NE(written.error().find("not a regular file"), std::string::npos) << written.error();
  }
  EXPECT_TRUE(std::filesystem::is_fifo(path("pipe")));
}

TEST_F(ImageFile, WritesThroughASymbolicLink) {
  fileOf("target.png", {1, 2, 3});
  std::filesystem::create_symlink(path("target.png"), path("link.png"));
  ASSERT_TRUE(writePng(path("link.png"), ramp(2, 2)));
  EXPECT_TRUE(std::filesystem::is_symlink(path("link.png")));
  EXPECT_TRUE(readImage(path("target.png"), kMaxPixels));
}

TEST_F(ImageFile, ReadsTheSizeWithoutDecoding) {
  Bytes bytes = png(5, 3, 8, 0, Bytes(18, 0));
  bytes.resize(40);  // The header alone.
  const auto size = readImageSize(fileOf("a.png", bytes));
  ASSERT_TRUE(size) << size.error();
  EXPECT_EQ(*size, (ImageSize{5, 3}));
}

TEST_F(ImageFile, KeepsTheColoursOfTransparentPixels) {
  const auto image =
      readImage(fileOf("a.png", png(2, 1, 8, 6, {0, 10, 20, 30, 0, 40, 50, 60, 128})), kMaxPixels);
  ASSERT_TRUE(image) << image.error();
  EXPECT_EQ(image->pixels(), (std::vector<Rgb>{{10, 20, 30}, {40, 50, 60}}));
}

TEST_F(ImageFile, HasHolesWhereAlphaIsLessThanHalf) {
  const Bytes rgba{0, 1, 1, 1, 127, 2, 2, 2, 128, 3, 3, 3, 255};
  const auto image = readImage(fileOf("rgba.png", png(3, 1, 8, 6, rgba)), kMaxPixels);
  ASSERT_TRUE(image) << image.error();
  EXPECT_TRUE(image->hasHoles());
  EXPECT_TRUE(image->isHole(0, 0));
  EXPECT_FALSE(image->isHole(1, 0));
  EXPECT_FALSE(image->isHole(2, 0));
  const auto grey = readImage(fileOf("grey.png", png(2, 1, 8, 4, {0, 50, 0, 50, 255})), kMaxPixels);
  ASSERT_TRUE(grey) << grey.error();
  EXPECT_TRUE(grey->isHole(0, 0));
  EXPECT_FALSE(grey->isHole(1, 0));
}

TEST_F(ImageFile, HasNoHolesWithoutAlpha) {
  const auto image = readImage(fileOf("a.png", png(2, 1, 8, 2, {0, 9, 9, 9, 8, 8, 8})), kMaxPixels);
  ASSERT_TRUE(image) << image.error();
  EXPECT_FALSE(image->hasHoles());
  const auto opaque =
      readImage(fileOf("b.png", png(2, 1, 8, 6, {0, 9, 9, 9, 255, 8, 8, 8, 255})), kMaxPixels);
  ASSERT_TRUE(opaque) << opaque.error();
  EXPECT_EQ(*opaque, *image);
}

TEST_F(ImageFile, ReadsBackTheHolesThatItWrote) {
  Image image = ramp(5, 4);
  image.makeHole(3, 0);
  image.makeHole(0, 2);
  ASSERT_TRUE(writePng(path("a.png"), image));
  const auto read = readImage(path("a.png"), kMaxPixels);
  ASSERT_TRUE(read) << read.error();
  EXPECT_EQ(*read, image);
}

TEST_F(ImageFile, CutsSixteenBitsToTheHighByte) {
  const auto image = readImage(
      fileOf("a.png", png(1, 1, 16, 2, {0, 0x12, 0xFF, 0x34, 0x80, 0xFF, 0x00})), kMaxPixels);
  ASSERT_TRUE(image) << image.error();
  EXPECT_EQ(image->at(0, 0), (Rgb{0x12, 0x34, 0xFF}));
}

TEST_F(ImageFile, WidensGrey) {
  const auto grey8 = readImage(fileOf("8.png", png(2, 1, 8, 0, {0, 7, 200})), kMaxPixels);
  ASSERT_TRUE(grey8) << grey8.error();
  EXPECT_EQ(grey8->pixels(), (std::vector<Rgb>{{7, 7, 7}, {200, 200, 200}}));

  const auto grey1 = readImage(fileOf("1.png", png(2, 1, 1, 0, {0, 0x40})), kMaxPixels);
  ASSERT_TRUE(grey1) << grey1.error();
  EXPECT_EQ(grey1->pixels(), (std::vector<Rgb>{{0, 0, 0}, {255, 255, 255}}));
}

TEST_F(ImageFile, ReadsAPngWhoseFirstChunkOfDataIsEmpty) {
  Bytes bytes = png(1, 1, 8, 0, {0, 77});
  constexpr std::ptrdiff_t kHeaderBytes = 8 + 4 + 4 + 13 + 4;  // signature and IHDR
  Bytes empty;
  appendChunk(empty, "IDAT", {});
  bytes.insert(bytes.begin() + kHeaderBytes, empty.begin(), empty.end());
  const auto image = readImage(fileOf("empty.png", bytes), kMaxPixels);
  ASSERT_TRUE(image) << image.error();
  EXPECT_EQ(image->at(0, 0), (Rgb{77, 77, 77}));
}

TEST_F(ImageFile, ReadsBmpAndTgaByContent) {
  const Bytes bmp{'B', 'M', 58, 0, 0, 0, 0, 0, 0, 0, 54, 0, 0, 0,  // file header
                  40,  0,   0,  0, 1, 0, 0, 0, 1, 0, 0,  0, 1, 0,  // size 1 x 1
                  24,  0,   0,  0, 0, 0, 4, 0, 0, 0, 0,  0, 0, 0,  // 24 bits, uncompressed
                  0,   0,   0,  0, 0, 0, 0, 0, 0, 0, 0,  0, 3, 2, 1, 0};
  const auto fromBmp = readImage(fileOf("a.bmp", bmp), kMaxPixels);
  ASSERT_TRUE(fromBmp) << fromBmp.error();
  EXPECT_EQ(fromBmp->at(0, 0), (Rgb{1, 2, 3}));

  const Bytes tga{0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 24, 0, 3, 2, 1};
  const auto fromTga = readImage(fileOf("a.tga", tga), kMaxPixels);
  ASSERT_TRUE(fromTga) << fromTga.error();
  EXPECT_EQ(fromTga->at(0, 0), (Rgb{1, 2, 3}));
}

// Hostile and unlucky input: a message that begins with the path, never more.

struct Refusal {
  std::filesystem::path path;
  std::string expected;  ///< Must occur in the message.
};

void expectRefused(const Refusal& refusal, std::int64_t maxPixels = kMaxPixels) {
  const auto image = readImage(refusal.path, maxPixels);
  ASSERT_FALSE(image) << refusal.path;
  EXPECT_TRUE(image.error().starts_with(refusal.path.string() + ": ")) << image.error();
  EXPECT_NE(image.error().find(refusal.expected), std::string::npos) << image.error();
}

TEST_F(ImageFile, RefusesWhatIsNoPicture) {
  expectRefused({path("missing.png"), "no such file"});
  expectRefused({path(""), "is not a file"});
  expectRefused({fileOf("empty.png", {}), "is not a PNG"});
  expectRefused({fileOf("text.png", {'h', 'e', 'l', 'l', 'o', '\n'}), "is not a PNG"});
}

TEST_F(ImageFile, RefusesATruncatedPngAtEveryLength) {
  ASSERT_TRUE(writePng(path("whole.png"), ramp(20, 20)));
  const Bytes whole = bytesOf(path("whole.png"));
  // The last 16 bytes are the check sum of the pixels and the end mark, which hold no pixel.
  for (std::size_t length = 0; length + 16 < whole.size(); ++length) {
    const auto cut = fileOf(
        "cut.png", Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)));
    EXPECT_FALSE(readImage(cut, kMaxPixels)) << length << " of " << whole.size() << " bytes";
  }
}

TEST_F(ImageFile, SurvivesEveryFlippedByte) {
  ASSERT_TRUE(writePng(path("whole.png"), ramp(9, 9)));
  const Bytes whole = bytesOf(path("whole.png"));
  for (std::size_t i = 0; i < whole.size(); ++i) {
    Bytes bytes = whole;
    bytes[i] = static_cast<std::uint8_t>(~bytes[i]);
    const auto image = readImage(fileOf("flipped.png", bytes), kMaxPixels);
    EXPECT_TRUE(!image || image->pixels().size() <= std::size_t{kMaxPixels}) << i;
  }
}

/// The start of a JPEG: one Huffman table, whose codes are `eightBits` of 8 bits and as many of 9.
Bytes jpegWithTable(std::uint8_t eightBits, std::uint8_t nineBits) {
  const int symbols = eightBits + nineBits;
  Bytes bytes{0xFF, 0xD8, 0xFF, 0xC4};
  const int length = 2 + 17 + symbols;
  bytes.insert(bytes.end(), {static_cast<std::uint8_t>(length >> 8),
                             static_cast<std::uint8_t>(length & 0xFF), 0x00});
  bytes.insert(bytes.end(), 7, 0);
  bytes.insert(bytes.end(), {eightBits, nineBits});
  bytes.insert(bytes.end(), 7, 0);
  bytes.insert(bytes.end(), static_cast<std::size_t>(symbols), 1);
  return bytes;
}

/// Pixels of a BMP can look like the marks of a JPEG and of its tables.
TEST_F(ImageFile, ReadsABmpWhosePixelsLookLikeAJpegOfTooManySymbols) {
  constexpr int kWidth = 16;
  Bytes bytes = {'B', 'M', 0, 0,      0, 0, 0, 0, 0, 0, 54, 0, 0, 0, 40,
                 0,   0,   0, kWidth, 0, 0, 0, 1, 0, 0, 0,  1, 0, 24};
  bytes.resize(54, 0);
  Bytes pixels(3 * kWidth, 200);
  pixels[0] = 0xFF, pixels[1] = 0xD8, pixels[2] = 0;
  pixels[3] = 0xFF, pixels[4] = 0xC4, pixels[5] = 0;
  bytes.insert(bytes.end(), pixels.begin(), pixels.end());
  const auto image = readImage(fileOf("marks.bmp", bytes), kMaxPixels);
  ASSERT_TRUE(image) << image.error();
  EXPECT_EQ(image->at(0, 0), (Rgb{0, 0xD8, 0xFF}));
  EXPECT_EQ(image->at(1, 0), (Rgb{0, 0xC4, 0xFF}));
}

TEST_F(ImageFile, RefusesAJpegOfTooManyHuffmanSymbols) {
  for (const auto& [eightBits, nineBits] :
       {std::pair<std::uint8_t, std::uint8_t>{0, 255}, {1, 255}, {255, 255}}) {
    const bool isSound = eightBits + nineBits <= 255;
    Bytes bytes = jpegWithTable(eightBits, nineBits);
    const Bytes header = {0xFF, 0xC0, 0, 11, 8, 0, 8, 0, 8, 1, 1, 0x11, 0};  // 8 x 8 grey pixels
    bytes.insert(bytes.end(), header.begin(), header.end());
    const auto size = readImageSize(fileOf("table.jpg", bytes));
    EXPECT_EQ(size.has_value(), isSound);
    EXPECT_FALSE(readImage(path("table.jpg"), kMaxPixels));
    if (size) continue;
    EXPECT_NE(size.error().find("is damaged"), std::string::npos) << size.error();
  }
}

TEST_F(ImageFile, RefusesAJpegThatEndsWithinTheCountsOfSuchATable) {
  Bytes bytes = jpegWithTable(1, 255);
  bytes.resize(16);  // up to the count of codes of 9 bits
  const auto size = readImageSize(fileOf("counts.jpg", bytes));
  ASSERT_FALSE(size);
  EXPECT_NE(size.error().find("is damaged"), std::string::npos) << size.error();
}

TEST_F(ImageFile, ReadsAJpegWithoutItsTablesTheSameEachTime) {
  Bytes bytes = bytesOf(test::inTree("tests/image/baseline.jpg"));
  // Its scan names the tables of number 3, which it does not give.
  const Bytes scan = {0xFF, 0xDA, 0x00, 0x0C, 0x03};
  const auto at = std::search(bytes.begin(), bytes.end(), scan.begin(), scan.end());
  ASSERT_NE(at, bytes.end());
  for (int component = 0; component < 3; ++component) at[6 + 2 * component] = 0x33;
  const auto first = readImage(fileOf("tables.jpg", bytes), kMaxPixels);
  for (int i = 0; i < 3; ++i) {
    const auto again = readImage(path("tables.jpg"), kMaxPixels);
    ASSERT_EQ(first.has_value(), again.has_value());
    if (first) {
      EXPECT_EQ(*first, *again);
    }
  }
}

TEST_F(ImageFile, RefusesAJpegThatEndsWithinAnApplicationSegment) {
  // The name of the segment is cut short, and what follows it is skipped after that.
  const Bytes bytes{0xFF, 0xD8, 0xFF, 0xE0, 0, 16, 'J', 'F', 'I'};
  EXPECT_FALSE(readImageSize(fileOf("cut.jpg", bytes)));
  EXPECT_FALSE(readImage(path("cut.jpg"), kMaxPixels));
}

TEST_F(ImageFile, ReadsAJpegWhoseScanEndsInANumberTheSameEachTime) {
  const auto file = test::inTree("tests/image/short_scan.jpg");
  const auto first = readImage(file, kMaxPixels);
  for (int i = 0; i < 3; ++i) {
    const auto again = readImage(file, kMaxPixels);
    ASSERT_EQ(first.has_value(), again.has_value());
    if (first) {
      EXPECT_EQ(*first, *again);
    }
  }
}

TEST_F(ImageFile, RefusesAJpegWithSuchATableBetweenItsScans) {
  const auto file = test::inTree("tests/image/baseline.jpg");
  Bytes bytes = bytesOf(file);
  ASSERT_TRUE(readImage(file, kMaxPixels));
  const Bytes table = jpegWithTable(255, 255);
  bytes.insert(bytes.end() - 2, table.begin() + 2, table.end());  // before the end of the image
  EXPECT_TRUE(readImageSize(fileOf("between.jpg", bytes)));
  EXPECT_FALSE(readImage(path("between.jpg"), kMaxPixels));
}

TEST_F(ImageFile, RefusesAHeaderThatClaimsTooManyPixels) {
  expectRefused({fileOf("limit.png", png(1025, 1024, 8, 0, {})), "more than the limit of 1048576"});
  expectRefused({fileOf("2^31.png", png(65536, 32768, 8, 0, {})), "impossible size"});
  expectRefused({fileOf("2^62.png", png(0x7FFFFFFF, 0x7FFFFFFF, 8, 0, {})), "impossible size"});
  expectRefused({fileOf("zero.png", png(0, 5, 8, 0, {})), "is not a PNG"});
}

TEST_F(ImageFile, RefusesAHeaderThatItsLengthCannotMatch) {
  expectRefused({fileOf("short.png", png(16384, 16384, 8, 0, {})), "cannot hold"},
                std::int64_t{1} << 40);
  Bytes padded = png(1, 1, 8, 0, {0, 0});
  padded.resize(std::size_t{5} << 20);
  expectRefused({fileOf("long.png", padded), "do not need"});
}

TEST_F(ImageFile, AcceptsExactlyTheLimit) {
  const auto path = fileOf("a.png", png(3, 2, 8, 0, {0, 1, 2, 3, 0, 4, 5, 6}));
  EXPECT_TRUE(readImage(path, 6));
  EXPECT_FALSE(readImage(path, 5));
}

}  // namespace
}  // namespace hearth
