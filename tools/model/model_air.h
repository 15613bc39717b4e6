#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "math/box3.h"
#include "model/orbit_view.h"

/// The open air in which a model stands alone: its origin is at (0, 0, 0), and its axes lie as
/// those of any mesh. Sky surrounds it, above and below.
namespace hearth {

/// Names of the sector in which the model stands and of the level's shot, and the shot's size.
inline constexpr const char* kAirName = "air";
inline constexpr const char* kFrontName = "front";
inline constexpr ImageSize kFrontSize = {320, 200};

Vec3 centreOf(const Box3& box);
/// Half of the box's diagonal: of a ball round the box. Metres.
double radiusOf(const Box3& box);

/// The farthest that a camera goes from the middle of the model on the plan, in radii of its box.
/// At `kModelFov` the model takes a seventh of the picture there.
inline constexpr double kFarthestRadii = 20;

/// The air round a model, by the box of the model. Cameras at `kFarthestRadii` are within it, and
/// the model's origin, wherever it lies.
Box3 airRound(const Box3& model);

struct SizeMistake {
  std::string message;
  std::string advice;
};
/// Says why a model with this box cannot be shown: it is too small, too large or too far from its
/// origin. None if it can be.
std::optional<SizeMistake> mistakeInSize(const Box3& model);

/// The air as a level file and its lights file.
struct AirFiles {
  std::filesystem::path level;  ///< they lie beside the model
  std::filesystem::path lights;
  std::string levelText;
  std::string lightsText;
};
/// `front` is the view of the level's only shot. None if the name of the model's file is not UTF-8,
/// as JSON must be.
std::optional<AirFiles> airFiles(const std::filesystem::path& model, const Box3& box,
                                 const OrbitView& front);

}  // namespace hearth
