#pragma once

#include <string>
#include <tl/expected.hpp>

#include "level/mover.h"
#include "load/load.h"
#include "viewer/host/storage.h"

namespace hearth {

/// What can be edited of a mover.
struct MoverEdit {
  std::string name;  ///< of the mover, which keeps it
  MoverTrigger trigger;
  double speed;  ///< metres a second

  friend bool operator==(const MoverEdit&, const MoverEdit&) = default;
};

/// As the mover is.
MoverEdit editOf(const Mover& mover);

/// Writes into the level's file what differs from the mover of that name. All other bytes of the
/// file stay as they are. Refuses a mover that the level does not have, the trigger `enter` for one
/// without zones, and a file that has changed since it was loaded. Errors are one sentence that
/// begins with the path.
tl::expected<void, std::string> writeMover(Storage& storage, const LoadedLevel& loaded,
                                           const MoverEdit& edit);

}  // namespace hearth
