#include "golden/judge/judged_frame_wire.h"

#include <cstring>
#include <set>
#include <type_traits>
#include <utility>

namespace rocinante {
namespace {

class WireWriter {
 public:
  template <class T>
  requires std::is_trivially_copyable_v<T>
  void item(const T& value) { append(&value, sizeof value); }
  void item(const std::string& text) {
    item(static_cast<std::uint64_t>(text.size()));
    append(text.data(), text.size());
  }
  void item(const Picture& picture) {
    item(picture.width);
    item(picture.height);
    item(static_cast<std::uint64_t>(picture.rgba.size()));
    append(picture.rgba.data(), picture.rgba.size());
  }
  template <class T>
  void item(const std::optional<T>& value) {
    item(static_cast<std::uint8_t>(value ? 1 : 0));
    if (value) item(*value);
  }
  template <class T>
  void item(const std::vector<T>& values) {
    item(static_cast<std::uint64_t>(values.size()));
    for (const T& value : values) item(value);
  }
  void item(const std::set<std::string>& texts) {
    item(static_cast<std::uint64_t>(texts.size()));
    for (const std::string& text : texts) item(text);
  }
  void item(const Account& account) { item(accountLines(account)); }
  void item(const RunCoverage& coverage) { both(*this, coverage); }
  void item(const PictureMask::Part& part) { both(*this, part); }
  void item(const AcceptedPicture& accepted) { both(*this, accepted); }
  void item(const Comparison& found) { both(*this, found); }
  void item(const Tolerance& tolerance) { both(*this, tolerance); }

  /// The fields of a value, shared by writer and reader so that they stay in step.
  template <class Wire, class Part>
  static void fields(Wire& wire, Part& part) requires
      std::is_same_v<std::remove_const_t<Part>, PictureMask::Part> {
    wire.item(part.name);
    wire.item(part.pixels);
  }
  template <class Wire, class Accepted>
  static void fields(Wire& wire, Accepted& accepted) requires
      std::is_same_v<std::remove_const_t<Accepted>, AcceptedPicture> {
    for (auto* text :
         {&accepted.key, &accepted.picture, &accepted.pixels, &accepted.inputs, &accepted.session,
          &accepted.accepted_by, &accepted.accepted_at, &accepted.reason, &accepted.areas,
          &accepted.areas_pixels, &accepted.cell, &accepted.decoded}) {
      wire.item(*text);
    }
    wire.item(accepted.coverage);
  }
  template <class Wire, class Coverage>
  static void fields(Wire& wire, Coverage& coverage) requires
      std::is_same_v<std::remove_const_t<Coverage>, RunCoverage> {
    wire.item(coverage.judged);
    wire.item(coverage.lost);
    wire.item(coverage.masked);
    wire.item(coverage.left_out);
  }
  template <class Wire, class Found>
  static void fields(Wire& wire,
                     Found& found) requires std::is_same_v<std::remove_const_t<Found>, Comparison> {
    wire.item(found.verdict);
    wire.item(found.rule);
    wire.item(found.max);
    wire.item(found.worst_x);
    wire.item(found.worst_y);
    wire.item(found.worst_frame);
    wire.item(found.worst_golden);
    wire.item(found.worst_tile_mean);
    wire.item(found.worst_tile_x);
    wire.item(found.worst_tile_y);
    wire.item(found.worst_tile_over);
    wire.item(found.differing);
    wire.item(found.over_1);
    wire.item(found.over_2);
    wire.item(found.over_8);
    wire.item(found.over_32);
    wire.item(found.masked);
    wire.item(found.fine_differing);
    wire.item(found.fine_max);
  }
  template <class Wire, class Limits>
  static void fields(Wire& wire, Limits& tolerance) requires
      std::is_same_v<std::remove_const_t<Limits>, Tolerance> {
    wire.item(tolerance.name);
    wire.item(tolerance.exact);
    wire.item(tolerance.tile_mean);
    wire.item(tolerance.tile_over);
    wire.item(tolerance.level);
    wire.item(tolerance.percent);
  }
  template <class Wire, class Judged>
  static void fields(Wire& wire, Judged& judged) requires
      std::is_same_v<std::remove_const_t<Judged>, JudgedFrame> {
    wire.item(judged.verdict);
    wire.item(judged.rule);
    wire.item(judged.tolerance);
    wire.item(judged.comparison);
    wire.item(judged.masks);
    wire.item(judged.coverage);
    wire.item(judged.key);
    wire.item(judged.pixels);
    wire.item(judged.inputs);
    wire.item(judged.session);
    wire.item(judged.decoded);
    wire.item(judged.golden);
    wire.item(judged.drawn);
    wire.item(judged.accepted);
    wire.item(judged.unmasked);
    wire.item(judged.areas);
    wire.item(judged.thumbnail);
    wire.item(judged.render_ms);
    wire.item(judged.judge_ms);
  }

