#pragma once

#include <array>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "load/json/report.h"

/// The findings of `hearth lint`: authors' mistakes that the loader accepts.
namespace hearth {

/// The order is that of the table in tools/README.md.
enum class FindingKind {
  OneWayPortal,
  Unreachable,
  NearMiss,
  TextureJump,
  UnseenTexture,
  UnseenThing,
  HighStep,
  LowPassage,
  NarrowPassage,
  SunkenPlayer,
  StuckPlayer,
  IdleMover,
  UnenteredZone,
  ShutIn,
  UselessLight,
  WeakLight,
  Black,
  Overexposed,
};

struct FindingKindRow {
  FindingKind kind;
  std::string_view name;  ///< stable: ends the line of each finding
  std::string_view help;
};

/// The loader's own warnings, by its names. It also reports one-way portals.
struct LoaderKindRow {
  std::string_view name;
  std::string_view help;
};

inline constexpr std::array kLoaderKinds{
    LoaderKindRow{"turned-loop", "a loop runs the wrong way"},
    LoaderKindRow{"uneven-portal", "the two sides of a portal open different heights"},
    LoaderKindRow{"far-away", "a coordinate is too far from the origin for exact light"},
    LoaderKindRow{"light-in-plane", "a light lies on a surface, which it does not light"},
    LoaderKindRow{"unworn-emitter", "no surface wears the texture of an emitter"},
    LoaderKindRow{"no-light", "nothing is said of light, and all is fully bright"},
    LoaderKindRow{"model-skips", "something in a model or its materials is left out"},
    LoaderKindRow{"mover-zones", "zones of a mover that they do not start"},
};

inline constexpr std::array kFindingKinds{
    FindingKindRow{FindingKind::OneWayPortal, "one-way-portal",
                   "a portal, or a part of it, does not lead back"},
    FindingKindRow{FindingKind::Unreachable, "unreachable",
                   "no links lead from the player to a sector"},
    FindingKindRow{FindingKind::NearMiss, "near-miss",
                   "a vertex misses another one, or a wall, by a hair"},
    FindingKindRow{FindingKind::TextureJump, "texture-jump",
                   "an image does not run on from one wall to the next in line"},
    FindingKindRow{FindingKind::UnseenTexture, "unseen-texture",
                   "a portal gives a texture to a step that is not there"},
    FindingKindRow{FindingKind::UnseenThing, "unseen-thing",
                   "nothing of a thing shows, or it is tiny"},
    FindingKindRow{FindingKind::HighStep, "high-step",
                   "a step that seems meant to be climbed is too high for the player"},
    FindingKindRow{FindingKind::LowPassage, "low-passage",
                   "a way that seems meant to be walked is too low for the player"},
    FindingKindRow{FindingKind::NarrowPassage, "narrow-passage",
                   "a way that seems meant to be walked is too narrow for the player"},
    FindingKindRow{FindingKind::SunkenPlayer, "sunken-player",
                   "the player begins with the feet below the floor"},
    FindingKindRow{FindingKind::StuckPlayer, "stuck-player",
                   "the player begins with the head in the ceiling, or inside a solid thing"},
    FindingKindRow{FindingKind::IdleMover, "idle-mover", "nothing starts a mover"},
    FindingKindRow{FindingKind::UnenteredZone, "unentered-zone",
                   "the player cannot get to a zone that starts a mover"},
    FindingKindRow{FindingKind::ShutIn, "shut-in", "a mover shuts the player in for ever"},
    FindingKindRow{FindingKind::UselessLight, "useless-light", "a light reaches no surface"},
    FindingKindRow{FindingKind::WeakLight, "weak-light", "a light brings next to nothing"},
    FindingKindRow{FindingKind::Black, "black", "a surface has no light at all"},
    FindingKindRow{FindingKind::Overexposed, "overexposed",
                   "much of a surface has more light than can be shown"},
};

/// Collects findings, each at its place in the level's files. A finding about several pieces of one
/// wall is reported once.
class Findings {
 public:
  void add(FindingKind kind, Place place, std::string message, std::string_view advice);

  /// In the form of the loader's warnings.
  std::vector<Diagnostic> resolve(std::span<const Document> documents) const {
    return report_.resolve(documents);
  }

 private:
  Report report_;
  std::set<std::pair<Place, std::string>> said_;
};

}  // namespace hearth
