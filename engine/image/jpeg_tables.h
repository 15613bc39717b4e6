#pragma once

#include <cstdio>

namespace hearth {

enum class JpegPart {
  Header,  ///< up to the first scan: all that is read for a picture's size
  All,
};

/// Whether no Huffman table of a JPEG file has more than 255 symbols; true for files of other
/// kinds. stb_image 2.27 writes past its tables for more than 256, so that this is asked before it
/// reads anything, and takes the 256th for a sign of its own. No picture needs so many.
/// Reads from the start of the file, and rewinds it.
bool haveSoundTables(std::FILE* file, JpegPart part);

}  // namespace hearth
