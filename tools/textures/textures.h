#pragma once

#include <string>
#include <vector>

#include "image/image.h"

namespace hearth::textures {

/// The side of a surface texture in pixels; pictures are higher than wide. Each repeats seamlessly
/// in both directions.
inline constexpr int kTileSide = 128;

Image makeAshlar();    ///< Cut stones in four courses of one height, three to a course.
Image makeBanner();    ///< A gold tower on green, 640 pixels high: a banner of 1 by 5.
Image makeBeam();      ///< Two hewn timbers, their grain along the rows.
Image makeBrick();     ///< Running bond, 4 bricks by 8 courses.
Image makeCarpet();    ///< Lozenges of crimson and gold, two by two.
Image makeCobble();    ///< Round stones set in soil.
Image makeDirt();      ///< Trodden soil with pebbles.
Image makeDoor();      ///< Upright planks behind two iron straps.
Image makeDressed();   ///< Smooth stones in four courses without upright joints: frames, copings.
Image makeEmber();     ///< Glowing coals.
Image makeGlass();     ///< Leaded panes in lozenges of pale colours.
Image makeGrass();     ///< Short turf.
Image makeGrille();    ///< Iron bars, four by two, with holes between them.
Image makeHay();       ///< Stalks of straw that lie as they fell.
Image makeHewn();      ///< Stone of one block, without joints: statues.
Image makeIron();      ///< Riveted plates, two by two.
Image makeMarble();    ///< A chessboard of light and dark slabs, two by two.
Image makeMossy();     ///< The stones of makeAshlar, wet and overgrown.
Image makeMossline();  ///< The same where moss ends: dry at rows 16 and 80, overgrown at 48 and
                       ///< 112.
Image makePlaster();   ///< Lime plaster with trowel marks and hairline cracks.
Image makeRoof();      ///< Beaver-tail tiles, 8 by 8, the lower edge of each at the bottom.
Image makeSlate();     ///< Square roof slates, 8 by 8, the lower edge of each at the bottom.
Image makeStone();     ///< A floor of cut stones of many sizes.
Image makeTapestry();  ///< A tree with golden fruit in a border, 352 pixels high.
Image makeWater();     ///< Ripples along the rows.
Image makeWindow();    ///< A saint below a rose in coloured glass, 288 pixels high, pointed at the
                       ///< top.
Image makeWood();      ///< Eight planks, their grain along the rows.

/// A dusk panorama of 1536x256 pixels, which are square on the screen, seamless from left to right:
/// the zenith's colour in the top row, haze in the bottom row, both plain, because a sky repeats
/// them beyond the image.
Image makeSky();

struct Texture {
  std::string name;  ///< The file's name without extension.
  Image image;
};

/// All of the above, made with integers only: the same on every machine. Slopes cannot turn what
/// they wear, so what has a direction comes in several: "slate-ne" is for a slope that falls to the
/// north east, which is the image's upper right; without a suffix it falls to the south. "post" is
/// "beam" with its grain along the columns.
std::vector<Texture> makeAll();

}  // namespace hearth::textures
