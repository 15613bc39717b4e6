#include "viewer/preferences/config.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <utility>

#include "load/json/fields.h"
#include "load/json/read_document.h"
#include "load/suggest.h"
#include "text/json_edit.h"

namespace hearth {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kKeysMember = "keys";
constexpr std::string_view kMouseMember = "mouse";
constexpr std::string_view kViewBob = "viewBob";
constexpr std::string_view kDegreesPerPixel = "degreesPerPixel";
constexpr std::string_view kInvert = "invert";

constexpr double kPercent = 100;

/// Of a file that the program makes: a line for each of its members to come.
constexpr std::string_view kNewFile = "{\n  \"//\": \"settings of hearth walk\"\n}\n";

// --- Reading -------------------------------------------------------------------------------------

class KeyReader {
 public:
  KeyReader(Report& report, KeyMap& keys) : report_(report), keys_(keys) {}

  void read(JsonValue value) {
    std::vector<std::string_view> names;
    for (const ActionRow& row : actionTable()) names.push_back(row.name);
    const Fields fields(report_, value, names);
    for (const ActionRow& row : actionTable())
      if (const auto keys = fields.find(row.name)) readAction(*keys, row);
  }

 private:
  void readAction(JsonValue value, const ActionRow& row) {
    if (!value.isArray()) return reportWrongType(report_, value, "an array of names of keys");
    std::vector<Key> keys;
    for (const JsonValue element : value.elements())
      if (const auto key = readKey(element, row)) keys.push_back(*key);
    if (!keys.empty() || value.size() == 0) keys_.bind(row.action, std::move(keys));
  }

  std::optional<Key> readKey(JsonValue value, const ActionRow& row) {
    const auto name = readName(report_, value);
    if (!name) return std::nullopt;
    const auto key = keyNamed(*name);
    if (!key) {
      report_.error(value.place(), fmt::format("there is no key \"{}\"", *name),
                    suggest(*name, allKeyNames(),
                            "name it as on a US keyboard, as \"W\", \"Left "
                            "Shift\" or \"Keypad 1\""));
      return std::nullopt;
    }
    if (isAlt(*key)) {
      report_.error(value.place(), fmt::format("\"{}\" is for the desktop", *name),
                    "take another key");
      return std::nullopt;
    }
    const auto [taken, isNew] = takenBy_.emplace(*key, row.name);
    if (isNew) return key;
    report_.error(value.place(),
                  fmt::format("\"{}\" is a key of \"{}\" already", *name, taken->second),
                  "take it from one of them");
    return std::nullopt;
  }

  Report& report_;
  KeyMap& keys_;
  std::map<Key, std::string_view> takenBy_;
};

void readMouse(Report& report, JsonValue value, Preferences& preferences) {
  constexpr std::array<std::string_view, 2> kKnown{kDegreesPerPixel, kInvert};
  const Fields fields(report, value, kKnown);
  fields.read(kDegreesPerPixel, {kLeastDegreesPerPixel, kMaxDegreesPerPixel},
              preferences.degreesPerPixel);
  fields.read(kInvert, preferences.invertsPitch);
}

void readPreferences(Report& report, JsonValue root, Preferences& preferences) {
  constexpr std::array<std::string_view, 3> kKnown{kKeysMember, kMouseMember, kViewBob};
  const Fields fields(report, root, kKnown);
  if (const auto keys = fields.find(kKeysMember)) KeyReader(report, preferences.keys).read(*keys);
  if (const auto mouse = fields.find(kMouseMember)) readMouse(report, *mouse, preferences);
  double percent = kPercent * preferences.viewBob;
  fields.read(kViewBob, {0, kPercent}, percent);
  preferences.viewBob = percent / kPercent;
}

// --- Writing -------------------------------------------------------------------------------------

std::string namesOf(const std::vector<Key>& keys) {
  std::vector<std::string> names;
  for (const Key key : keys) names.push_back(nlohmann::json(nameOf(key)).dump());
  return fmt::format("[{}]", fmt::join(names, ", "));
}

std::string edited(std::string text, const Preferences& before, const Preferences& after) {
  const auto set = [&text](const auto& path, const std::string& value) {
    text = withValueAt(text, path, value);
  };
  for (const ActionRow& row : actionTable())
    if (const auto& keys = after.keys.keysOf(row.action); keys != before.keys.keysOf(row.action))
      set(std::array{kKeysMember, row.name}, namesOf(keys));
  if (after.degreesPerPixel != before.degreesPerPixel)
    set(std::array{kMouseMember, kDegreesPerPixel}, fmt::format("{:g}", after.degreesPerPixel));
  if (after.invertsPitch != before.invertsPitch)
    set(std::array{kMouseMember, kInvert}, fmt::format("{}", after.invertsPitch));
  if (after.viewBob != before.viewBob)
    set(std::array{kViewBob}, fmt::format("{:g}", kPercent * after.viewBob));
  return text;
}

using Stored = tl::expected<std::string, ReadError>;

Stored stored(Storage& storage, const fs::path& file) {
  return storage.read(file, LoadLimits{}.fileBytes);
}

bool isMissing(const Stored& bytes) {
  return !bytes && bytes.error().code == ReadErrorCode::Missing;
}

/// The file as it is, to be edited.
tl::expected<std::string, std::string> textOf(Storage& storage, const fs::path& file) {
  auto bytes = stored(storage, file);
  if (isMissing(bytes)) return std::string(kNewFile);
  std::vector<Document> documents(1);
  Report report;
  const bool isJson = readDocument(file, std::move(bytes), documents[0], 0, report);
  if (!isJson || !JsonValue(documents[0], 0, 0).isObject())
    return tl::make_unexpected(fmt::format(
        "{}: is not written, as it is no JSON object; mend or remove it", file.string()));
  return std::move(documents[0].text);
}

}  // namespace

Config readConfig(Storage& storage, const fs::path& file) {
  Config config;
  auto bytes = stored(storage, file);
  if (isMissing(bytes)) return config;
  std::vector<Document> documents(1);
  Report report;
  if (readDocument(file, std::move(bytes), documents[0], 0, report))
    readPreferences(report, JsonValue(documents[0], 0, 0), config.preferences);
  config.warnings = report.resolve(documents);
  for (Diagnostic& warning : config.warnings) warning.isError = false;
  return config;
}

tl::expected<void, std::string> writeConfig(Storage& storage, const fs::path& file,
                                            const Preferences& before, const Preferences& after) {
  const auto text = textOf(storage, file);
  if (!text) return tl::unexpected(text.error());
  storage.makeFolder(file.parent_path());
  return storage.write(file, edited(*text, before, after));
}

tl::expected<void, std::string> ConfigFile::write(const Preferences& preferences) {
  if (file_.empty()) return {};
  auto written = writeConfig(storage_, file_, written_, preferences);
  if (written) written_ = preferences;
  return written;
}

}  // namespace hearth
