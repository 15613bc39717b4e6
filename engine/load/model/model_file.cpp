#include "load/model/model_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "load/model/model_text.h"
#include "load/read_advice.h"
#include "load/suggest.h"

namespace hearth {

namespace {

namespace fs = std::filesystem;

tl::unexpected<ModelFileMistake> fileMistake(std::string message, std::string_view advice) {
  return tl::make_unexpected(ModelFileMistake{std::move(message), std::string(advice)});
}

/// The file beside it that a name is a slip of.
std::optional<fs::path> fileWithNearlyTheNameOf(const fs::path& path, const FileSource& files) {
  const fs::path folder = path.parent_path();
  std::vector<std::string> names;
  for (const fs::path& name : files.namesIn(folder.empty() ? "." : folder))
    if (name.extension() == path.extension()) names.push_back(name.string());
  std::ranges::sort(names);
  const std::vector<std::string_view> views(names.begin(), names.end());
  const auto nearest = nearestName(path.filename().string(), views);
  return nearest ? std::optional(folder / *nearest) : std::nullopt;
}

std::string adviceOnModelFile(const ReadError& failure, const fs::path& path,
                              const FileSource& files, std::string_view otherwise) {
  if (failure.code == ReadErrorCode::Missing)
    if (const auto nearest = fileWithNearlyTheNameOf(path, files))
      return fmt::format("did you mean {}?", nearest->string());
  return std::string(adviceOn(failure.code, otherwise));
}

}  // namespace

tl::expected<std::string, ModelFileMistake> readModelText(const FileSource& files,
                                                          const fs::path& path,
                                                          std::uint64_t maxBytes,
                                                          std::string_view otherwise) {
  constexpr std::uint64_t kMaxLines = 0xFFFFFFFE;  // ModelLine::number has 32 bits
  if (path.native().find('\0') != std::string::npos) return fileMistake("no such file", otherwise);
  auto text = files.read(path, std::min(maxBytes, kMaxLines));
  if (!text)
    return fileMistake(text.error().what, adviceOnModelFile(text.error(), path, files, otherwise));
  if (text->find('\0') != std::string::npos)
    return fileMistake("not a text: it has zero bytes", "save it as UTF-8");
  return *std::move(text);
}

tl::expected<fs::path, ModelFileMistake> pathOfNamed(std::string_view name, const fs::path& by) {
  constexpr std::size_t kMaxBytes = 4096;  // PATH_MAX of Linux
  if (name.size() > kMaxBytes)
    return fileMistake(fmt::format("the name \"{}\" has {} bytes", shortened(name), name.size()),
                       fmt::format("give the file a name of at most {}", kMaxBytes));
  std::string path(name);
  std::ranges::replace(path, '\\', '/');
  return by.parent_path() / path;
}

}  // namespace hearth
