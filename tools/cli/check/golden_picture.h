#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "image/image.h"
#include "level/level.h"

/// Pictures that were looked at and kept, one per shot of a level.
namespace hearth {

/// The folders of a level's pictures.
struct GoldenFolders {
  std::filesystem::path golden;  ///< `NAME.golden`: `SHOT.png` for every shot
  std::filesystem::path failed;  ///< `NAME.failed` beside it: what a failed check leaves
};

/// Beside the level file, or in `root`. The name is the file's without `.json`. That of a model
/// keeps its `.obj`: a level of the same stem may stand beside it.
GoldenFolders goldenFolders(const std::filesystem::path& level,
                            const std::optional<std::string>& root);

/// Whether a shot's name can name a file: not hidden, in no other folder.
bool isFileName(std::string_view name);

/// `folder`/`name``ending`.
std::filesystem::path pictureFile(const std::filesystem::path& folder, std::string_view name,
                                  std::string_view ending = ".png");

/// How a picture compares with its golden one.
enum class Verdict { Same, Differs, OtherSize, Missing, Unreadable };

struct Comparison {
  Verdict verdict;
  std::string words;            ///< figures or reason, a sentence without its full stop
  std::optional<Image> golden;  ///< where it differs
};

/// Every pixel counts. A golden picture of another size is not even decoded.
Comparison compareWithGolden(const std::filesystem::path& golden, const Image& drawn);

/// Names of the golden pictures that no shot draws, sorted.
std::vector<std::string> staleGoldens(const std::filesystem::path& folder,
                                      const std::vector<Shot>& shots);

}  // namespace hearth
