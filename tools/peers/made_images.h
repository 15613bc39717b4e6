#pragma once

#include <filesystem>
#include <string>
#include <tl/expected.hpp>

namespace hearth {

/// Writes images for levels that rows make:
/// - paint.png and plaster.png, 256x256 pixels. Neighbouring pixels differ by few levels.
/// - disc.png, 64x64 pixels: a disc with round holes. Six of ten pixels show.
/// The folder is made if it is missing.
tl::expected<void, std::string> writeImages(const std::filesystem::path& folder);

}  // namespace hearth
