#include "core/foreign/ros/ros1_chunk.h"

#include <string>

#ifdef ROCINANTE_HAS_BZ2
#include <bzlib.h>
#endif

#include "core/base/plain_text.h"
#include "core/mcap/lz4_frame.h"

namespace rocinante::ros {
namespace {

Error damaged(std::string what) { return Error{ErrorKind::damaged, std::move(what), {}}; }

#ifdef ROCINANTE_HAS_BZ2
Result<std::size_t> expandBz2(ByteView stored, std::byte* out, std::size_t room) {
  auto made = static_cast<unsigned int>(room);
  // It only reads the source, whatever its type says.
  auto* const source = const_cast<char*>(reinterpret_cast<const char*>(stored.data()));
  const int status = BZ2_bzBuffToBuffDecompress(reinterpret_cast<char*>(out), &made, source,
                                                static_cast<unsigned int>(stored.size()), 0, 0);
  if (status != BZ_OK) {
    return damaged("the chunk does not decompress: bzip2 error " + std::to_string(status));
  }
  return std::size_t{made};
}
#else
Result<std::size_t> expandBz2(ByteView, std::byte*, std::size_t) {
  return Error{ErrorKind::unsupported,
               "the chunk is compressed with \"bz2\", which this build cannot read",
               {}};
}
#endif

}  // namespace

Result<ByteView> expandRos1Chunk(const Ros1Record& chunk, mcap::ExpansionBudget& budget,
                                 mcap::Scratch& scratch) {
  const std::optional<ByteView> compression = chunk.field("compression");
  const std::optional<std::uint32_t> size = chunk.number<std::uint32_t>("size");
  if (!compression || !size) return damaged("a chunk has no compression or no size");
  const std::string_view name = textOf(*compression);
  if (name == "none") {
    if (chunk.data.size() != *size) return damaged("a chunk does not have the size that it claims");
    return chunk.data;
  }
  if (*size > mcap::kMaxChunkBytes) {
    return damaged("a chunk claims " + std::to_string(*size) + " bytes; at most " +
                   std::to_string(mcap::kMaxChunkBytes) + " are expanded");
  }
  if (name != "lz4" && name != "bz2") {
    return Error{ErrorKind::unsupported,
                 "a chunk is compressed with \"" + plainText(name.substr(0, 32)) +
                     "\"; only none, lz4 and bz2 can be read",
                 {}};
  }
  if (!budget.take(*size)) return damaged(mcap::ExpansionBudget::refusal());
  std::byte* const out = scratch.make(*size);
  const Result<std::size_t> made =
      name == "lz4" ? mcap::expandLz4(chunk.data, out, *size) : expandBz2(chunk.data, out, *size);
  if (!made) return made.error();
  if (*made != *size) return damaged("a chunk does not have the size that it claims");
  return ByteView(out, *made);
}

}  // namespace rocinante::ros
