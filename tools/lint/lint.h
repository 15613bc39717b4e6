#pragma once

#include "light/bakery.h"
#include "lint/findings.h"
#include "load/source.h"

namespace hearth {

/// A loaded level and its source.
struct LintedLevel {
  const LoadedLevel& loaded;
  const LevelSource& source;

  const Level& level() const { return loaded.level; }
  Scene scene() const { return loaded.scene(); }
};

// What needs no bake.

/// Parts of portals that do not lead back. The loader warns of portals of which no part does.
void findOneWayPortals(const LintedLevel& linted, Findings& findings);
/// Sectors to which no links lead from the player or, without a player, from most other sectors.
void findUnreachable(const LintedLevel& linted, Findings& findings);
/// Vertices that lie beside others, or beside walls, farther than is welded and nearer than is
/// likely meant.
void findNearMisses(const LintedLevel& linted, Findings& findings);
/// Images that do not continue along a plane.
void findTextureJumps(const LintedLevel& linted, Findings& findings);
/// Textures of steps that show nowhere.
void findUnseenTextures(const LintedLevel& linted, Findings& findings);
/// Things outside the air of all sectors, and those that are too small to be meant.
void findUnseenThings(const LintedLevel& linted, Findings& findings);
/// Steps that are just too high to climb, and passages that are just too low or narrow.
void findImpassable(const LintedLevel& linted, Findings& findings);
/// The sectors that the player cannot reach on foot, in order. In doubt a sector is left out. None
/// without a player.
std::vector<SectorId> outOfReach(const Scene& scene);
/// A player whose feet begin below the floor, or whose head begins above the ceiling, or who begins
/// inside a solid thing.
void findMisplacedPlayer(const LintedLevel& linted, Findings& findings);
/// Movers that nothing starts, and zones of movers that the player cannot get to.
void findIdleMovers(const LintedLevel& linted, Findings& findings);
/// Movers that let the player into a small part of the level, and never out again.
void findShutIn(const LintedLevel& linted, Findings& findings);

// What needs one.

/// The level with a part of its light, so that lightmaps do not end where more cannot be shown.
Level dimmed(Level level);

/// Lights that no surface sees, and those that hardly light anything. `settings` are those of the
/// bake.
void findUselessLights(const LintedLevel& linted, const BakeSettings& settings, int threads,
                       Findings& findings);
/// Surfaces that are black in the level's light.
void findBlack(const LintedLevel& linted, const BakedLight& light, Findings& findings);
/// Surfaces that are far brighter than can be shown, by the light of the dimmed level.
void findOverexposed(const LintedLevel& linted, const BakedLight& dimmed, Findings& findings);

/// All of the first, and all of the second.
std::vector<Diagnostic> lintGeometry(const LintedLevel& linted);
std::vector<Diagnostic> lintLight(const LintedLevel& linted, const BakedLight& light,
                                  const BakedLight& dimmed, const BakeSettings& settings,
                                  int threads);

}  // namespace hearth
