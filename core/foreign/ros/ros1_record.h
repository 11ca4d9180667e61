#pragma once

#include <concepts>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/bytes.h"

/// The records of a ROS 1 bag, format 2.0 (https://wiki.ros.org/Bags/Format/2.0).
namespace rocinante::ros {

inline constexpr std::string_view kRos1Magic = "#ROSBAG V2.0\n";

enum class Ros1Op : std::uint8_t {
  message = 2,
  bag_header = 3,
  index = 4,
  chunk = 5,
  chunk_info = 6,
  connection = 7,
};

using Ros1Fields = std::vector<std::pair<std::string_view, ByteView>>;

/// The fields of a record's header, as far as they are whole: u32 length, NAME=VALUE. Borrowed.
Ros1Fields ros1Fields(ByteView header);
std::optional<ByteView> ros1Field(const Ros1Fields& fields, std::string_view name);

/// A record: u32 length and header, u32 length and data. Borrowed.
struct Ros1Record {
  Ros1Op op{};
  bool is_cut = false;  ///< the bytes end within its data
  std::size_t offset = 0;
  std::size_t end = 0;
  Ros1Fields fields;
  ByteView data;

  std::optional<ByteView> field(std::string_view name) const { return ros1Field(fields, name); }
  /// A field of exactly this size, little-endian.
  template <std::unsigned_integral T>
  std::optional<T> number(std::string_view name) const {
    const std::optional<ByteView> value = field(name);
    if (!value || value->size() != sizeof(T)) return std::nullopt;
    T result;
    std::memcpy(&result, value->data(), sizeof(T));
    return result;
  }
};

/// Empty when a length reaches past the end, or the header has no op.
std::optional<Ros1Record> ros1RecordAt(ByteView bytes, std::size_t offset);
/// The same, but of a record that is cut, the data that are there. Empty when its header is cut.
std::optional<Ros1Record> wholeOrCutRos1RecordAt(ByteView bytes, std::size_t offset);

}  // namespace rocinante::ros
