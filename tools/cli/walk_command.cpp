#include <vector>

#include "cli/command.h"
#include "inputs/inputs.h"
#include "viewer/input/actions.h"

namespace hearth {

Command walkCommand() {
  return {
      .name = "walk",
      .help =
          "opens a window and walks the level, or turns a model (MODEL.obj): H in it shows the "
          "keys, F1 figures and settings",
      .options = std::vector<Option>{Option::Start, Option::Camera, Option::Sector, Option::Shot,
                                     Option::Mover, Option::MoverStages, Option::MoverStates,
                                     Option::Size, Option::Scale, Option::Fov, Option::FrameCap,
                                     Option::TargetMs, Option::Vsync, Option::Light, Option::Record,
                                     Option::Replay, Option::Headless, Option::Quiet} +
                 drawOptions() + lightOptions(),
      .more = keyHelp(KeyMap()),
      .program = "hearth-walk"};
}

}  // namespace hearth
