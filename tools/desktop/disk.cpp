#include "desktop/disk.h"

#include <ostream>
#include <system_error>

#include "files/replace_file.h"

namespace hearth {

tl::expected<std::string, ReadError> Disk::read(const std::filesystem::path& file,
                                                std::uint64_t maxBytes) {
  return readFile(file, maxBytes);
}

tl::expected<void, std::string> Disk::write(const std::filesystem::path& file,
                                            std::string_view bytes) {
  return replaceFile(file, [bytes](std::ostream& stream) {
    stream << bytes;
    return stream.good();
  });
}

void Disk::makeFolder(const std::filesystem::path& folder) {
  std::error_code ignored;
  std::filesystem::create_directories(folder, ignored);
}

}  // namespace hearth
