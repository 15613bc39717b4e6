#include "cli/check/check_level.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <system_error>

#include "cli/check/golden_picture.h"
#include "files/read_file.h"
#include "files/replace_file.h"
#include "image/compare.h"
#include "image/image_file.h"
#include "inputs/inputs.h"
#include "inputs/moved_light.h"
#include "render/renderer.h"
#include "settings/shell_text.h"

namespace hearth {

namespace {

using Outcome = tl::expected<void, std::string>;

constexpr std::string_view kExpected = ".expected.png";
constexpr std::string_view kActual = ".actual.png";
constexpr std::string_view kDifference = ".difference.png";
constexpr std::string_view kPage = "report.html";
constexpr std::string_view kPart = ".tmp";  // of what replaceFile was writing when it was killed

/// What keeps a level from being checked at all.
std::optional<std::string> mistakeInShots(const Level& level) {
  if (level.shots.empty())
    return "nothing to check: the level has no shots, at /shots, name a camera there";
  for (const Shot& shot : level.shots)
    if (!isFileName(shot.name))
      return fmt::format("the shot {:?} cannot name a file, at /shots, rename it", shot.name);
  return std::nullopt;
}

/// Takes away what an earlier check left, and nothing else.
void removeFailed(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> left;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    std::string name = entry.path().filename().string();
    if (name.ends_with(kPart)) name.resize(name.size() - kPart.size());
    const auto isEnding = [&](std::string_view ending) { return name.ends_with(ending); };
    const bool isOurs =
        name == kPage || std::ranges::any_of(std::array{kExpected, kActual, kDifference}, isEnding);
    if (isOurs && entry.is_regular_file(error)) left.push_back(entry.path());
  }
  for (const std::filesystem::path& file : left) std::filesystem::remove(file, error);
  const bool isFolder =
      std::filesystem::is_directory(std::filesystem::symlink_status(folder, error));
  if (isFolder) std::filesystem::remove(folder, error);  // fails where something else is in it
}

Outcome makeFolder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!error) return {};
  return tl::unexpected(fmt::format("{}: cannot be made: {}", folder.string(), error.message()));
}

Outcome copyFile(const std::filesystem::path& from, const std::filesystem::path& to) {
  const auto bytes = readFile(from, std::numeric_limits<std::uint64_t>::max());
  if (!bytes) return tl::unexpected(fmt::format("{}: {}", from.string(), bytes.error().what));
  return replaceFile(to, [&](std::ostream& stream) {
    stream << *bytes;
    return stream.good();
  });
}

/// Checks the shots of one level, one after the other.
class LevelCheck {
 public:
  explicit LevelCheck(const OptionValues& values)
      : values_(values),
        isUpdate_(values.has(Option::Update)),
        folders_(goldenFolders(values.level, values.text(Option::Golden))) {
    findings_.level = values.level;
    findings_.acceptCommand = fmt::format(
        "{} check {}{} --update", values.program, shellWord(values.level),
        typedOptions(values, std::vector{Option::Golden, Option::MoverStages} + lightOptions()));
    findings_.page = folders_.failed / kPage;
  }

  LevelFindings run() && {
    const OpenedLevel opened = loadAndReportWithSource(values_);
    const std::optional<LoadedLevel>& loaded = opened.result.loaded;
    if (!loaded) return refused();
    if (const auto mistake = mistakeInShots(loaded->level)) return refused(*mistake);
    const auto pictures = drawShots(*loaded, opened.source);
    if (!pictures) return refused(pictures.error());

    removeFailed(folders_.failed);
    for (std::size_t i = 0; i < pictures->size(); ++i)
      judge(loaded->level.shots[i].name, (*pictures)[i]);
    for (const std::string& name : staleGoldens(folders_.golden, loaded->level.shots))
      judgeStale(name);
    if (!isUpdate_) printSum();
    return std::move(findings_);
  }

 private:
  LevelFindings refused() {
    findings_.status = ExitStatus::BadInput;
    return std::move(findings_);
  }
  LevelFindings refused(const std::string& message) {
    fail(fmt::format("{}: {}", values_.level, message));
    return refused();
  }

  /// By shot, each with the movers where it has them.
  tl::expected<std::vector<Image>, std::string> drawShots(const LoadedLevel& authored,
                                                          const LevelSource& source) const {
    std::map<std::vector<double>, std::vector<std::size_t>> shotsAt;
    for (std::size_t i = 0; i < authored.level.shots.size(); ++i)
      shotsAt[moverSharesOf(authored.level, authored.level.shots[i])].push_back(i);
    MovedLight movedLight(authored, source, values_);
    std::vector<Image> pictures(authored.level.shots.size(), Image(1, 1));
    for (const auto& [shares, shots] : shotsAt) {
      const auto moved = loadedAt(authored, source, shares, values_);
      if (!moved) return tl::unexpected(moved.error());
      const auto light = movedLight.at(**moved, shares);
      if (!light) return tl::unexpected(light.error());
      const LoadedLevel& shown = **moved;
      const Renderer renderer(shown.scene(), shown.textures, *light, drawSettingsFrom(values_));
      for (const std::size_t i : shots)
        pictures[i] = renderer.draw(cameraOf(shown.level.shots[i]), LightMode::Both);
    }
    return pictures;
  }

