#pragma once

#include "viewer/host/storage.h"

namespace hearth {

/// The files of this machine.
class Disk : public Storage {
 public:
  tl::expected<std::string, ReadError> read(const std::filesystem::path& file,
                                            std::uint64_t maxBytes) override;
  tl::expected<void, std::string> write(const std::filesystem::path& file,
                                        std::string_view bytes) override;
  void makeFolder(const std::filesystem::path& folder) override;
};

}  // namespace hearth
