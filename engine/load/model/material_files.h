#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "files/file_source.h"
#include "load/limits.h"
#include "load/model/model_report.h"
#include "load/model/model_text.h"
#include "load/model/read_model.h"

namespace hearth {

/// The materials of the MTL files that a model names (Alias|Wavefront, "The Material Template
/// Library", version 1.0).
class MaterialFiles {
 public:
  /// Mistakes in `model`'s own statements go to its report. All arguments must outlive this.
  MaterialFiles(const std::filesystem::path& model, ModelReport& report, const LoadLimits& limits,
                const FileSource& files);

  /// Reads the files of an `mtllib`, but none twice.
  void read(const ModelLine& line);

  /// The material of a `usemtl`, as an index of `used()`. None if it is not known, which is
  /// reported unless a file could not be read.
  std::optional<std::uint32_t> use(const ModelLine& line);

  /// Those that the model uses, in the order in which it begins to.
  std::vector<ModelMaterial>& used() { return used_; }
  const std::vector<std::filesystem::path>& filesRead() const { return filesRead_; }

  /// Of the files that were read.
  bool hasErrors() const;
  std::vector<ModelMistake> mistakes() const;

 private:
  struct Entry {
    ModelMaterial material;               ///< taken away once it is used
    std::optional<std::uint32_t> usedAs;  ///< index
  };

  bool readFile(std::string_view name, std::uint32_t line);
  void readMaterials(const std::filesystem::path& path, std::string_view text);
  ModelMaterial& begin(const ModelLine& line, ModelReport& report);
  void reportUnknown(const ModelLine& line);

  const std::filesystem::path& model_;
  ModelReport& report_;
  const FileSource& source_;
  std::uint64_t bytesLeft_;  ///< of the limit, for all files together
  bool isComplete_ = true;   ///< all files could be read to their ends

  std::set<std::string, std::less<>> names_;  ///< of the files, as the model names them
  std::map<std::string, Entry, std::less<>> materials_;
  std::vector<ModelMaterial> used_;
  std::vector<std::filesystem::path> filesRead_;
  std::deque<ModelReport> reports_;  ///< by file that was read
};

}  // namespace hearth
