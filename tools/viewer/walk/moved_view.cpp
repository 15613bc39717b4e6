#include "viewer/walk/moved_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hearth {

namespace {

/// Of all movers together, in shares.
double distance(std::span<const double> a, std::span<const double> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
  return sum;
}

}  // namespace

MovedView::MovedView(const Scene& authored, const Renderer& still,
                     const MoverLightSettings& settings)
    : geometry_(authored.level(), authored.geometry()),
      settings_(settings),
      known_{
          {std::vector<double>(authored.level().movers.size()), {authored, &still.light()}, {}, 0}},
      renderer_(geometry_.scene(), still.textures(), light_.light(), still.settings()) {
  around_.find(geometry_.shares(), settings_.stages);
  setStates();
  light(nullptr);
}

void MovedView::moveTo(std::span<const double> shares) {
  if (std::ranges::equal(shares, geometry_.shares())) return;
  geometry_.setShares(shares);
  around_.find(shares, settings_.stages);
  isLit_ = false;
}

void MovedView::light(Workers* workers) {
  if (isLit_) return;
  if (!around_.areStatesOf(blended_)) setStates();
  std::ranges::fill(weights_, 0.0);
  for (std::size_t i = 0; i < around_.count(); ++i) weights_[sourceOf_[i]] += around_.weights()[i];
  light_.blend(geometry_.scene(), weights_, workers);
  isLit_ = true;
}

void MovedView::setStates() {
  blended_ = around_;
  ++uses_;
  std::vector<std::size_t> used;  // of the known lights
  sourceOf_.clear();
  wanted_.clear();
  for (std::size_t i = 0; i < around_.count(); ++i) {
    const std::vector<double> shares = around_.shares(i);
    const std::size_t known = nearestKnown(shares);
    known_[known].lastUse = uses_;
    if (known_[known].shares != shares) wanted_.push_back(shares);
    const auto same = std::ranges::find(used, known);
    sourceOf_.push_back(static_cast<std::size_t>(same - used.begin()));
    if (same == used.end()) used.push_back(known);
  }
  std::vector<LightAtRest> lights;
  for (const std::size_t known : used) lights.push_back(known_[known].at);
  light_.setStates(lights);
  weights_.resize(lights.size());
}

std::size_t MovedView::nearestKnown(std::span<const double> shares) const {
  const auto nearest = std::ranges::min_element(
      known_, {}, [&](const Known& known) { return distance(known.shares, shares); });
  return static_cast<std::size_t>(nearest - known_.begin());
}

void MovedView::add(std::shared_ptr<const RestLight> rest) {
  if (known_[nearestKnown(rest->shares)].shares == rest->shares) return;
  const LightAtRest at{{geometry_.level(), rest->geometry}, &rest->light};
  known_.push_back({rest->shares, at, std::move(rest), uses_});
  setStates();
  isLit_ = false;
  if (known_.size() > settings_.states) forgetOldest();
}

/// Unless it is blended now. The level as authored is always kept.
void MovedView::forgetOldest() {
  const auto oldest =
      std::ranges::min_element(known_.begin() + 1, known_.end(), {}, &Known::lastUse);
  if (oldest->lastUse == uses_) return;
  known_.erase(oldest);
  setStates();  // whose lights are where they were; their indices are not
}

}  // namespace hearth
