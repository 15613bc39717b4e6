#pragma once

#include <istream>

namespace hearth {

enum class JpegPart {
  Header,  ///< up to the first scan: all that is read for a picture's size
  All,
};

/// Whether no Huffman table of a JPEG file has more than 255 symbols; true for files of other
/// kinds. stb_image 2.27 overruns its tables above 256 symbols and uses the 256th as a sentinel, so
/// call this before it decodes. Real pictures need fewer. Reads from the start of the file, and
/// rewinds it.
bool haveSoundTables(std::istream& file, JpegPart part);

}  // namespace hearth
