#pragma once

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/bytes.h"
#include "core/foreign/ros/field_cursor.h"

namespace rocinante::ros::test {

/// Writes ROS messages field by field, in either serialization and byte order.
class MessageMaker {
 public:
  enum class Kind { cdr_little, cdr_big, cdr2_little, ros1 };

  explicit MessageMaker(Kind kind) : kind_(kind) {
    if (kind == Kind::ros1) return;
    const auto name = kind == Kind::cdr_big ? 0 : kind == Kind::cdr_little ? 1 : 7;
    bytes_ = {std::byte{0}, std::byte(name), std::byte{0}, std::byte{0}};
  }

  FieldCursor::Layout layout() const {
    return isRos1() ? FieldCursor::Layout::ros1 : FieldCursor::Layout::cdr;
  }
  bool isRos1() const { return kind_ == Kind::ros1; }

  template <class T>
  MessageMaker& number(T value) {
    const std::size_t largest = isRos1() ? 1 : kind_ == Kind::cdr2_little ? 4 : 8;
    while (!isRos1() && (bytes_.size() - 4) % std::min(sizeof(T), largest) != 0) {
      bytes_.push_back(std::byte{0xEE});
    }
    std::array<std::byte, sizeof(T)> raw;
    std::memcpy(raw.data(), &value, sizeof(T));
    if (kind_ == Kind::cdr_big) std::reverse(raw.begin(), raw.end());
    bytes_.insert(bytes_.end(), raw.begin(), raw.end());
    return *this;
  }
  MessageMaker& numbers(const std::vector<double>& values) {
    number(static_cast<std::uint32_t>(values.size()));
    for (const double value : values) number(value);
    return *this;
  }
  /// Without a count.
  MessageMaker& doubles(const std::vector<double>& values) {
    for (const double value : values) number(value);
    return *this;
  }
  MessageMaker& string(std::string_view text) {
    number(static_cast<std::uint32_t>(text.size() + (isRos1() ? 0 : 1)));
    const ByteView raw = bytesOf(text);
    bytes_.insert(bytes_.end(), raw.begin(), raw.end());
    if (!isRos1()) bytes_.push_back(std::byte{0});
    return *this;
  }
  MessageMaker& strings(const std::vector<std::string>& texts) {
    number(static_cast<std::uint32_t>(texts.size()));
    for (const std::string& text : texts) string(text);
    return *this;
  }
  MessageMaker& header(std::int32_t seconds, std::uint32_t nanoseconds, std::string_view frame) {
    if (isRos1()) number(std::uint32_t{77});
    number(seconds);
    number(nanoseconds);
    return string(frame);
  }

  const Bytes& bytes() const { return bytes_; }

 private:
  Kind kind_;
  Bytes bytes_;
};

using Kind = MessageMaker::Kind;

inline Bytes jointState(Kind kind, std::int32_t seconds, const std::vector<std::string>& names,
                        const std::vector<double>& positions) {
  MessageMaker made(kind);
  made.header(seconds, 500'000'000, "").strings(names).numbers(positions);
  return made.numbers({}).numbers({}).bytes();
}

struct TestTransform {
  std::string parent, child;
  std::vector<double> numbers;  ///< x y z qx qy qz qw
};

inline Bytes transforms(Kind kind, const std::vector<TestTransform>& all) {
  MessageMaker made(kind);
  made.number(static_cast<std::uint32_t>(all.size()));
  for (const TestTransform& each : all) {
    made.header(7, 0, each.parent).string(each.child).doubles(each.numbers);
  }
  return made.bytes();
}

struct TestMarker {
  std::string frame = "world", space = "plan";
  std::int32_t id = 3, type = 4, action = 0;
  std::vector<double> pose{0, 0, 0, 0, 0, 0, 1};
  std::vector<double> points{};
  std::string text{};
  std::int32_t lifetime_s = 0;
  bool textured = true;
};

inline void addMarker(MessageMaker& made, const TestMarker& marker) {
  made.header(9, 0, marker.frame).string(marker.space);
  made.number(marker.id).number(marker.type).number(marker.action);
  made.doubles(marker.pose).doubles({0.01, 0, 0});
  for (const float component : {1.0F, 0.5F, 0.0F, 1.0F}) made.number(component);
  made.number(marker.lifetime_s).number(std::uint32_t{0}).number(std::uint8_t{0});
  made.number(static_cast<std::uint32_t>(marker.points.size() / 3)).doubles(marker.points);
  made.number(std::uint32_t{0});  // colors
  if (marker.textured && !made.isRos1()) {
    made.string("").header(0, 0, "").string("").number(std::uint32_t{0}).number(std::uint32_t{0});
  }
  made.string(marker.text).string("");
  if (marker.textured && !made.isRos1()) made.string("").number(std::uint32_t{0});
  made.number(std::uint8_t{0});
}

inline Bytes marker(Kind kind, const TestMarker& one) {
  MessageMaker made(kind);
  addMarker(made, one);
  return made.bytes();
}

}  // namespace rocinante::ros::test