  Bytes take() { return std::move(bytes_); }

 private:
  template <class Wire, class T>
  static void both(Wire& wire, T& value) {
    fields(wire, value);
  }
  void append(const void* data, std::size_t size) {
    const auto* begin = static_cast<const std::byte*>(data);
    bytes_.insert(bytes_.end(), begin, begin + size);
  }

  Bytes bytes_;
};

/// Reads the output of WireWriter; after the first fault it changes nothing.
class WireReader {
 public:
  explicit WireReader(ByteView bytes) : bytes_(bytes) {}

  template <class T>
  requires std::is_trivially_copyable_v<T>
  void item(T& value) { take(&value, sizeof value); }
  void item(std::string& text) {
    text.resize(length());
    take(text.data(), text.size());
  }
  void item(Picture& picture) {
    item(picture.width);
    item(picture.height);
    picture.rgba.resize(length());
    take(picture.rgba.data(), picture.rgba.size());
  }
  template <class T>
  void item(std::optional<T>& value) {
    std::uint8_t there = 0;
    item(there);
    // Read separately: with emplace(), g++ 14 warns that an uninitialized value is destroyed.
    std::optional<T> read;
    if (there != 0 && sound_) item(read.emplace());
    value = std::move(read);
  }
  template <class T>
  void item(std::vector<T>& values) {
    values.resize(length());
    for (T& value : values) item(value);
  }
  void item(std::set<std::string>& texts) {
    std::vector<std::string> read;
    item(read);
    texts = {read.begin(), read.end()};
  }
  void item(Account& account) {
    std::string lines;
    item(lines);
    account = accountOfLines(lines);
  }
  void item(RunCoverage& coverage) { WireWriter::fields(*this, coverage); }
  void item(PictureMask::Part& part) { WireWriter::fields(*this, part); }
  void item(AcceptedPicture& accepted) { WireWriter::fields(*this, accepted); }
  void item(Comparison& found) { WireWriter::fields(*this, found); }
  void item(Tolerance& tolerance) { WireWriter::fields(*this, tolerance); }

  bool readAll() const { return sound_ && bytes_.empty(); }

 private:
  /// Limited by the remaining bytes: each item takes at least one.
  std::size_t length() {
    std::uint64_t size = 0;
    item(size);
    if (size > bytes_.size()) sound_ = false;
    return sound_ ? static_cast<std::size_t>(size) : 0;
  }
  void take(void* data, std::size_t size) {
    if (size > bytes_.size()) sound_ = false;
    if (!sound_ || size == 0) return;
    std::memcpy(data, bytes_.data(), size);
    bytes_ = bytes_.subspan(size);
  }

  ByteView bytes_;
  bool sound_ = true;
};

}  // namespace

Bytes wireBytes(const JudgedFrame& judged) {
  WireWriter writer;
  WireWriter::fields(writer, judged);
  return writer.take();
}

Status readWire(ByteView bytes, JudgedFrame& judged) {
  WireReader reader(bytes);
  WireWriter::fields(reader, judged);
  if (reader.readAll()) return {};
  return Error{ErrorKind::damaged, "a job sent an incomplete judgement", {}};
}

}  // namespace rocinante
