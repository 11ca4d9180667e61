#include "core/recording/compression_text.h"

#include <charconv>

namespace rocinante {

Status readCompression(std::string_view text, LogWriterOptions& options) {
  if (text == "none") {
    options.compression = LogWriterOptions::Compression::none;
    return {};
  }
  if (text == "zstd") return {};
  if (text.starts_with("zstd:")) {
    const std::string_view level = text.substr(5);
    const char* const end = level.data() + level.size();
    const auto [used, fault] = std::from_chars(level.data(), end, options.zstd_level);
    const bool whole = fault == std::errc() && used == end;
    if (whole && options.zstd_level >= 1 && options.zstd_level <= 22) return {};
  }
  return Error{ErrorKind::bad_argument, "--compression is none, zstd or zstd:1 to zstd:22",
               std::string(text)};
}

}  // namespace rocinante
