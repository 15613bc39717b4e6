#include "image/jpeg_check.h"

#include <algorithm>

namespace hearth {
namespace {

// Codes of ITU-T T.81, table B.1.
constexpr int kStartOfImage = 0xD8;
constexpr int kHuffmanTables = 0xC4;
constexpr int kFirstRestart = 0xD0;
constexpr int kLastRestart = 0xD7;
constexpr int kEndOfImage = 0xD9;
constexpr int kStartOfScan = 0xDA;

constexpr int kEnd = std::istream::traits_type::eof();

constexpr int kMaxSymbols = 255;
constexpr int kCodeLengths = 16;

/// Goes through a JPEG file as stb_image does: segment by segment. A scan has no length of its own,
/// and ends at the next marker.
class TableChecker {
 public:
  explicit TableChecker(std::istream& file) : file_(file) {}

  bool check(JpegPart part) {
    if (file_.peek() != 0xFF || nextMarker() != kStartOfImage) return true;
    while (const int marker = nextMarker()) {
      if (marker == kEndOfImage || (marker == kStartOfScan && part == JpegPart::Header)) break;
      if (marker != kHuffmanTables)
        skipSegment();
      else if (!areTablesSafe())
        return false;
    }
    return true;
  }

 private:
  /// The code after the next 0xFF, except restart markers inside scans; 0 at the file's end.
  int nextMarker() {
    for (int byte = file_.get(); byte != kEnd; byte = file_.get()) {
      if (byte != 0xFF) continue;
      while (byte == 0xFF) byte = file_.get();
      if (byte > 0 && (byte < kFirstRestart || byte > kLastRestart)) return byte;
    }
    return 0;
  }

  int read16() {
    const int high = file_.get();
    const int low = file_.get();
    return low == kEnd ? 0 : high << 8 | low;
  }

  void skipSegment() {
    const int length = read16();
    if (length > 2) file_.seekg(length - 2, std::ios::cur);
  }

  /// Reads a segment of tables.
  bool areTablesSafe() {
    for (int left = read16() - 2; left > 0;) {
      int symbols = 0;
      file_.get();  // class and number of the table
      for (int i = 0; i < kCodeLengths; ++i) symbols += std::max(file_.get(), 0);
      if (symbols > kMaxSymbols) return false;
      if (!file_) return true;  // cut short, which is told later
      file_.seekg(symbols, std::ios::cur);
      left -= 1 + kCodeLengths + symbols;
    }
    return true;
  }

  std::istream& file_;
};

void rewind(std::istream& file) {
  file.clear();
  file.seekg(0);
}

}  // namespace

bool hasSafeHuffmanTables(std::istream& file, JpegPart part) {
  rewind(file);
  const bool areSafe = TableChecker(file).check(part);
  rewind(file);
  return areSafe;
}

}  // namespace hearth
