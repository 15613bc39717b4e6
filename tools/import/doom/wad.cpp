#include "import/doom/wad.h"

#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "files/read_file.h"

namespace hearth::doom {

namespace {

constexpr std::size_t kWadHeader =
    12;                             // "IWAD" or "PWAD", number of lumps, offset of their directory
constexpr std::size_t kEntry = 16;  // offset of a lump, its length, its name
constexpr std::size_t kName = 8;

Bytes bytesIn(const std::string& content) {
  return {reinterpret_cast<const std::uint8_t*>(content.data()), content.size()};
}

}  // namespace

std::int16_t int16At(Bytes bytes, std::size_t at) {
  return static_cast<std::int16_t>(bytes[at] | bytes[at + 1] << 8);
}

std::int32_t int32At(Bytes bytes, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(bytes[at + i]); };
  return static_cast<std::int32_t>(byte(0) | byte(1) << 8 | byte(2) << 16 | byte(3) << 24);
}

std::string nameAt(Bytes bytes, std::size_t at) {
  std::string name;
  for (const std::uint8_t c : bytes.subspan(at, kName)) {
    if (c == 0) break;
    const bool isPrintable = c >= ' ' && c <= '~';
    name += static_cast<char>(!isPrintable ? '?' : c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
  }
  return name;
}

tl::expected<Wad, std::string> Wad::open(const std::filesystem::path& path,
                                         std::uint64_t maxBytes) {
  auto content = readFile(path, maxBytes);
  if (!content) return tl::unexpected(fmt::format("{}: {}", path.string(), content.error().what));
  Wad wad(std::move(*content));
  if (auto mistake = wad.readDirectory())
    return tl::unexpected(fmt::format("{}: {}", path.string(), *mistake));
  return wad;
}

std::optional<std::string> Wad::readDirectory() {
  const std::string& content = contents_.front();
  const Bytes all = bytesIn(content);
  if (!content.starts_with("IWAD") && !content.starts_with("PWAD"))
    return "not a WAD: it begins with neither IWAD nor PWAD";
  if (all.size() < kWadHeader) return "cut short: its header has 12 bytes";
  const std::int64_t count = int32At(all, 4);
  const std::int64_t directory = int32At(all, 8);
  const auto size = static_cast<std::int64_t>(all.size());
  if (count < 0 || directory < 0 || directory + count * static_cast<std::int64_t>(kEntry) > size)
    return fmt::format("cut short: {} lumps from byte {} on do not fit in {} bytes", count,
                       directory, size);
  for (std::int64_t i = 0; i < count; ++i) {
    const auto entry = static_cast<std::size_t>(directory) + static_cast<std::size_t>(i) * kEntry;
    const std::int64_t begin = int32At(all, entry);
    const std::int64_t length = int32At(all, entry + 4);
    std::string name = nameAt(all, entry + 8);
    if (length < 0 || (length > 0 && (begin < 0 || begin + length > size)))
      return fmt::format("lump {} ({}) lies outside of the file's {} bytes", i, name, size);
    lumps_.push_back({std::move(name), length == 0
                                           ? Bytes{}
                                           : all.subspan(static_cast<std::size_t>(begin),
                                                         static_cast<std::size_t>(length))});
  }
  indexNames();
  return std::nullopt;
}

void Wad::indexNames() {
  for (std::size_t i = 0; i < lumps_.size(); ++i) last_[lumps_[i].name] = i;
}

void Wad::layOver(Wad base) {
  contents_.splice(contents_.begin(), base.contents_);
  lumps_.insert(lumps_.begin(), std::make_move_iterator(base.lumps_.begin()),
                std::make_move_iterator(base.lumps_.end()));
  indexNames();
}

std::optional<std::size_t> Wad::find(std::string_view name) const {
  const auto found = last_.find(std::string(name));
  if (found == last_.end()) return std::nullopt;
  return found->second;
}

Bytes Wad::bytesOf(std::string_view name) const {
  const auto found = find(name);
  return found ? lumps_[*found].bytes : Bytes{};
}

}  // namespace hearth::doom
