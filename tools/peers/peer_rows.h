#pragma once

#include <span>
#include <string>
#include <tl/expected.hpp>

#include "peers/peers.h"

namespace hearth {

/// All rows of the table, with their targets.
std::span<const PeerRow> peerRows();

// How each is measured. tools/README.md says what is compared, and what is subtracted.

using Prepared = tl::expected<Measure, std::string>;

/// Milliseconds of a frame of the tutorial in 320x200.
Prepared prepareTutorialFrame(PeerInputs& inputs);
/// A frame of the castle in 1920x1080 over a plain write of its memory; ms of both. The same with
/// its lights white.
Prepared prepareCastleWrites(PeerInputs& inputs);
Prepared prepareWhiteLitCastleWrites(PeerInputs& inputs);
/// A frame with a model of 99,856 triangles in 1920x1080 over one of llvmpipe; ms of both.
Prepared prepareModelFrame(PeerInputs& inputs);
/// A frame with 1,000 sprites in 1920x1080 over one without them; ms of both.
Prepared prepareSpriteFrame(PeerInputs& inputs);
/// A frame of the castle in 1920x1080 on one thread over two; ms of both.
Prepared prepareFrameThreads(PeerInputs& inputs);
/// Of it, the second phase alone.
Prepared preparePaintThreads(PeerInputs& inputs);
/// A frame of the castle in 3840x2160 on two threads over one in 1920x1080 on one; ms of both.
Prepared prepareLargeFrames(PeerInputs& inputs);
/// Processor time of a frame of a map of Freedoom in 1920x1080, shown in a window, over that of
/// dsda-doom; ms of both.
Prepared prepareMap01Frame(PeerInputs& inputs);
Prepared prepareMap15Frame(PeerInputs& inputs);
/// Pairs of a sample and a light that a bake answers in a second, on one thread with lamps as
/// points, over the rays that Embree traces; millions of both, and of pairs.
Prepared prepareCastlePairs(PeerInputs& inputs);
Prepared prepareTutorialPairs(PeerInputs& inputs);
/// Rays from lights that Hearth tests a second against a model of 99,856 triangles, over those that
/// Embree does; millions of both.
Prepared prepareShadowRays(PeerInputs& inputs);
/// Ranges of directions from texels of the castle in which slices find what they meet, a second,
/// over rays to what is met that Embree traces; millions of both.
Prepared prepareGatherRays(PeerInputs& inputs);
/// Seconds of a bake of Freedoom's largest map on two threads.
Prepared prepareLargestBake(PeerInputs& inputs);
/// The same over those of Embree; seconds of both, and millions of rays.
Prepared prepareLargestRays(PeerInputs& inputs);
/// Of 16 parts of that bake, one thread each: seconds of the slowest over their mean, and of all
/// over the whole bake.
Prepared prepareSlowestPart(PeerInputs& inputs);
Prepared preparePartsTogether(PeerInputs& inputs);
/// Milliseconds from the start of the program to a picture of the castle.
Prepared prepareStart(PeerInputs& inputs);
/// Bytes of saved light over texels that light reaches and channels, of maps of Freedoom; millions
/// of both.
Prepared prepareMap01Saved(PeerInputs& inputs);
Prepared prepareMap15Saved(PeerInputs& inputs);
Prepared prepareLargestSaved(PeerInputs& inputs);
/// The same of lightmaps in memory.
Prepared prepareMap01Kept(PeerInputs& inputs);
Prepared prepareMap15Kept(PeerInputs& inputs);
Prepared prepareLargestKept(PeerInputs& inputs);
/// A frame of a level of 100,000 rooms, in a row or on a grid, over one of 100, of which the same
/// is seen; ms of both.
Prepared prepareStripGrowth(PeerInputs& inputs);
Prepared prepareGridGrowth(PeerInputs& inputs);
/// A frame of a maze of a million cells, over one of 900, of which the same is seen; ms of both.
Prepared prepareMazeFrame(PeerInputs& inputs);
/// Seconds of loading the maze of a million cells; millions of its walls. Gigabytes of that.
Prepared prepareMazeLoad(PeerInputs& inputs);
Prepared prepareMazePeak(PeerInputs& inputs);
/// Rays that a bake traces in a second, on one thread, in a hall of 10,000 walls, over those in one
/// of 100; millions of both.
Prepared prepareWallRays(PeerInputs& inputs);
/// A frame of a hall while 20 doors move, over drawing it alone; ms of moving and of drawing.
Prepared prepareMovingDoors(PeerInputs& inputs);
/// Memory of a bake over what it may take; MB of both.
Prepared prepareCastlePeak(PeerInputs& inputs);
Prepared prepareLargestPeak(PeerInputs& inputs);

}  // namespace hearth
