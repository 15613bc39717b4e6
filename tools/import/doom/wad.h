#pragma once

#include <cstdint>
#include <filesystem>
#include <list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <unordered_map>
#include <vector>

namespace hearth::doom {

using Bytes = std::span<const std::uint8_t>;

/// The number of a WAD at `at` in `bytes`, lowest byte first.
std::int16_t int16At(Bytes bytes, std::size_t at);
std::int32_t int32At(Bytes bytes, std::size_t at);
/// A name of a WAD: eight bytes, filled up with zeros; in upper case. Characters
/// that cannot be printed become '?', because names appear in messages.
std::string nameAt(Bytes bytes, std::size_t at);

/// The archive in which Doom and related games keep maps, pictures and sounds: named lumps whose
/// order matters (https://doomwiki.org/wiki/WAD).
class Wad {
 public:
  struct Lump {
    std::string name;  ///< in upper case
    Bytes bytes;
  };

  /// Errors are one sentence that begins with the path.
  static tl::expected<Wad, std::string> open(const std::filesystem::path& path,
                                             std::uint64_t maxBytes);

  Wad(Wad&&) = default;
  Wad& operator=(Wad&&) = default;
  Wad(const Wad&) = delete;  // lumps lie in the content
  Wad& operator=(const Wad&) = delete;

  /// Puts the lumps of another WAD before these. Lumps of this one override them.
  void layOver(Wad base);

  const std::vector<Lump>& lumps() const { return lumps_; }
  /// The last lump of that name (in upper case), as later ones take the place of earlier ones.
  std::optional<std::size_t> find(std::string_view name) const;
  /// The bytes of a lump; empty if there is none.
  Bytes bytesOf(std::string_view name) const;

 private:
  explicit Wad(std::string content) { contents_.push_back(std::move(content)); }
  std::optional<std::string> readDirectory();
  void indexNames();

  std::list<std::string> contents_;  ///< of the files; they stay where they are in memory
  std::vector<Lump> lumps_;
  std::unordered_map<std::string, std::size_t> last_;
};

}  // namespace hearth::doom
