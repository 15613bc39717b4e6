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

/// Mistakes in the file become warnings, and the rest of it holds. Without a file, all is as by
/// default.
Config readConfig(Storage& storage, const std::filesystem::path& file);

/// Writes the preferences in which `after` differs from `before`, and leaves every other byte of
/// the file as it is. Makes the file and its folder where they are missing. Errors are one sentence
/// that begins with the path.
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
