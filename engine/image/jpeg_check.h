#pragma once

#include <istream>

namespace hearth {

enum class JpegPart {
  Header,  ///< up to the first scan: all that is read for a picture's size
  All,
};

/// Whether every Huffman table of a JPEG file has at most 255 symbols. True for files of other
/// kinds. stb_image 2.27 overruns a table of more than 256 symbols and uses the 256th as a
/// sentinel, so call this before it decodes. Real pictures need fewer symbols. Reads from the start
/// of the file, and rewinds it.
bool hasSafeHuffmanTables(std::istream& file, JpegPart part);

}  // namespace hearth
