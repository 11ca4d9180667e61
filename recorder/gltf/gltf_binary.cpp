#include "recorder/gltf/gltf_binary.h"

#include <fmt/format.h>

#include <array>
#include <limits>

#include "core/mesh/glb_container.h"

namespace rocinante {
namespace {

constexpr std::uint64_t kMaxGlbBytes = std::numeric_limits<std::int32_t>::max();
constexpr std::size_t kPieceBytes = std::size_t{1} << 18;

constexpr std::uint64_t padded(std::uint64_t bytes) { return (bytes + 3) / 4 * 4; }

/// Gathers small pieces.
class PieceWriter {
 public:
  explicit PieceWriter(ByteSink& sink) : sink_(sink) {}
  Status add(ByteView bytes) {
    piece_.insert(piece_.end(), bytes.begin(), bytes.end());
    count_ += bytes.size();
    return piece_.size() < kPieceBytes ? Status{} : flush();
  }
  Status flush() {
    if (piece_.empty()) return {};
    Status written = sink_.append(piece_);
    piece_.clear();
    return written;
  }
  std::uint64_t count() const { return count_; }

 private:
  ByteSink& sink_;
  Bytes piece_;
  std::uint64_t count_ = 0;
};

}  // namespace

Json accessorRange(std::span<const float> min, std::span<const float> max) {
  Json range;
  range["min"] = Json::array();
  range["max"] = Json::array();
  for (const float number : min) range["min"].push_back(static_cast<double>(number));
  for (const float number : max) range["max"].push_back(static_cast<double>(number));
  return range;
}

std::size_t GltfBinary::addView(std::uint64_t bytes, Target target, std::size_t stride,
                                std::function<Status(const UseBytes&)> make) {
  Json view;
  view["buffer"] = 0;
  view["byteOffset"] = bytes_;
  view["byteLength"] = bytes;
  if (stride > 0) view["byteStride"] = stride;
  if (target != Target::none) view["target"] = static_cast<int>(target);
  views_.push_back(std::move(view));
  sections_.push_back({bytes, std::move(make)});
  bytes_ += padded(bytes);
  return views_.size() - 1;
}

std::size_t GltfBinary::addAccessor(std::size_t view, std::uint64_t offset, int component,
                                    const char* type, std::uint64_t count, const Json& range) {
  Json accessor;
  accessor["bufferView"] = view;
  if (offset > 0) accessor["byteOffset"] = offset;
  accessor["componentType"] = component;
  accessor["count"] = count;
  accessor["type"] = type;
  if (!range.is_null()) accessor.update(range);
  accessors_.push_back(std::move(accessor));
  return accessors_.size() - 1;
}

void GltfBinary::describe(Json& document) const {
  if (bytes_ == 0) return;
  Json buffer;
  buffer["byteLength"] = bytes_;
  document["buffers"] = Json::array();
  document["buffers"].push_back(std::move(buffer));
  document["bufferViews"] = views_;
  document["accessors"] = accessors_;
}

Status GltfBinary::write(ByteSink& sink, const Json& document) const {
  const std::string text = jsonText(document, -1);
  const std::uint64_t whole = 28 + padded(text.size()) + bytes_;
  if (whole > kMaxGlbBytes) {
    return Error{ErrorKind::unsupported,
                 fmt::format("would have {} bytes; a .glb may have {}: choose a shorter span, or "
                             "--every",
                             whole, kMaxGlbBytes),
                 sink.name()};
  }
  PieceWriter out(sink);
  if (Status begun = out.add(glbHead(text, bytes_)); !begun) return begun;
  constexpr std::array<std::byte, 3> kPadding{};
  for (const Section& section : sections_) {
    const std::uint64_t from = out.count();
    Status made = section.make([&](ByteView bytes) { return out.add(bytes); });
    if (!made) return made;
    const std::uint64_t count = out.count() - from;
    if (count != section.bytes) {
      return Error{ErrorKind::unreadable, "changed while it was written", sink.name()};
    }
    made = out.add(ByteView(kPadding).first(padded(count) - count));
    if (!made) return made;
  }
  return out.flush();
}

}  // namespace rocinante
