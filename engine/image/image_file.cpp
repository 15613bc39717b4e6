#include "image/image_file.h"

#include <fmt/format.h>
#include <zlib.h>

#include <cstdlib>
#include <limits>
#include <memory>
#include <optional>
#include <ostream>
#include <vector>

#include "files/replace_file.h"
#include "image/jpeg_check.h"
#include "math/check.h"

namespace hearth {
namespace {

/// The most bytes that the decoder may ask for at once: 64 million pixels of four 16-bit channels,
/// and the filter byte of each row. The decoder's buffer grows with what a PNG unpacks to, whatever
/// its header says. The limit stops it.
constexpr std::size_t kMaxDecoderBytes = (std::size_t{512} + 64) << 20;

/// The memory is zeroed: stb decodes scans of JPEGs with tables that the file may have left out.
void* boundedMalloc(std::size_t bytes) {
  return bytes <= kMaxDecoderBytes ? std::calloc(1, bytes) : nullptr;
}

void* boundedRealloc(void* old, std::size_t bytes) {
  return bytes <= kMaxDecoderBytes ? std::realloc(old, bytes) : nullptr;
}

/// Deflates the bytes of a PNG for stb. This takes half the time of stb's own compression, and
/// gives four fifths of its bytes. The caller frees the result with std::free. It is null if memory
/// runs out.
unsigned char* deflated(const unsigned char* bytes, int size, int* deflatedSize) {
  constexpr int kLevel = 4;  // higher levels take twice the time to save 3 % of the bytes
  uLongf room = compressBound(static_cast<uLong>(size));
  auto* const memory = static_cast<unsigned char*>(std::malloc(room));
  if (!memory) return nullptr;
  if (compress2(memory, &room, bytes, static_cast<uLong>(size), kLevel) != Z_OK) {
    std::free(memory);
    return nullptr;
  }
  *deflatedSize = static_cast<int>(room);
  return memory;
}

/// The number of channels of its PNG: RGB, and alpha if there are holes.
int channelsOf(const Image& image) { return image.hasHoles() ? 4 : 3; }

/// Why a picture is too large to be written as a PNG; none if it is not.
std::optional<std::string> sizeError(const std::filesystem::path& path, const Image& image) {
  CHECK(image.width() > 0 && image.height() > 0, image.width(), image.height());
  // The encoder counts bytes in `int`. Its buffer is larger than the picture, because data may not
  // compress.
  const std::int64_t bytes = (std::int64_t{channelsOf(image)} * image.width() + 1) * image.height();
  if (bytes <= std::numeric_limits<int>::max() / 4) return std::nullopt;
  return fmt::format("{}: {} x {} pixels are too many for one PNG; write a smaller picture",
                     path.string(), image.width(), image.height());
}

}  // namespace
}  // namespace hearth

// Only the formats of textures, and without the error message that stb keeps in a variable.
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_ONLY_BMP
#define STBI_ONLY_TGA
#define STBI_NO_LINEAR
#define STBI_NO_STDIO
#define STBI_NO_FAILURE_STRINGS
#define STBI_MALLOC(bytes) hearth::boundedMalloc(bytes)
#define STBI_REALLOC(old, bytes) hearth::boundedRealloc(old, bytes)
#define STBI_FREE(memory) std::free(memory)
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#define STBIW_ZLIB_COMPRESS(bytes, size, deflatedSize, quality) \
  hearth::deflated(bytes, size, deflatedSize)
