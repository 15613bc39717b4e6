#include "inputs/bake_cache.h"

#include <elf.h>
#include <fmt/format.h>
#include <link.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <string_view>
#include <system_error>
#include <vector>

#include "files/read_file.h"
#include "folders/user_folders.h"
#include "light/light_hash.h"
#include "light/saved_bake.h"
#include "math/hash.h"
#include "settings/settings.h"

namespace hearth {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kBakeExtension = ".bake";
/// Of files that are being written, or that a program left when it was stopped.
constexpr std::string_view kPartExtension = ".tmp";
constexpr std::chrono::hours kPartsOld{1};

std::uint64_t hashOf(std::string_view bytes) {
  Hash hash;
  for (std::size_t i = 0; i < bytes.size(); i += sizeof(std::uint64_t)) {
    std::uint64_t word = 0;
    std::memcpy(&word, &bytes[i], std::min(sizeof word, bytes.size() - i));
    hash.addWhole(word);
  }
  return hash.value();
}

/// The number that the linker makes of a program's bytes (ld --build-id), where it lies in memory;
/// empty where a program has none.
std::string_view buildId(const dl_phdr_info& program) {
  constexpr std::size_t kAlign = 4;  // of the parts of a note
  constexpr std::string_view kOwner("GNU\0", 4);
  for (int i = 0; i < program.dlpi_phnum; ++i) {
    const auto& segment = program.dlpi_phdr[i];
    // Notes of wider alignment are of other kinds.
    if (segment.p_type != PT_NOTE || segment.p_align != kAlign) continue;
    const auto* start = std::bit_cast<const char*>(program.dlpi_addr + segment.p_vaddr);
    std::string_view notes{start, segment.p_memsz};
    ElfW(Nhdr) note;
    while (notes.size() >= sizeof note) {
      std::memcpy(&note, notes.data(), sizeof note);
      const std::size_t nameBytes = (note.n_namesz + kAlign - 1) / kAlign * kAlign;
      const std::size_t idBytes = (note.n_descsz + kAlign - 1) / kAlign * kAlign;
      if (notes.size() < sizeof note + nameBytes + idBytes) break;
      if (note.n_type == NT_GNU_BUILD_ID && notes.substr(sizeof note, note.n_namesz) == kOwner)
        return notes.substr(sizeof note + nameBytes, note.n_descsz);
      notes.remove_prefix(sizeof note + nameBytes + idBytes);
    }
  }
  return {};
}

/// Of the very program that runs. Its file is read only where it has no build id: it may be large.
std::optional<std::uint64_t> hashOfProgram() {
  std::string_view id;
  ::dl_iterate_phdr(
      [](dl_phdr_info* program, std::size_t, void* found) {
        *static_cast<std::string_view*>(found) = buildId(*program);
        return 1;  // the program comes first, and libraries after it
      },
      &id);
  if (!id.empty()) return hashOf(id);
  const auto program = readFile("/proc/self/exe", std::numeric_limits<std::uint64_t>::max());
  if (!program || program->empty()) return std::nullopt;
  return hashOf(*program);
}

bool writeAll(const fs::path& path, const std::string& bytes) {
  std::ofstream out(path, std::ios::binary | std::ios::trunc);
  out.write(bytes.data(), std::ssize(bytes));
  out.close();
  return out.good();
}

struct Entry {
  fs::path path;
  std::uint64_t bytes;
  fs::file_time_type used;
};

/// What the folder holds. Files that vanish meanwhile are left out.
std::vector<Entry> entriesIn(const fs::path& folder, std::string_view extension) {
  std::vector<Entry> entries;
  std::error_code error;
  for (fs::directory_iterator file(folder, error); !error && file != fs::directory_iterator();
       file.increment(error)) {
    if (file->path().extension() != extension) continue;
    std::error_code noFile;
    std::error_code noSize;
    std::error_code noTime;
    const bool isFile = file->is_regular_file(noFile);
    const Entry entry{file->path(), file->file_size(noSize), file->last_write_time(noTime)};
    if (isFile && !noSize && !noTime) entries.push_back(entry);
  }
  return entries;
}

}  // namespace

std::optional<BakeCache> BakeCache::ofUser() {
  const auto folder = cacheFolder();
  const auto program = hashOfProgram();
  if (!folder || !program) return std::nullopt;
  return BakeCache(*folder, *program);
}

fs::path BakeCache::fileOf(const Scene& scene, const BakeSettings& settings) const {
  return folder_ /
         fmt::format("{:016x}{:016x}{}", program_, lightHash(scene, settings), kBakeExtension);
}

std::optional<BakedLight> BakeCache::find(const Scene& scene, const BakeSettings& settings) const {
  const fs::path file = fileOf(scene, settings);
  const auto bytes = readFile(file, maxBytes_);
  if (!bytes) return std::nullopt;
  // However much light it is: baking it would take as much memory.
  auto light = decodeBake(scene, *bytes, std::numeric_limits<std::uint64_t>::max());
  if (!light) return std::nullopt;
  std::error_code error;
  fs::last_write_time(file, fs::file_time_type::clock::now(), error);
  return std::move(*light);
}

void BakeCache::keep(const Scene& scene, const BakeSettings& settings,
                     const BakedLight& light) const {
  const std::string bytes = encodeBake(scene, light, settings.texel, optionsOf(settings));
  if (bytes.size() > maxBytes_) return;
  std::error_code error;
  if (fs::create_directories(folder_, error)) fs::permissions(folder_, fs::perms::owner_all, error);
  const fs::path file = fileOf(scene, settings);
  // Of a name of its own, as another program may be writing the same bake.
  fs::path part = file;
  part += fmt::format(".{}{}", ::getpid(), kPartExtension);
  if (writeAll(part, bytes)) fs::rename(part, file, error);
  fs::remove(part, error);
  makeRoom();
}

void BakeCache::makeRoom() const {
  std::error_code error;
  std::vector<Entry> bakes = entriesIn(folder_, kBakeExtension);
  std::ranges::sort(bakes, std::ranges::greater(), &Entry::used);
  std::uint64_t bytes = 0;
  for (const Entry& bake : bakes) {
    bytes += bake.bytes;
    if (bytes > maxBytes_) fs::remove(bake.path, error);
  }
  const fs::file_time_type old = fs::file_time_type::clock::now() - kPartsOld;
  for (const Entry& part : entriesIn(folder_, kPartExtension))
    if (part.used < old) fs::remove(part.path, error);
}

}  // namespace hearth
