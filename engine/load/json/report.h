#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "load/diagnostic.h"
#include "load/json/document.h"

namespace hearth {

/// A place as people and editors name it.
struct FileLocation {
  std::string file;     ///< as messages name it
  int line = 1;         ///< from 1
  int column = 1;       ///< from 1, in bytes
  std::string pointer;  ///< JSON pointer (RFC 6901) of the value
};
FileLocation locationOf(Place place, std::span<const Document> documents);

/// Collects what is wrong with the files of a load, from all its stages.
class Report {
 public:
  /// More errors than this, or warnings, help nobody; a last message says how many were left out.
  static constexpr std::size_t kMaxMessages = 500;

  void error(Place place, std::string message, std::string advice);
  void warning(Place place, std::string message, std::string advice, std::string_view kind);
  /// Takes over the errors of another report; their messages begin with `where`.
  void addErrors(const Report& other, std::string_view where);
  bool hasErrors() const { return errors_ > 0; }
  /// Once full, the text of an error is not worth working out.
  bool isFull() const { return errors_ >= kMaxMessages; }

  /// In the order of the files and of the places in them.
  std::vector<Diagnostic> resolve(std::span<const Document> documents) const;

 private:
  struct Entry {
    Place place;
    bool isError;
    std::string message;
    std::string advice;
    std::string kind;
  };

  std::vector<Entry> entries_;
  std::size_t errors_ = 0;
  std::size_t warnings_ = 0;
};

}  // namespace hearth
