#include <fmt/format.h>
#include <zlib.h>

#include <array>
#include <cassert>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/base/figure_text.h"
#include "viewer/picture/png_files.h"

namespace rocinante {
namespace {

constexpr std::size_t kSignature = 8, kHeader = 13;
constexpr std::size_t kAroundContent = 12;  // length, type and checksum of a chunk
constexpr std::size_t kAtOnce = std::size_t{1} << 16U;

std::uint32_t numberAt(ByteView bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    number = number << 8U | std::to_integer<std::uint32_t>(bytes[at + i]);
  }
  return number;
}

/// Number of filtered bytes by the header, each row with its filter byte; for an interlaced
/// picture, of all seven passes.
std::uint64_t filteredBytes(ByteView header) {
  struct Pass {
    std::uint32_t x, y, x_step, y_step;
  };
  static constexpr std::array<Pass, 7> kPasses = {{{0, 0, 8, 8},
                                                   {4, 0, 8, 8},
                                                   {0, 4, 4, 8},
                                                   {2, 0, 4, 4},
                                                   {0, 2, 2, 4},
                                                   {1, 0, 2, 2},
                                                   {0, 1, 1, 2}}};
  static constexpr std::array<std::uint32_t, 7> kComponents = {1, 0, 3, 1, 2, 0, 4};
  const std::uint32_t width = numberAt(header, 0), height = numberAt(header, 4);
  const auto depth = std::to_integer<std::uint64_t>(header[8]);
  const std::uint64_t bits = depth * kComponents.at(std::to_integer<std::size_t>(header[9]));
  const auto bytesOf = [&](std::uint64_t columns, std::uint64_t rows) -> std::uint64_t {
    return columns == 0 ? 0 : rows * (1 + (columns * bits + 7) / 8);
  };
  if (header[12] == std::byte{0}) return bytesOf(width, height);
  std::uint64_t all = 0;
  for (const Pass& pass : kPasses) {
    // Pixels of a pass along one side; may be zero.
    const auto stepsIn = [](std::uint32_t side, std::uint32_t first, std::uint32_t step) {
      return side <= first ? 0U : (side - first - 1) / step + 1;
    };
    all += bytesOf(stepsIn(width, pass.x, pass.x_step), stepsIn(height, pass.y, pass.y_step));
  }
  return all;
}

/// Inflates the pixels in pieces and only counts them. With zlib, which reports unused input
/// exactly.
class PixelCount {
 public:
  explicit PixelCount(std::uint64_t expected) : expected_(expected), thrown_away_(kAtOnce) {
    is_ready_ = ::inflateInit(&stream_) == Z_OK;
  }
  ~PixelCount() { ::inflateEnd(&stream_); }
  PixelCount(const PixelCount&) = delete;
  PixelCount& operator=(const PixelCount&) = delete;

  /// Adds compressed bytes; returns the fault or empty.
  std::string add(ByteView compressed) {
    if (!is_ready_) return "not enough memory to inflate it";
    // zlib only reads.
    stream_.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(compressed.data()));
    stream_.avail_in = static_cast<uInt>(compressed.size());
    while (!ended_) {
      stream_.next_out = thrown_away_.data();
      stream_.avail_out = static_cast<uInt>(thrown_away_.size());
      const int code = ::inflate(&stream_, Z_NO_FLUSH);
      count_ += thrown_away_.size() - stream_.avail_out;
      if (count_ > expected_) return "it has more pixels than its header says";
      ended_ = code == Z_STREAM_END;
      // Z_BUF_ERROR means that more input is needed.
      if (code == Z_BUF_ERROR || (code == Z_OK && stream_.avail_out > 0)) return "";
      if (code != Z_OK && !ended_) return "its compressed pixels end wrongly";
    }
    if (stream_.avail_in == 0) return "";
    return countText(stream_.avail_in, "byte") + " after the end of its compressed pixels";
  }

  /// Call after the last bytes.
  std::string finish() const {
    if (!ended_) return "its compressed pixels have no end";
    return count_ == expected_ ? "" : "it has fewer pixels than its header says";
  }

 private:
  std::uint64_t expected_, count_ = 0;
  z_stream stream_{};
  bool is_ready_ = false, ended_ = false;
  std::vector<Bytef> thrown_away_;
};

}  // namespace

Status checkWholePng(ByteView bytes, const std::string& name) {
  const auto damaged = [&](const std::string& what) {
    return Error{ErrorKind::damaged, "is not a valid PNG: " + what, name};
  };
  assert(bytes.size() >= kSignature + kAroundContent + kHeader);
  PixelCount pixels(filteredBytes(bytes.subspan(kSignature + 8, kHeader)));
  std::size_t at = kSignature;
  while (at + kAroundContent <= bytes.size()) {
    const std::size_t length = numberAt(bytes, at);
    if (length > bytes.size() - at - kAroundContent) break;
    const std::string_view type = textOf(bytes.subspan(at + 4, 4));
    const ByteView content = bytes.subspan(at + 8, length);
    at += kAroundContent + length;
    if (type == "acTL" && length >= 4) {
      const std::uint32_t frames = numberAt(content, 0);
      return Error{ErrorKind::unsupported,
                   fmt::format("is an animation of {}; only still pictures are judged",
                               countText(frames, "frame")),
                   name};
    }
    if (type == "IDAT") {
      if (std::string fault = pixels.add(content); !fault.empty()) return damaged(fault);
    }
    if (type != "IEND") continue;
    if (std::string fault = pixels.finish(); !fault.empty()) return damaged(fault);
    if (length > 0) return damaged("its end (IEND) has content");
    const ByteView rest = bytes.subspan(at);
    if (rest.empty()) return {};
    if (textOf(rest).starts_with("\x89PNG")) {
      return Error{ErrorKind::unsupported,
                   "has several pictures; only files with one picture are judged", name};
    }
    return damaged(countText(rest.size(), "byte") + " after its end (IEND)");
  }
  return damaged("it has no end (IEND)");
}

}  // namespace rocinante
