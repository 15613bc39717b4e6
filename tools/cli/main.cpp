#include "cli/program.h"

int main(int argc, char** argv) {
  return hearth::runProgram("Hearth draws sector and portal levels with baked light.",
                            hearth::allCommands(), argc, argv);
}
