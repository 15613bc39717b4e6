#include <array>

#include "cli/program.h"
#include "peers/peers_command.h"

int main(int argc, char** argv) {
  const std::array commands = {hearth::peersCommand()};
  return hearth::runProgram("Measures Hearth against other programs and limits of the machine.",
                            commands, argc, argv);
}
