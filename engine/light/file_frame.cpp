#include "light/file_frame.h"

#include <fmt/format.h>

#include "light/byte_stream.h"

namespace hearth {

std::optional<std::string> mistakeInFrame(const FileFrame& frame, std::string_view bytes) {
  if (!bytes.starts_with(frame.begin.substr(0, bytes.size())))
    return fmt::format("is no {}", frame.kind);
  const auto cutShort = [&](std::uint64_t whole) {
    return fmt::format("is cut short: {} of {} bytes are there", bytes.size(), whole);
  };
  const std::size_t least = frame.headerBytes + FileFrame::kChecksumBytes;
  if (bytes.size() < FileFrame::kVersionEnd) return cutShort(least);
  ByteReader in(bytes.substr(frame.begin.size()));
  if (const std::uint32_t version = in.take32(); version != frame.version)
    return fmt::format("is a {} of version {}, and only version {} can be read", frame.kind,
                       version, frame.version);
  if (bytes.size() < least) return cutShort(least);
  in.take32();
  const std::uint64_t length = in.take64();
  if (bytes.size() < length) return cutShort(length);
  if (bytes.size() > length)
    return fmt::format("goes on for {} bytes after its end", bytes.size() - length);
  const std::size_t end = bytes.size() - FileFrame::kChecksumBytes;
  if (ByteReader(bytes.substr(end)).take32() != checksum(bytes.substr(0, end)))
    return "was altered: its checksum is not that of its bytes";
  return std::nullopt;
}

}  // namespace hearth
