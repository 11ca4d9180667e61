#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

/// The messages whose fields become signals, as declarations: one more type is one more row
/// (docs/other-formats.md, "Signals"). Definitions: https://docs.ros.org, packages
/// common_interfaces and std_msgs. Units are those of the definitions and of REP 103.
namespace rocinante::ros {

/// How a field is stored.
enum class Wire : std::uint8_t {
  boolean,
  i8,
  u8,
  i16,
  u16,
  i32,
  u32,
  i64,
  u64,
  f32,
  f64,
  text,
  header,    ///< std_msgs/Header: the stamp, and the frame that the signals belong to
  layout,    ///< std_msgs/MultiArrayLayout
  status,    ///< diagnostic_msgs/DiagnosticStatus
  statuses,  ///< a sequence of them
};

/// What becomes of a field.
enum class FieldUse : std::uint8_t {
  signal,
  boolean,     ///< a signal that is true unless the number is 0
  frame,       ///< names the frame that the signals belong to, in place of the header's
  covariance,  ///< counted where it is not zero
  confidence,  ///< the same, and -1 in front: the sender does not know the field before it
  elsewhere,   ///< another statement has it
};

/// The count of a field whose length is in the message.
inline constexpr std::uint32_t kSequence = 0;
/// Elements of a sequence that become signals, NAME.0 and on; the others are counted.
inline constexpr std::uint32_t kMaxElements = 64;

/// The name of a field that is the whole message.
inline constexpr std::string_view kWhole = "data";

struct SignalField {
  Wire wire = Wire::f64;
  std::string_view name{};   ///< behind the topic in a signal's name; kWhole: the topic alone
  std::string_view unit{};   ///< empty: none
  std::string_view parts{};  ///< of a vector, one letter each: NAME.x, NAME.y
  FieldUse use = FieldUse::signal;
  std::uint32_t count = 1;   ///< of a covariance's array, or kSequence
  std::string_view words{};  ///< of an u8 that enumerates, from 0, between blanks: a text
};

struct SignalMessage {
  std::string_view type;  ///< "sensor_msgs/Imu"
  std::vector<SignalField> fields;
};

/// The rows of a type, newest definition first; empty for a type without signals. Those of one type
/// follow each other.
std::span<const SignalMessage> signalMessages(std::string_view type);
/// All rows.
std::span<const SignalMessage> allSignalMessages();

}  // namespace rocinante::ros
