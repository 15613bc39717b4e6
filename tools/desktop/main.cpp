#include <array>

#include "cli/program.h"
#include "desktop/run_walk.h"

int main(int argc, char** argv) {
  hearth::Command walk = hearth::walkCommand();
  walk.program = {};
  walk.run = hearth::runWalk;
  walk.moreOfUser = hearth::keyHelpOfUser;
  return hearth::runProgram("Walks levels in a window, for `hearth walk`.", std::array{walk}, argc,
                            argv);
}
