#include "viewer/preferences/bookmarks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "level/locate.h"
#include "load/positions.h"
#include "math/tolerance.h"

namespace hearth {

namespace {

using nlohmann::json;

double rounded(double number, double perUnit) { return std::round(number * perUnit) / perUnit; }

json jsonOf(const Bookmark& mark) {
  return {{"name", mark.name},
          {"sector", mark.sector},
          {"camera", {mark.eye.x, mark.eye.y, mark.eye.z, mark.angle, mark.pitch}},
          {"fov", mark.fov},
          {"flying", mark.isFlying}};
}

std::optional<Bookmark> bookmarkFrom(const json& value) {
  try {
    const auto camera = value.at("camera").get<std::array<double, 5>>();
    const bool isFinite =
        std::ranges::all_of(camera, [](double number) { return std::isfinite(number); });
    Bookmark mark{value.at("name"),  value.at("sector"), {camera[0], camera[1], camera[2]},
                  camera[3],         camera[4],          value.at("fov"),
                  value.at("flying")};
    const bool isGood = isFinite && !mark.name.empty() && std::abs(mark.pitch) <= 60 &&
                        mark.fov >= 1 && mark.fov <= 179;
    return isGood ? std::optional(std::move(mark)) : std::nullopt;
  } catch (const json::exception&) {  // of another shape
    return std::nullopt;
  }
}

}  // namespace

Bookmark bookmarkOf(const Scene& scene, const Walker& walker, double fov, std::string name) {
  constexpr double kPerMetre = 1000;
  constexpr double kPerDegree = 100;
  const Eye eye = eyeOf(scene, walker);
  const Vec3 near{rounded(eye.point.x, kPerMetre), rounded(eye.point.y, kPerMetre),
                  rounded(eye.point.z, kPerMetre)};
  const bool isIn = contains(scene, scene[eye.sector], near, kPositionSlack);
  return {std::move(name),
          scene[eye.sector].name,
          isIn ? near : eye.point,
          rounded(eye.angle, kPerDegree),
          rounded(eye.pitch, kPerDegree),
          fov,
          walker.isFlying};
}

tl::expected<Walker, std::string> walkerAt(const Scene& scene, const Bookmark& bookmark) {
  const auto sector = locatePosition(scene, bookmark.eye, bookmark.sector);
  if (!sector) return tl::make_unexpected(fmt::format("{}: {}", bookmark.name, sector.error()));
  Walker walker = walkerAt(scene, *sector, bookmark.eye, bookmark.angle, bookmark.pitch);
  walker.isFlying = bookmark.isFlying;
  return walker;
}

Bookmarks::Bookmarks(Storage& storage, std::filesystem::path file)
    : storage_(&storage), file_(std::move(file)) {
  const auto text = storage.read(file_, std::numeric_limits<std::uint64_t>::max());
  const json root = json::parse(text.value_or(""), nullptr, false);
  if (!root.is_object() || !root.contains("bookmarks")) return;
  for (const json& value : root["bookmarks"])
    if (auto mark = bookmarkFrom(value); mark && !find(mark->name))
      all_.push_back(*std::move(mark));
}

const Bookmark* Bookmarks::find(std::string_view name) const {
  const auto found = std::ranges::find(all_, name, &Bookmark::name);
  return found == all_.end() ? nullptr : &*found;
}

std::string Bookmarks::freeName() const {
  int number = 1;
  while (find(fmt::format("place-{}", number))) ++number;
  return fmt::format("place-{}", number);
}

tl::expected<void, std::string> Bookmarks::add(Bookmark bookmark) {
  const auto found = std::ranges::find(all_, bookmark.name, &Bookmark::name);
  if (found == all_.end())
    all_.push_back(std::move(bookmark));
  else
    *found = std::move(bookmark);
  return write();
}

tl::expected<void, std::string> Bookmarks::remove(std::string_view name) {
  std::erase_if(all_, [name](const Bookmark& mark) { return mark.name == name; });
  return write();
}

tl::expected<void, std::string> Bookmarks::write() const {
  if (!storage_) return {};
  json list = json::array();
  for (const Bookmark& mark : all_) list.push_back(jsonOf(mark));
  storage_->makeFolder(file_.parent_path());
  return storage_->write(
      file_, json{{"bookmarks", list}}.dump(1, ' ', false, json::error_handler_t::replace) + '\n');
}

}  // namespace hearth
