#include "hearth/bench/peer_rows.h"

namespace hearth {

namespace {

constexpr Target atMost(double value) { return {Wanted::AtMost, value}; }
constexpr Target atLeast(double value) { return {Wanted::AtLeast, value}; }

}  // namespace

std::vector<PeerRow> peerRows() {
  return {
      {"frame-tutorial",
       "frame of the tutorial, 320x200, one thread",
       "ms",
       atMost(0.15),
       {},
       prepareTutorialFrame},
      {"doom-map01",
       "frame of Freedoom's MAP01, 1920x1080, lit, presented: processor time / dsda-doom's",
       "",
       atMost(1),
       {"Hearth, ms", "dsda-doom, ms"},
       prepareMap01Frame},
      {"doom-map15",
       "frame of Freedoom's MAP15, 1920x1080, lit, presented: processor time / dsda-doom's",
       "",
       atMost(1),
       {"Hearth, ms", "dsda-doom, ms"},
       prepareMap15Frame},
      {"frame-writes",
       "frame of the castle, 1920x1080, one thread / a plain write of its memory",
       "",
       atMost(14),
       {"frame, ms", "write, ms"},
       prepareKeepWrites},
      {"frame-kernel",
       "the same frame / a loop that only colours its spans, with all geometry given",
       "",
       atMost(1.5),
       {"frame, ms", "loop, ms"},
       prepareKernel},
      {"threads-spans",
       "colouring of found spans of the castle, 1920x1080: one thread / two",
       "",
       atLeast(1.85),
       {"one thread, ms", "two threads, ms"},
       preparePaintThreads},
      {"threads-frame",
       "frame of the castle, 1920x1080: one thread / two",
       "",
       atLeast(1.6),
       {"one thread, ms", "two threads, ms"},
       prepareFrameThreads},
      {"embree-castle",
       "bake of the castle, one thread, lamps as points: texel-light pairs a second / rays of "
       "Embree",
       "",
       atLeast(5),
       {"Hearth, M pairs/s", "Embree, M rays/s", "M pairs"},
       prepareKeepPairs},
      {"embree-tutorial",
       "bake of the tutorial, one thread, lamps as points: texel-light pairs a second / rays of "
       "Embree",
       "",
       atLeast(5),
       {"Hearth, M pairs/s", "Embree, M rays/s", "M pairs"},
       prepareTutorialPairs},
      {"bake-largest",
       "bake of Freedoom's MAP29, texels of 1/8 m, two threads",
       "s",
       atMost(2),
       {},
       prepareLargestBake},
      {"embree-largest",
       "the same bake / its rays by Embree, two threads",
       "",
       atMost(0.2),
       {"Hearth, s", "Embree, s", "M rays"},
       prepareLargestRays},
      {"start",
       "start of the program to a picture of the castle, light not kept",
       "ms",
       atMost(150),
       {},
       prepareStart},
      {"peak-castle",
       "memory of a bake of the castle / (2 x its result + 64 MB)",
       "",
       atMost(1),
       {"bake, MB", "allowed, MB"},
       prepareKeepPeak},
  };
}

}  // namespace hearth
