// Any bytes as the list of a cell's files in a log. Nothing may crash or hang; what is accepted
// names no place outside the folder it is laid out in, and is the same when written and read once
// more.

#include <cstdlib>
#include <filesystem>

#include "core/bundle/bundle_manifest.h"

namespace {

using namespace rocinante;

void mustLieBelow(const std::string& name) {
  const std::filesystem::path root = "/tmp/folder";
  const std::string place = (root / name).lexically_normal().string();
  if (!place.starts_with("/tmp/folder/")) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const ByteView bytes(reinterpret_cast<const std::byte*>(data), size);
  const auto manifest = parseManifest(bytes, "fuzz");
  if (!manifest) return 0;
  std::uint64_t total = 0;
  for (const BundleManifest::File& file : manifest->files) {
    mustLieBelow(file.name);
    total += file.bytes;
  }
  if (total > kMaxBundledBytes) std::abort();
  for (const BundleManifest::Name& name : manifest->names) {
    if (!name.in.empty()) mustLieBelow(name.in);
    if (!name.means.empty()) mustLieBelow(name.means);
  }
  const std::string text = manifestText(*manifest);
  const auto again = parseManifest(bytesOf(text), "fuzz");
  if (!again || *again != *manifest) std::abort();
  return 0;
}
