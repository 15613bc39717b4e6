#include "peers/child.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <system_error>
#include <thread>

#include "measure/frame_times.h"

namespace hearth {

namespace {

/// As the system takes them: with a null at the end.
std::vector<char*> pointersTo(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

tl::expected<pid_t, std::string> start(Child child) {
  std::vector<char*> environment = pointersTo(child.environment);
  environment.pop_back();
  for (char** variable = environ; *variable; ++variable) environment.push_back(*variable);
  environment.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  posix_spawn_file_actions_addchdir_np(&actions, child.folder.c_str());
  pid_t process = 0;
  const int error = posix_spawnp(&process, child.words.front().c_str(), &actions, nullptr,
                                 pointersTo(child.words).data(), environment.data());
  posix_spawn_file_actions_destroy(&actions);
  if (error == 0) return process;
  return tl::unexpected(
      fmt::format("{}: {}", child.words.front(), std::generic_category().message(error)));
}

tl::expected<void, std::string> succeeded(const Child& child, int status) {
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {};
  return tl::unexpected(fmt::format("`{}` failed", fmt::join(child.words, " ")));
}

double secondsOf(timeval time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Linux tells in /proc; 0 where there is nothing (any more).
std::int64_t peakSoFar(pid_t process) {
  std::ifstream in(fmt::format("/proc/{}/status", process));
  constexpr std::string_view kKey = "VmHWM:";
  for (std::string line; std::getline(in, line);)
    if (line.starts_with(kKey)) return 1024 * std::stoll(line.substr(kKey.size()));
  return 0;
}

}  // namespace

tl::expected<ChildTimes, std::string> timesOf(const Child& child) {
  const double begin = steadySeconds();
  const auto process = start(child);
  if (!process) return tl::unexpected(process.error());
  int status = 0;
  rusage usage{};
  wait4(*process, &status, 0, &usage);
  const double seconds = steadySeconds() - begin;
  return succeeded(child, status).map([&] {
    return ChildTimes{seconds, secondsOf(usage.ru_utime)};
  });
}

tl::expected<std::int64_t, std::string> peakOf(const Child& child) {
  const auto process = start(child);
  if (!process) return tl::unexpected(process.error());
  std::int64_t peak = 0;
  int status = 0;
  while (waitpid(*process, &status, WNOHANG) == 0) {
    peak = std::max(peak, peakSoFar(*process));
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return succeeded(child, status).map([&] { return peak; });
}

std::filesystem::path hearthProgram() {
  return std::filesystem::read_symlink("/proc/self/exe").replace_filename("hearth");
}

}  // namespace hearth
