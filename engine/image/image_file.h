#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <tl/expected.hpp>

#include "files/file_source.h"
#include "image/image.h"

namespace hearth {

/// The size of a PNG, JPEG, BMP or TGA picture from the first bytes of its file; nothing is
/// decoded. The content tells the kind, not the name. Errors are one sentence that begins
/// with the path.
tl::expected<ImageSize, std::string> readImageSize(const std::filesystem::path& path,
                                                   const FileSource& files = DiskFiles());

/// Reads a picture as 8-bit RGB: 16 bits are cut to their high byte, grey is widened. Pixels whose
/// alpha is less than half are holes; else alpha is ignored. Pictures of more than `maxPixels` are
/// refused from their header, and so are files whose length cannot match their header; only then is
/// memory taken. A PNG that is cut short is refused; the other kinds may read as black or grey
/// where data is missing. Errors are one sentence that begins with the path.
tl::expected<Image, std::string> readImage(const std::filesystem::path& path,
                                           std::int64_t maxPixels,
                                           const FileSource& files = DiskFiles());

/// Writes a PNG, the same bytes for the same picture, and never half of it: see replaceFile. Only a
/// picture with holes has alpha.
tl::expected<void, std::string> writePng(const std::filesystem::path& path, const Image& image);

/// The same, but not over a file: false where there is one.
tl::expected<bool, std::string> createPng(const std::filesystem::path& path, const Image& image);

}  // namespace hearth
