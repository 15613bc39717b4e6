#include "level/moved_geometry.h"

#include <algorithm>
#include <cmath>

#include "level/switch_textures.h"
#include "level/thing_bodies.h"
#include "math/check.h"

namespace hearth {

MovedGeometry::MovedGeometry(const Level& level, const Geometry& authored)
    : level_(&level), authored_(&authored), shares_(level.movers.size()) {
  if (level.movers.empty()) return;
  geometry_ = authored;
  std::size_t most = 0;
  for (const Mover& mover : level.movers) most = std::max(most, mover.sectors.size());
  moved_.reserve(most);
  findRiders();
  if (!riders_.empty() || !level.switchTextures.empty()) own_ = std::make_unique<Level>(level);
}

void MovedGeometry::findRiders() {
  std::vector<std::optional<std::size_t>> moverUnder(level_->sectors.size());
  for (std::size_t mover = 0; mover < level_->movers.size(); ++mover)
    if (level_->movers[mover].part == FlatPart::Floor)
      for (const SectorId sector : level_->movers[mover].sectors)
        moverUnder[sector.index()] = mover;
  std::uint32_t bodies = 0;  // of sprites, then of meshes
  const auto add = [&](bool isMesh, std::size_t index, const auto& thing, bool isSolid) {
    const auto body = isSolid ? std::optional(bodies++) : std::nullopt;
    const auto mover = moverUnder[thing.sector.index()];
    if (thing.standsOnFloor && mover)
      riders_.push_back({*mover, isMesh, static_cast<std::uint32_t>(index), body});
  };
  for (std::size_t i = 0; i < level_->sprites.size(); ++i)
    add(false, i, level_->sprites[i], level_->sprites[i].body.has_value());
  for (std::size_t i = 0; i < level_->meshes.size(); ++i)
    add(true, i, level_->meshes[i], level_->meshes[i].isSolid);
  std::ranges::stable_sort(riders_, {}, &Rider::mover);
}

void MovedGeometry::setShare(std::size_t mover, double share) {
  const bool isSwitched = (shares_[mover] > 0) != (share > 0);
  shares_[mover] = share;
  if (isSwitched && !level_->switchTextures.empty()) showSwitches(*own_, shares_);
  const double height = heightAt(mover, share);
  const bool isFloor = level_->movers[mover].part == FlatPart::Floor;
  moved_.clear();
  for (const SectorId sector : level_->movers[mover].sectors) {
    SectorGeometry heights = geometry_.sectors[sector.index()];
    (isFloor ? heights.zFloor : heights.zCeiling) = height;
    moved_.push_back({sector, heights});
  }
  moveFlats(*level_, moved_, geometry_);
  auto rider = std::ranges::lower_bound(riders_, mover, {}, &Rider::mover);
  for (; rider != riders_.end() && rider->mover == mover; ++rider)
    rider->isMesh ? standMesh(*rider, height) : standSprite(*rider, height);
}

void MovedGeometry::standSprite(const Rider& rider, double height) {
  Sprite& sprite = own_->sprites[rider.index];
  sprite.position.z = height;
  if (rider.body) stand(own_->bodies[*rider.body], sprite);
}

/// All of it is as much higher than where it is authored.
void MovedGeometry::standMesh(const Rider& rider, double height) {
  Mesh& mesh = own_->meshes[rider.index];
  mesh.position.z = height;
  const double rise = height - level_->meshes[rider.index].position.z;
  const std::span<const MeshFace> authored = level_->facesOf(mesh);
  for (std::uint32_t i = 0; i < mesh.faceCount; ++i)
    for (std::size_t corner = 0; corner < authored[i].corners.size(); ++corner)
      own_->meshFaces[mesh.firstFace + i].corners[corner].z = authored[i].corners[corner].z + rise;
  own_->faceTrees[rider.index].raiseFrom(level_->faceTrees[rider.index], rise);
  if (!rider.body) return;
  const ThingBody& body = level_->bodies[*rider.body];
  own_->bodies[*rider.body].zBottom = body.zBottom + rise;
  own_->bodies[*rider.body].zTop = body.zTop + rise;
}

void MovedGeometry::setShares(std::span<const double> shares) {
  CHECK(shares.size() == shares_.size(), shares.size(), shares_.size());
  for (std::size_t i = 0; i < shares.size(); ++i)
    if (shares[i] != shares_[i]) setShare(i, shares[i]);
}

double MovedGeometry::heightAt(std::size_t mover, double share) const {
  const Mover& moving = level_->movers[mover];
  const SectorGeometry& authored = authored_->sectors[moving.sectors.front().index()];
  return std::lerp(moving.part == FlatPart::Floor ? authored.zFloor : authored.zCeiling, moving.to,
                   share);
}

}  // namespace hearth
