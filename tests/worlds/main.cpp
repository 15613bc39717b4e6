#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <mutex>
#include <optional>

#include "import/doom/map.h"
#include "math/parallel.h"
#include "worlds/world.h"

namespace {

using namespace hearth;
using worlds::Archive;
using worlds::World;

struct Task {
  const Archive* archive;
  std::string map;
};

/// None where one cannot be read: then it says so.
std::optional<std::vector<Archive>> openAll(const std::vector<std::string>& files) {
  std::vector<Archive> archives;
  for (const std::string& file : files) {
    auto archive = Archive::open(file);
    if (!archive) {
      fmt::print(stderr, "{}\n", archive.error());
      return std::nullopt;
    }
    archives.push_back(std::move(*archive));
  }
  return archives;
}

/// The maps of the archives; only those named in `chosen` if any is.
std::vector<Task> tasksOf(const std::vector<Archive>& archives,
                          const std::vector<std::string>& chosen) {
  std::vector<Task> tasks;
  for (const Archive& archive : archives)
    for (const std::string& map : doom::mapNames(archive.wad()))
      if (chosen.empty() || std::ranges::find(chosen, map) != chosen.end())
        tasks.push_back({&archive, map});
  return tasks;
}

/// The first of the chosen maps that no archive has.
std::optional<std::string> missingOf(const std::vector<std::string>& chosen,
                                     const std::vector<Task>& tasks) {
  for (const std::string& map : chosen)
    if (std::ranges::find(tasks, map, &Task::map) == tasks.end()) return map;
  return std::nullopt;
}

/// Prints rows in the order of the maps, each as soon as those before it are done.
class Table {
 public:
  explicit Table(std::size_t rows) : worlds_(rows) { fmt::print("{}", worlds::tableHead()); }

  void set(std::size_t row, World world) {
    const std::lock_guard lock(mutex_);
    for (const std::string& error : world.errors) fmt::print(stderr, "{}\n", error);
    if (!world.tally.firstMiss.empty())
      fmt::print(stderr, "first miss: {}\n", world.tally.firstMiss);
    total_ += world.tally;
    isRight_ = isRight_ && world.isRight();
    worlds_[row] = std::move(world);
    for (; next_ < worlds_.size() && worlds_[next_]; ++next_)
      fmt::print("{}", worlds::tableRow(*worlds_[next_]));
    std::fflush(stdout);
  }

  const agreement::Tally& total() const { return total_; }
  bool isRight() const { return isRight_; }

 private:
  std::mutex mutex_;
  std::vector<std::optional<World>> worlds_;
  std::size_t next_ = 0;
  agreement::Tally total_;
  bool isRight_ = true;
};

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Imports maps of Doom and holds what is seen of them against truth.");
  std::vector<std::string> files{"/usr/share/games/doom/freedoom1.wad",
                                 "/usr/share/games/doom/freedoom2.wad"};
  std::vector<std::string> maps;
  worlds::Looks looks;
  int threads = availableThreads();
  app.add_option("WAD", files, "archives with maps")->capture_default_str();
  app.add_option("--maps", maps, "of the archives; default: all");
  app.add_option("--places", looks.places, "in each map, besides the player's start")
      ->capture_default_str();
  app.add_option("--seed", looks.seed, "of the places")->capture_default_str();
  app.add_option("--width", looks.size.width, "of the pictures")
      ->check(CLI::Range(1, kMaxPictureSide))
      ->capture_default_str();
  app.add_option("--height", looks.size.height, "of the pictures")
      ->check(CLI::Range(1, kMaxPictureSide))
      ->capture_default_str();
  app.add_option("--texel", looks.texel, "metres")
      ->check(CLI::Range(0.01, 64.0))
      ->capture_default_str();
  app.add_option("--threads", threads, "maps at a time")->capture_default_str();
  CLI11_PARSE(app, argc, argv);

  const auto archives = openAll(files);
  if (!archives) return 2;
  const std::vector<Task> tasks = tasksOf(*archives, maps);
  if (const auto missing = missingOf(maps, tasks)) {
    fmt::print(stderr, "there is no map {}\n", *missing);
    return 2;
  }
  const auto folder =
      std::filesystem::temp_directory_path() / fmt::format("hearth-worlds-{}", ::getpid());
  Table table(tasks.size());
  parallelFor(tasks.size(), threads, [&](std::size_t i) {
    table.set(i, worlds::lookAt(*tasks[i].archive, tasks[i].map, looks, folder));
  });
  std::filesystem::remove_all(folder);
  fmt::print("\n{}", agreement::table(table.total()));
  return table.isRight() ? 0 : 1;
}