// stb defines static functions that nothing here calls.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace hearth {
namespace {

/// The densest packing of the formats read here: a PNG of one bit per pixel, thus 8 pixels a byte.
/// Deflate packs at most 1032 bytes into one (258 bytes into two bits).
constexpr std::int64_t kMaxPixelsPerByte = std::int64_t{8} * 1032;

/// More than any real file needs. The deepest pixel has 8 bytes, and some pixels do not compress.
constexpr std::int64_t kMaxBytesPerPixel = 16;
/// Room for what a file may hold beside its pixels: colour profile, preview, comments.
constexpr std::int64_t kMaxExtraBytes = std::int64_t{4} << 20;

constexpr const char* kDamaged =
    "is damaged, cut short or too large to decode; save it anew as PNG of 8 bits a channel";

int readSome(void* file, char* bytes, int size) {
  auto* const stream = static_cast<std::istream*>(file);
  stream->read(bytes, size);
  return static_cast<int>(stream->gcount());
}

void skip(void* file, int bytes) {
  auto* const stream = static_cast<std::istream*>(file);
  stream->clear();  // a stream that has failed at its end cannot seek
  stream->seekg(bytes, std::ios::cur);
  // seekg clears the mark that the end was reached, and peek sets it again. Without the mark, stb
  // never notices the end and loops forever.
  stream->peek();
}

int atEnd(void* file) { return static_cast<std::istream*>(file)->good() ? 0 : 1; }

/// The functions through which stb reads a file. Not a constant: the loader of the system would
/// write its addresses, and the engine has no writable data.
stbi_io_callbacks fileCallbacks() { return {readSome, skip, atEnd}; }

struct PixelsFree {
  void operator()(stbi_uc* pixels) const { stbi_image_free(pixels); }
};

tl::unexpected<std::string> failure(const std::filesystem::path& path, const std::string& what) {
  return tl::make_unexpected(fmt::format("{}: {}", path.string(), what));
}

using File = std::unique_ptr<std::istream>;

tl::expected<File, std::string> open(const FileSource& files, const std::filesystem::path& path) {
  return files.open(path).map_error([&](const ReadError& failed) {
    std::string what = failed.what;
    if (failed.code == ReadErrorCode::Missing)
      what = "there is no such file; check the path and its spelling";
    if (failed.code == ReadErrorCode::NotRegular)
      what = "is not a file; give the path of a picture";
    return fmt::format("{}: {}", path.string(), what);
  });
}

std::uint64_t fileSize(std::istream& file) {
  file.clear();  // small files have been read to their end
  file.seekg(0, std::ios::end);
  const std::streamoff bytes = file.tellg();
  return bytes < 0 ? 0 : static_cast<std::uint64_t>(bytes);
}

tl::expected<ImageSize, std::string> sizeOf(std::istream& file, const std::filesystem::path& path) {
  if (!hasSafeHuffmanTables(file, JpegPart::Header)) return failure(path, kDamaged);
  ImageSize size;
  int channels = 0;
  const stbi_io_callbacks callbacks = fileCallbacks();
  const int known =
      stbi_info_from_callbacks(&callbacks, &file, &size.width, &size.height, &channels);
  if (known == 0 || size.width <= 0 || size.height <= 0) {
    return failure(path,
                   "is not a PNG, JPEG, BMP or TGA picture, or its header is damaged or claims an "
                   "impossible size; save it anew as PNG");
  }
  return size;
}

/// Refuses sizes that are too large or cannot be true, before any memory is taken.
tl::expected<void, std::string> checkSize(ImageSize size, std::uint64_t fileBytes,
                                          std::int64_t maxPixels,
                                          const std::filesystem::path& path) {
  const std::int64_t pixels = std::int64_t{size.width} * size.height;
  if (pixels > maxPixels) {
    return failure(path, fmt::format("has {} x {} pixels, more than the limit of {}; make it "
                                     "smaller or raise the limit",
                                     size.width, size.height, maxPixels));
  }
  const bool tooShort =
      fileBytes < static_cast<std::uint64_t>((pixels - 1) / kMaxPixelsPerByte + 1);
  const bool tooLong =
      fileBytes > static_cast<std::uint64_t>(pixels) * kMaxBytesPerPixel + kMaxExtraBytes;
  if (tooShort || tooLong) {
    return failure(path,
                   fmt::format("claims {} x {} pixels, which its {} bytes cannot hold or do not "
                               "need; save it anew",
                               size.width, size.height, fileBytes));
  }
  return {};
}

/// `rgba` holds four bytes a pixel, row by row from the top.
Image fromBytes(ImageSize size, const stbi_uc* rgba) {
  constexpr stbi_uc kHalf = 128;
  Image image(size.width, size.height);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x, rgba += 4) {
      image.at(x, y) = {rgba[0], rgba[1], rgba[2]};
      if (rgba[3] < kHalf) image.makeHole(x, y);
    }
  }
  return image;
}

std::vector<std::uint8_t> toBytes(const Image& image) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(image.pixels().size() * static_cast<std::size_t>(channelsOf(image)));
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const Rgb pixel = image.at(x, y);
      bytes.insert(bytes.end(), {pixel.r, pixel.g, pixel.b});
      if (image.hasHoles()) bytes.push_back(image.isHole(x, y) ? 0 : 255);
    }
  }
  return bytes;
}

void writeToStream(void* stream, void* data, int size) {
  static_cast<std::ostream*>(stream)->write(static_cast<const char*>(data), size);
}

bool encodePng(std::ostream& stream, const Image& image) {
  const std::vector<std::uint8_t> bytes = toBytes(image);
  const int channels = channelsOf(image);
  return stbi_write_png_to_func(writeToStream, &stream, image.width(), image.height(), channels,
                                bytes.data(), channels * image.width()) != 0;
}

}  // namespace

tl::expected<ImageSize, std::string> readImageSize(const std::filesystem::path& path,
                                                   const FileSource& files) {
  const auto file = open(files, path);
  if (!file) return tl::make_unexpected(file.error());
  return sizeOf(**file, path);
}

tl::expected<Image, std::string> readImage(const std::filesystem::path& path,
                                           std::int64_t maxPixels, const FileSource& files) {
  const auto file = open(files, path);
  if (!file) return tl::make_unexpected(file.error());
  const auto size = sizeOf(**file, path);
  if (!size) return tl::make_unexpected(size.error());
  if (const auto checked = checkSize(*size, fileSize(**file), maxPixels, path); !checked) {
    return tl::make_unexpected(checked.error());
  }

  if (!hasSafeHuffmanTables(**file, JpegPart::All)) return failure(path, kDamaged);
  const stbi_io_callbacks callbacks = fileCallbacks();
  ImageSize decoded;
  int channels = 0;
  const std::unique_ptr<stbi_uc, PixelsFree> rgba(stbi_load_from_callbacks(
      &callbacks, file->get(), &decoded.width, &decoded.height, &channels, 4));
  if (!rgba || decoded != *size) {
    return failure(path, kDamaged);
  }
  return fromBytes(decoded, rgba.get());
}

tl::expected<void, std::string> writePng(const std::filesystem::path& path, const Image& image) {
  if (auto mistake = sizeError(path, image)) return tl::make_unexpected(*mistake);
  return replaceFile(path, [&](std::ostream& stream) { return encodePng(stream, image); });
}

tl::expected<bool, std::string> createPng(const std::filesystem::path& path, const Image& image) {
  if (auto mistake = sizeError(path, image)) return tl::make_unexpected(*mistake);
  return createFile(path, [&](std::ostream& stream) { return encodePng(stream, image); });
}

}  // namespace hearth
