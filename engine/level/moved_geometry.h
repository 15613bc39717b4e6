#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "level/scene.h"

namespace hearth {

/// The geometry of a level whose movers stand at any shares, the things that stand on moving floors
/// and the textures of switches. Takes no memory when they move, and none at all for a level
/// without movers.
class MovedGeometry {
 public:
  /// All movers at share 0, as in `authored`. Level and geometry must outlive it.
  MovedGeometry(const Level& level, const Geometry& authored);

  /// Valid while this stays in its place.
  Scene scene() const { return {level(), shares_.empty() ? *authored_ : geometry_}; }
  const Level& level() const { return own_ ? *own_ : *level_; }
  /// By mover.
  std::span<const double> shares() const { return shares_; }

  /// Moves one mover (0..1), in a time that depends on it, on what stands on it, and on switches.
  void setShare(std::size_t mover, double share);
  /// Moves those whose share differs.
  void setShares(std::span<const double> shares);

  /// The absolute height of a mover's flats at a share.
  double heightAt(std::size_t mover, double share) const;

 private:
  /// A thing on a floor that moves.
  struct Rider {
    std::size_t mover;
    bool isMesh;                        ///< else it is a sprite
    std::uint32_t index;                ///< among the meshes, or the sprites
    std::optional<std::uint32_t> body;  ///< of Level::bodies, if it is solid
  };

  void findRiders();
  void standSprite(const Rider& rider, double height);
  void standMesh(const Rider& rider, double height);

  const Level* level_;
  std::unique_ptr<Level> own_;  ///< a copy, in which riders move and switches change; null
                                ///< without any
  const Geometry* authored_;
  Geometry geometry_;
  std::vector<double> shares_;
  std::vector<MovedFlats> moved_;  ///< of the mover that moves
  std::vector<Rider> riders_;      ///< by mover
};

}  // namespace hearth
