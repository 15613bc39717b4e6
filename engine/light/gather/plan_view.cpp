#include "light/gather/plan_view.h"

#include <algorithm>
#include <span>

#include "math/tolerance.h"

namespace hearth {

namespace {

/// What two have in common.
std::optional<Wedge> common(const Wedge& a, const Wedge& b) {
  const Wedge both{b.contains(a.right) ? a.right : b.right, b.contains(a.left) ? a.left : b.left};
  const bool meet = a.contains(both.right) && b.contains(both.right) && a.contains(both.left) &&
                    b.contains(both.left);
  if (!meet) return std::nullopt;
  return both;
}

/// The smallest around two; none if it is half of all directions or more.
std::optional<Wedge> around(const Wedge& a, const Wedge& b) {
  for (const Wedge& all : {a, b, Wedge{a.right, b.left}, Wedge{b.right, a.left}})
    if (cross(all.right, all.left) > 0 && all.contains(a.right) && all.contains(a.left) &&
        all.contains(b.right) && all.contains(b.left))
      return all;
  return std::nullopt;
}

/// None if the point is in the box.
std::optional<Wedge> wedgeOf(const Box& box, Vec2 point) {
  if (box.contains(point)) return std::nullopt;
  const Vec2 middle = 0.5 * (box.min + box.max) - point;
  Wedge wedge{middle, middle};
  for (const double x : {box.min.x, box.max.x})
    for (const double y : {box.min.y, box.max.y}) {
      const Vec2 corner = Vec2{x, y} - point;
      if (cross(wedge.right, corner) < 0) wedge.right = corner;
      if (cross(wedge.left, corner) > 0) wedge.left = corner;
    }
  return wedge;
}

/// Whether a point lies on the wall between two ends, or nearly: then it sees all that lies before
/// and behind the wall.
bool isInLine(const Wedge& toEnds) {
  const Vec2 along = toEnds.left - toEnds.right;
  const double slack2 = kPositionSlack * kPositionSlack * dot(along, along);
  const double aside = cross(toEnds.right, toEnds.left);
  if (aside * aside > slack2) return false;
  const double ahead = dot(toEnds.right, toEnds.left);
  return ahead <= 0 || ahead * ahead <= slack2;
}

/// Than so many radians, less than 1.
bool isNarrower(const Wedge& wedge, double width) {
  const double ahead = dot(wedge.right, wedge.left);
  return ahead > 0 && cross(wedge.right, wedge.left) < width * ahead;
}

}  // namespace

PlanView::PlanView(const Scene& scene)
    : scene_(scene), plan_(std::make_shared<const Plan>(planOf(scene))) {}

PlanView::Plan PlanView::planOf(const Scene& scene) {
  Plan plan;
  for (const Sector& sector : scene.level().sectors) {
    plan.rooms.push_back({static_cast<std::uint32_t>(plan.gaps.size()),
                          sector.floor.isSky || sector.ceiling.isSky,
                          sector.floor.flatPortal || sector.ceiling.flatPortal});
    for (const Segment& segment : scene.segmentsOf(sector))
      for (const LightOpening& opening : scene.lightOpeningsOf(segment))
        plan.gaps.push_back({segment.p0, segment.p1, opening.next});
  }
  plan.rooms.push_back({static_cast<std::uint32_t>(plan.gaps.size()), false, false});
  return plan;
}

std::span<const PlanView::Gap> PlanView::gapsOf(SectorId sector) const {
  const Plan::Room* room = &plan_->rooms[sector.value];
  return std::span(plan_->gaps).subspan(room->firstGap, room[1].firstGap - room->firstGap);
}

void PlanView::lookFrom(Vec2 point, SectorId sector, double narrowest, SectorSet* met) {
  point_ = point;
  narrowest_ = narrowest;
  views_.resize(plan_->rooms.size());
  ++look_;
  left_.clear();
  windows_.clear();
  see(sector, std::nullopt);
  while (!left_.empty()) {
    const SectorId next = left_.back();
    left_.pop_back();
    if (met) met->add(next);
    const std::optional<Wedge> wedge = views_[next.value].wedge;
    passWalls(next, wedge);
    if (plan_->rooms[next.value].hasFlatPortals) passFlats(next, wedge);
  }
}

/// A sector that is seen through many openings, one after the other, is soon seen everywhere.
void PlanView::see(SectorId sector, const std::optional<Wedge>& wedge) {
  constexpr int kOften = 8;
  View& view = views_[sector.value];
  if (view.look != look_) {
    view = {wedge, 0, look_};
  } else {
    if (!view.wedge) return;
    const Wedge before = *view.wedge;
    if (wedge && before.contains(wedge->right) && before.contains(wedge->left)) return;
    view.wedge = wedge && ++view.timesWidened < kOften ? around(before, *wedge) : std::nullopt;
  }
  left_.push_back(sector);
}

void PlanView::passWalls(SectorId sector, const std::optional<Wedge>& wedge) {
  for (const Gap& gap : gapsOf(sector)) {
    const Wedge through{gap.p0 - point_, gap.p1 - point_};
    if (isInLine(through)) {
      see(gap.next, wedge);
      continue;
    }
    if (!(cross(through.right, through.left) > 0)) continue;
    const std::optional<Wedge> seen = wedge ? common(*wedge, through) : through;
    if (!seen || isNarrower(*seen, narrowest_)) continue;
    addWindow(sector, gap.next, *seen);
    see(gap.next, seen);
  }
}

void PlanView::addWindow(SectorId from, SectorId to, const Wedge& wedge) {
  if (!hasSky(from) && hasSky(to) && std::ranges::find(windows_, wedge) == windows_.end())
    windows_.push_back(wedge);
}

void PlanView::passFlats(SectorId sector, const std::optional<Wedge>& wedge) {
  const auto pass = [&](const Flat& flat, FlatPortalSide side) {
    if (!flat.flatPortal) return;
    for (const SectorId next : scene_[*flat.flatPortal].members(side)) {
      if (wedge) addWindow(sector, next, *wedge);
      see(next, wedge);
    }
  };
  pass(scene_[sector].floor, FlatPortalSide::Lower);
  pass(scene_[sector].ceiling, FlatPortalSide::Upper);
}

bool PlanView::maySee(SectorId sector, const Box& box) const {
  const View& view = views_[sector.value];
  if (view.look != look_) return false;
  const std::optional<Wedge> wedge = wedgeOf(box, point_);
  return !view.wedge || !wedge || common(*view.wedge, *wedge);
}

}  // namespace hearth
