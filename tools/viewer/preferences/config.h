#pragma once

#include <filesystem>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "load/diagnostic.h"
#include "viewer/host/storage.h"
#include "viewer/preferences/preferences.h"

/// The user's file of settings, which tools/README.md describes.
namespace hearth {

struct Config {
  Preferences preferences = {};
  std::vector<Diagnostic> warnings = {};
};

/// What is wrong in the file is told, and the rest of it holds. All is as by default where there is
/// no file.
Config readConfig(Storage& storage, const std::filesystem::path& file);

/// Writes what of `after` differs from `before` into the file, and leaves all else of it to the
/// byte. Makes the file and its folder where they are missing. Errors are one sentence that begins
/// with the path.
tl::expected<void, std::string> writeConfig(Storage& storage, const std::filesystem::path& file,
                                            const Preferences& before, const Preferences& after);

/// The file of a program that may change it.
class ConfigFile {
 public:
  /// `asRead`: the preferences that it holds. Without a name there is no file to write.
  ConfigFile(Storage& storage, std::filesystem::path file, const Preferences& asRead)
      : storage_(storage), file_(std::move(file)), written_(asRead) {}

  /// As `writeConfig` does.
  tl::expected<void, std::string> write(const Preferences& preferences);

 private:
  Storage& storage_;
  std::filesystem::path file_;
  Preferences written_;  ///< as the file has them
};

}  // namespace hearth
