#pragma once

#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <istream>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "files/file_source.h"

namespace hearth::test {

/// Files that lie in memory.
class MemoryFiles final : public FileSource {
 public:
  void add(const std::filesystem::path& path, std::string bytes) {
    files_[path] = std::move(bytes);
  }
  void remove(const std::filesystem::path& path) { files_.erase(path); }
  std::string& at(const std::filesystem::path& path) { return files_.at(path); }

  FileKind kindOf(const std::filesystem::path& path) const override {
    if (find(path)) return FileKind::Regular;
    return namesIn(path).empty() ? FileKind::None : FileKind::Folder;
  }
  tl::expected<std::string, ReadError> read(const std::filesystem::path& path,
                                            std::uint64_t maxBytes) const override {
    const std::string* bytes = find(path);
    if (!bytes) return readErrorFromErrno(ENOENT);
    if (bytes->size() > maxBytes)
      return tl::make_unexpected(ReadError{ReadErrorCode::TooLong, "too long"});
    return *bytes;
  }
  tl::expected<std::unique_ptr<std::istream>, ReadError> open(
      const std::filesystem::path& path) const override {
    const std::string* bytes = find(path);
    if (!bytes) return readErrorFromErrno(ENOENT);
    return std::make_unique<std::istringstream>(*bytes);
  }
  std::vector<std::filesystem::path> namesIn(const std::filesystem::path& folder) const override {
    std::vector<std::filesystem::path> names;
    for (const auto& [path, bytes] : files_)
      if (path.parent_path() == folder.lexically_normal()) names.push_back(path.filename());
    return names;
  }

 private:
  const std::string* find(const std::filesystem::path& path) const {
    const auto found = files_.find(path.lexically_normal());
    return found == files_.end() ? nullptr : &found->second;
  }

  std::map<std::filesystem::path, std::string> files_;
};

}  // namespace hearth::test
