#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "load/model/read_model.h"

namespace hearth {

/// Collects what is wrong with one file of a model, and what of it is left out.
class ModelReport {
 public:
  /// More errors than this in one file help nobody.
  static constexpr std::size_t kMaxErrors = 20;

  explicit ModelReport(std::filesystem::path file) : file_(std::move(file)) {}

  /// Lines count from 1; 0 stands for the file as a whole.
  void error(std::uint32_t line, std::string message, std::string advice);
  void warning(std::uint32_t line, std::string message, std::string advice);
  /// A statement that says nothing to us: one message tells all of a file's keywords.
  void leaveOut(std::string_view keyword, std::uint32_t line);

  bool hasErrors() const { return errors_ > 0; }
  /// Once full, the rest of the file is not worth reading.
  bool isFull() const { return errors_ > kMaxErrors; }

  /// In the order of lines. `read` are the keywords that are not left out, in words.
  std::vector<ModelMistake> mistakes(std::string_view read) const;

 private:
  struct LeftOut {
    std::string keyword;
    std::uint32_t line;  ///< the first one
  };

  void add(std::uint32_t line, bool isError, std::string message, std::string advice);

  std::filesystem::path file_;
  std::vector<ModelMistake> mistakes_;
  std::size_t errors_ = 0;
  std::vector<LeftOut> leftOut_;
  bool hasMoreLeftOut_ = false;
};

}  // namespace hearth
