// Bytes of a fuzzer as a picture: each is refused with a message, or is a picture of the size that
// its header says, within the limit.

#include "image/image_file.h"
#include "math/check.h"
#include "scratch_folder.h"

namespace {

constexpr std::int64_t kMaxPixels = 1 << 18;

void tryOut(const std::filesystem::path& file) {
  const auto size = hearth::readImageSize(file);
  const auto image = hearth::readImage(file, kMaxPixels);
  CHECK(size ? size->width > 0 && size->height > 0 : !size.error().empty());
  if (!image) {
    CHECK(!image.error().empty());
    return;
  }
  CHECK(size && image->width() == size->width && image->height() == size->height);
  CHECK(std::int64_t{image->width()} * image->height() <= kMaxPixels);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const hearth::fuzz::ScratchFolder folder;
  tryOut(folder.write("image", hearth::fuzz::asText(data, size)));
  return 0;
}
