#include "files/file_source.h"

#include <cerrno>
#include <fstream>
#include <system_error>
#include <utility>

namespace hearth {

namespace fs = std::filesystem;

FileKind DiskFiles::kindOf(const fs::path& path) const {
  std::error_code ignored;  // what cannot be asked about does not exist for us
  switch (fs::status(path, ignored).type()) {
    case fs::file_type::regular:
      return FileKind::Regular;
    case fs::file_type::directory:
      return FileKind::Folder;
    case fs::file_type::none:
    case fs::file_type::not_found:
      return FileKind::None;
    default:
      return FileKind::Other;
  }
}

tl::expected<std::string, ReadError> DiskFiles::read(const fs::path& path,
                                                     std::uint64_t maxBytes) const {
  return readFile(path, maxBytes);
}

/// Opens only regular files: reading a folder fails late, and reading a pipe may wait for ever.
tl::expected<std::unique_ptr<std::istream>, ReadError> DiskFiles::open(const fs::path& path) const {
  std::error_code error;
  const fs::file_type type = fs::status(path, error).type();
  if (type == fs::file_type::not_found) return readErrorFromErrno(ENOENT);
  if (error) return readErrorFromErrno(error.value());
  if (type != fs::file_type::regular)
    return tl::make_unexpected(ReadError{ReadErrorCode::NotRegular, "not a regular file"});
  errno = 0;
  auto file = std::make_unique<std::ifstream>(path, std::ios::binary);
  if (!*file) return readErrorFromErrno(errno);
  return file;
}

std::vector<fs::path> DiskFiles::namesIn(const fs::path& folder) const {
  std::vector<fs::path> names;
  std::error_code ignored;
  for (fs::directory_iterator entry(folder, ignored), end; !ignored && entry != end;
       entry.increment(ignored))
    names.push_back(entry->path().filename());
  return names;
}

}  // namespace hearth