  void judge(const std::string& name, const Image& drawn) {
    const std::filesystem::path golden = pictureFile(folders_.golden, name);
    const Comparison comparison = compareWithGolden(golden, drawn);
    const bool isKept = comparison.verdict != Verdict::Missing;
    ShotFinding finding{name, comparison.verdict == Verdict::Same, comparison.words,
                        isKept ? reproduction(name) : ""};
    if (isKept && comparison.verdict != Verdict::Unreadable) finding.expected = golden;
    if (isUpdate_)
      note(accept(finding, comparison.verdict, drawn));
    else if (!finding.isAsKept)
      note(keepFailed(finding, comparison, drawn));
    add(std::move(finding));
  }

  void judgeStale(const std::string& name) {
    const std::filesystem::path golden = pictureFile(folders_.golden, name);
    ShotFinding finding{name, false, fmt::format("no shot draws {}", golden.string()), ""};
    finding.expected = golden;
    note(isUpdate_ ? removeStale(finding) : keepExpected(finding));
    add(std::move(finding));
  }

  Outcome accept(ShotFinding& finding, Verdict verdict, const Image& drawn) const {
    if (verdict == Verdict::Same) {
      finding.words = "unchanged";
      return {};
    }
    if (auto made = makeFolder(folders_.golden); !made) return made;
    const std::filesystem::path golden = pictureFile(folders_.golden, finding.shot);
    if (auto written = writePng(golden, drawn); !written) return written;
    finding.isAsKept = true;
    finding.words = verdict == Verdict::Missing ? "new" : "changed: " + finding.words;
    finding.expected = golden;
    return {};
  }

  static Outcome removeStale(ShotFinding& finding) {
    std::error_code error;
    std::filesystem::remove(*finding.expected, error);
    if (error)
      return tl::unexpected(
          fmt::format("{}: cannot be removed: {}", finding.expected->string(), error.message()));
    finding.isAsKept = true;
    finding.words = "removed: " + finding.words;
    finding.expected.reset();
    return {};
  }

  std::filesystem::path failedFile(const ShotFinding& finding, std::string_view ending) const {
    return pictureFile(folders_.failed, finding.shot, ending);
  }

  Outcome keepExpected(const ShotFinding& finding) const {
    Outcome outcome = makeFolder(folders_.failed);
    if (outcome && finding.expected)
      outcome = copyFile(*finding.expected, failedFile(finding, kExpected));
    return outcome;
  }

  Outcome keepFailed(ShotFinding& finding, const Comparison& comparison, const Image& drawn) const {
    if (auto kept = keepExpected(finding); !kept) return kept;
    const std::filesystem::path actual = failedFile(finding, kActual);
    if (auto written = writePng(actual, drawn); !written) return written;
    finding.actual = actual;
    if (!comparison.golden) return {};
    const std::filesystem::path difference = failedFile(finding, kDifference);
    auto written = writePng(difference, amplifiedDifference(*comparison.golden, drawn));
    if (written) finding.difference = difference;
    return written;
  }

  std::string reproduction(const std::string& name) const {
    return fmt::format("{} shot {} --shot {}{} -o {}", values_.program, shellWord(values_.level),
                       shellWord(name), typedOptions(values_, lightOptions()),
                       shellWord(name + ".png"));
  }

  void note(const Outcome& outcome) {
    if (!outcome) findings_.status = fail(outcome.error());
  }

  void add(ShotFinding finding) {
    if (!finding.isAsKept) findings_.status = std::max(findings_.status, ExitStatus::Differs);
    if (isUpdate_ || !finding.isAsKept)
      fmt::print("{}: {}: {}\n", values_.level, finding.shot, finding.words);
    if (!finding.isAsKept && !finding.command.empty()) fmt::print("    {}\n", finding.command);
    findings_.shots.push_back(std::move(finding));
  }

  void printSum() const {
    const auto asKept = std::ranges::count_if(findings_.shots, &ShotFinding::isAsKept);
    const auto others = std::ssize(findings_.shots) - asKept;
    if (others == 0) return fmt::print("{}: {} as kept\n", values_.level, asKept);
    fmt::print("{}: {} as kept, {} not; accept with\n    {}\n", values_.level, asKept, others,
               findings_.acceptCommand);
  }

  const OptionValues& values_;
  bool isUpdate_;
  GoldenFolders folders_;
  LevelFindings findings_{};
};

}  // namespace

LevelFindings checkLevel(const OptionValues& values) { return LevelCheck(values).run(); }

}  // namespace hearth
