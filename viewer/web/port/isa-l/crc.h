#pragma once

// ISA-L is for processors with its instructions; a page takes zlib's checksum in its place.

#include <zlib.h>

#include <cstdint>

inline std::uint32_t crc32_gzip_refl(std::uint32_t crc, const unsigned char* bytes,
                                     std::uint64_t size) {
  return static_cast<std::uint32_t>(::crc32_z(crc, bytes, static_cast<z_size_t>(size)));
}
