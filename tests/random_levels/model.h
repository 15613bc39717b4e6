#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "random_levels/mesh.h"

namespace hearth::random_levels {

using SectorIndex = std::size_t;
using FlatPortalIndex = std::size_t;

/// A texture as a level file spells it.
struct TextureUse {
  std::string name;
  std::optional<std::array<double, 2>> scale;   ///< m
  std::optional<std::array<double, 2>> offset;  ///< texels
  std::optional<double> along;                  ///< m
  std::optional<double> zref;                   ///< m
  bool isObject = false;                        ///< else `"name su,sv ou,ov"`
};

struct SolidPiece {
  TextureUse texture;
};

struct PortalPiece {
  SectorIndex next = 0;
  std::optional<TextureUse> texture;
  std::optional<TextureUse> upper;
  std::optional<TextureUse> lower;
  std::optional<TextureUse> maskedMiddle;
};

struct Piece {
  std::variant<SolidPiece, PortalPiece> kind;
  Um bottom = 0;  ///< absolute
  Um top = 0;     ///< absolute
};

/// From `vertices[i]` of its loop to the next; one piece, or a stack from bottom to top.
struct Wall {
  std::vector<Piece> pieces;
};

struct Loop {
  std::string name;
  std::vector<VertexId> vertices;  ///< clockwise on the map for a border, the other way for holes
  std::vector<Wall> walls;
  bool isWoundWrongly = false;  ///< in the file only
  bool hasOneWall = false;      ///< all walls are alike and written once
};

/// Height of a wedge above its floor (below its ceiling): `base + dot(gradient, p)`, in metres.
struct Wedge {
  Vec2 gradient;
  double base = 0;
  std::set<std::size_t> nulls;  ///< numbers of border vertices whose heights are left to the plane
  TextureUse sidewall;
  bool isRelative = false;
  bool isRounded = false;  ///< heights are written in tenths of a millimetre

  double at(Vec2 p) const { return base + dot(gradient, p); }
};

struct Flat {
  Um z = 0;
  TextureUse texture;
  bool isRelative = false;
  bool isSky = false;
  std::optional<FlatPortalIndex> flatPortal;
  bool isFlatPortalObject = false;  ///< `{"up":, "down":}`, else `"up-down"`
  std::optional<Wedge> wedge;

  bool isPlain() const { return !isSky && !flatPortal && !wedge; }
};

struct Sector {
  std::string name;
  std::optional<double> light;
  std::size_t storey = 0;
  std::vector<FaceId> faces;
  Flat floor;
  Flat ceiling;
  std::vector<Loop> loops;   ///< the border first
  bool isChainLink = false;  ///< kept open, for a long view

  Um height() const { return ceiling.z - floor.z; }
};

/// A flat portal: all floors above it and all ceilings below it.
struct FlatPortal {
  SectorIndex up = 0;
  SectorIndex down = 0;
};

struct Model {
  Mesh mesh;
  std::vector<Sector> sectors;
  std::vector<FlatPortal> flatPortals;
  std::vector<std::set<SectorIndex>> owners;  ///< per face, over all storeys

  double floorAt(const Sector& sector, Vec2 p) const;    ///< m, wedge included
  double ceilingAt(const Sector& sector, Vec2 p) const;  ///< m, wedge included
  bool coversMap(const Sector& sector, Vec2 p) const;
  /// Metres to the nearest wall of the sector, portals included.
  double distanceToWalls(const Sector& sector, Vec2 p) const;
  /// Sectors that hold the point or lie within `margin` metres of it.
  std::vector<SectorIndex> sectorsAround(Vec3 p, double margin) const;
  double floorArea(const Sector& sector) const;  ///< m^2
};

/// The portals in a wall, from bottom to top.
std::vector<const PortalPiece*> portalsOf(const Wall& wall);

}  // namespace hearth::random_levels
