// Any bytes as a ZIP file: every file in it is read within a bound, and nothing crashes or hangs.

#include <cstdlib>

#include "core/archive/zip_archive.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::uint64_t kMaxBytes = 1U << 20U;
  constexpr int kMaxRead = 64;
  const auto archive = rocinante::ZipArchive::ofBytes(
      rocinante::ByteView(reinterpret_cast<const std::byte*>(data), size), "fuzzed.zip");
  if (!archive.ok()) return 0;
  int read = 0;
  for (const std::string& name : archive->names()) {
    const auto content = archive->read(name, kMaxBytes);
    if (content.ok() && content->size() > kMaxBytes) std::abort();
    if (++read == kMaxRead) break;
  }
  return 0;
}
