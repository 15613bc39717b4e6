#pragma once

#include <cstddef>
#include <string>

#include "load/source.h"
#include "truth/trace.h"

/// The places of a level's parts in its files: `levels/keep.json:123 /sectors/hall/floor/texture`,
/// the line and the JSON pointer.
namespace hearth {

std::string placeOfSector(const LevelSource& source, SectorId sector);
/// The wall, the part of a stack, the flat or the heights of the slope that a surface belongs to.
std::string placeOfSurface(const LevelSource& source, const Level& level, const TruthHit& surface);
/// The place of its texture; for a surface without a texture of its own the same as above.
std::string placeOfTexture(const LevelSource& source, const Level& level, const TruthHit& surface);
std::string placeOfSprite(const LevelSource& source, std::size_t sprite);
/// The place of its first image.
std::string placeOfSpriteImage(const LevelSource& source, std::size_t sprite);
std::string placeOfMesh(const LevelSource& source, std::size_t mesh);
/// The place of its model's name.
std::string placeOfModel(const LevelSource& source, std::size_t mesh);
std::string placeOfLight(const LevelSource& source, std::size_t light);

}  // namespace hearth
