#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "level/scene.h"
#include "viewer/host/storage.h"
#include "walk/walker.h"

namespace hearth {

/// A place in a level that a walker can go back to.
struct Bookmark {
  std::string name;
  std::string sector;  ///< of the eye
  Vec3 eye;            ///< metres
  double angle = 0;    ///< degrees
  double pitch = 0;
  double fov = 90;
  bool isFlying = false;

  friend bool operator==(const Bookmark&, const Bookmark&) = default;
};

/// Where the walker is, to the millimetre and a hundredth of a degree, so that it can be read.
/// Where the sector ends within a millimetre it is the very place.
Bookmark bookmarkOf(const Scene& scene, const Walker& walker, double fov, std::string name);

/// The walker at a bookmark; the error names what the level no longer has.
tl::expected<Walker, std::string> walkerAt(const Scene& scene, const Bookmark& bookmark);

/// The bookmarks of a level, in a file of the program's own.
class Bookmarks {
 public:
  /// In no file: they end with the program.
  Bookmarks() = default;
  /// As far as the file can be read.
  Bookmarks(Storage& storage, std::filesystem::path file);

  const std::vector<Bookmark>& all() const { return all_; }
  const Bookmark* find(std::string_view name) const;
  /// `place-1`, `place-2`: the first that is free.
  std::string freeName() const;

  /// Replaces one of the same name. Errors, also below, say that the file cannot be written; the
  /// bookmark then exists until the program ends.
  tl::expected<void, std::string> add(Bookmark bookmark);
  tl::expected<void, std::string> remove(std::string_view name);

 private:
  tl::expected<void, std::string> write() const;

  Storage* storage_ = nullptr;  ///< of the file; none without one
  std::filesystem::path file_;
  std::vector<Bookmark> all_;
};

}  // namespace hearth
