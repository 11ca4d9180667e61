#include "core/foreign/decode/packet_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/plain_text.h"
#include "core/math/transform.h"
#include "core/packet/packet_limits.h"
#include "core/packet/text_number.h"

namespace rocinante::decode {
namespace {

/// Whole numbers up to here are exact.
constexpr double kExact = 9007199254740992.0;

/// Bits of a whole number, of a negative one as two's complement has them.
std::optional<double> bitsOf(double number, unsigned first, unsigned many) {
  if (number != std::floor(number) || std::abs(number) > kExact) return std::nullopt;
  const auto whole = static_cast<std::uint64_t>(static_cast<std::int64_t>(number));
  return static_cast<double>((whole >> first) & ((std::uint64_t{1} << many) - 1));
}

Quat rotationOf(const PoseLine& line, const std::array<double, 3>& angles) {
  Quat whole(1, 0, 0, 0);
  for (std::size_t i = 0; i < 3; ++i) {
    Vec3 axis(0, 0, 0);
    axis[line.axes[i]] = 1;
    const Quat turn = quaternionAbout(axis, angles[i]);
    whole = line.fixed_axes ? turn * whole : whole * turn;
  }
  return whole;
}

}  // namespace

PacketLines::PacketLines(const Decoder& decoder)
    : decoder_(decoder),
      unusable_(decoder.fields.size()),
      counted_at_(decoder.fields.size()),
      no_name_(decoder.fields.size()),
      named_at_(decoder.fields.size()),
      unnamed_(decoder.signals.size()),
      rotations_(decoder.poses.size()) {}

void PacketLines::countUnusable(std::size_t field, const FieldValue& value) {
  if (std::exchange(counted_at_[field], datagrams_) == datagrams_) return;
  ++unusable_[field];
  const bool is_word = value.kind == FieldValue::Kind::text && isNotFiniteWord(value.text);
  if (value.is_infinite || is_word) not_finite_.push_back(field);
}

void PacketLines::countNoName(const TextTemplate& name, std::span<const FieldValue> values) {
  const bool is_filled = std::ranges::none_of(name.parts, [&](const TextTemplate::Part& part) {
    return part.field && values[*part.field].kind == FieldValue::Kind::missing;
  });
  for (const TextTemplate::Part& part : name.parts) {
    if (!part.field || (!is_filled && !values[*part.field].is_infinite)) continue;
    if (std::exchange(named_at_[*part.field], datagrams_) != datagrams_) ++no_name_[*part.field];
  }
}

std::optional<double> PacketLines::numberOrCount(const Term& term,
                                                 std::span<const FieldValue> values) {
  const std::optional<double> number = numberOf(term, values);
  if (!number) {
    const FieldValue& value = values[*term.field];
    if (value.kind != FieldValue::Kind::missing || value.is_infinite) {
      countUnusable(*term.field, value);
    }
  }
  return number;
}

template <std::size_t count>
std::optional<std::array<double, count>> PacketLines::numbersOf(
    const std::array<Term, count>& terms, std::span<const FieldValue> values) {
  std::array<double, count> numbers{};
  for (std::size_t i = 0; i < count; ++i) {
    const std::optional<double> number = numberOrCount(terms[i], values);
    if (!number) return std::nullopt;
    numbers[i] = *number;
  }
  return numbers;
}

std::optional<double> numberOf(const Term& term, std::span<const FieldValue> values) {
  if (!term.field) return term.plus;
  const std::optional<double> number = values[*term.field].asNumber();
  if (!number) return std::nullopt;
  const double result = *number * term.times + term.plus;
  if (!std::isfinite(result)) return std::nullopt;
  return result;
}

std::string valueText(const FieldValue& value) {
  std::string text;
  if (value.kind == FieldValue::Kind::text) text = value.text;
  if (value.kind == FieldValue::Kind::number) appendNumber(text, value.number);
  return text;
}

bool appendTemplate(std::string& text, const TextTemplate& of, std::span<const FieldValue> values) {
  for (const TextTemplate::Part& part : of.parts) {
    text += part.text;
    if (!part.field) continue;
    const FieldValue& value = values[*part.field];
    if (value.kind == FieldValue::Kind::missing) return false;
    if (value.kind == FieldValue::Kind::text) text += value.text;
    if (value.kind == FieldValue::Kind::number) appendNumber(text, value.number);
  }
  return true;
}

bool PacketLines::fillName(const TextTemplate& name, std::span<const FieldValue> values) {
  name_.clear();
  // A stranger's text may be anything.
  if (appendTemplate(name_, name, values) && isName(name_)) return true;
  countNoName(name, values);
  return false;
}

bool PacketLines::fillPath(PathView& path, const TextTemplate& of,
                           std::span<const FieldValue> values) {
  path_.clear();
  bool is_path = appendTemplate(path_, of, values);
  if (is_path && path_ != "-") {
    const std::string_view filled = path_;
    const std::size_t slash = filled.find('/');
    path.first = filled.substr(0, slash);
    if (slash != filled.npos) path.second = filled.substr(slash + 1);
    is_path = isName(path.first) && (slash == filled.npos || isName(path.second));
  }
  if (!is_path) countNoName(of, values);
  return is_path;
}

void PacketLines::addJoints(PacketTextWriter& packet, const JointsLine& line,
                            std::span<const FieldValue> values) {
  if (!fillName(line.device, values)) return;
  joints_.clear();
  numbers_.clear();
  for (const JointsLine::Joint& joint : line.joints) {
    const std::optional<double> number = numberOrCount(joint.value, values);
    if (!number) continue;
    joints_.push_back(joint.name);
    numbers_.push_back(*number);
  }
  if (joints_.empty()) return;
  Statement statement;
  statement.kind = StatementKind::joint;
  statement.name = name_;
  statement.names = joints_;
  statement.numbers = numbers_;
  packet.add(statement);
}

void PacketLines::addPose(PacketTextWriter& packet, std::size_t number,
                          std::span<const FieldValue> values) {
  const PoseLine& line = decoder_.poses[number];
  if (!fillName(line.device, values)) return;
  const auto position = numbersOf(line.position, values);
  if (!position) return;
  std::optional<Quat> rotation = Quat(1, 0, 0, 0);
  if (line.rotation == PoseLine::Rotation::euler) {
    const auto angles = numbersOf(line.angles, values);
    if (!angles) return;
    rotation = normalized(rotationOf(line, *angles));
  } else if (line.rotation == PoseLine::Rotation::quaternion) {
    const auto q = numbersOf(line.quaternion, values);
    if (!q) return;
    const Quat given((*q)[3], (*q)[0], (*q)[1], (*q)[2]);
    rotation = normalized(given);
    Rotations& its = rotations_[number];
    if (!rotation) {
      ++its.zero;
    } else if (!isUnitLength(given) && its.off_unit++ == 0) {
      its.first_length = lengthOf(given);
    }
  }
  if (!rotation) return;
  const std::array<double, 7> numbers = {(*position)[0], (*position)[1], (*position)[2],
                                         rotation->x,    rotation->y,    rotation->z,
                                         rotation->w};
  Statement statement;
  statement.kind = StatementKind::pose;
  statement.name = name_;
  statement.numbers = numbers;
  packet.add(statement);
}

void PacketLines::addSignal(PacketTextWriter& packet, std::size_t line,
                            std::span<const FieldValue> values) {
  const SignalLine& its = decoder_.signals[line];
  const std::size_t field = *its.value.field;
  const FieldValue& value = values[field];
  if (value.kind == FieldValue::Kind::missing && !value.is_infinite) return;
  Statement statement;
  statement.kind = StatementKind::signal;
  double number = 0;
  SignalKind kind = SignalKind::number;
  if (its.is_text || (!its.words.empty() && its.bits == 0)) {
    text_ = valueText(value);
  } else {
    std::optional<double> read = its.bits > 0 ? value.asNumber() : numberOf(its.value, values);
    if (read && its.bits > 0) {
      read = bitsOf(*read, its.first_bit, its.bits);
      if (read) read = *read * its.value.times + its.value.plus;
    }
    if (!read || !std::isfinite(*read)) return countUnusable(field, value);
    number = *read;
    if (its.is_boolean) kind = SignalKind::boolean;
    if (!its.words.empty()) text_ = valueText(FieldValue::of(number));
  }
  if (its.is_text || !its.words.empty()) {
    kind = SignalKind::text;
    // A stranger's text may be longer than a signal's; bytes that are not UTF-8 become three.
    const bool is_utf8 = isUtf8(rocinante::bytesOf(text_));
    const std::size_t room = is_utf8 ? limits::kStringBytes : limits::kStringBytes / 3;
    if (value.is_infinite || text_.size() > room) return countUnusable(field, value);
    number = 0;
    statement.text = text_;
  }
  if (!its.words.empty()) {
    auto word = its.words.find(text_);
    // "01" is named by "1".
    if (word == its.words.end()) {
      if (const auto spelt = value.asNumber(); spelt && its.bits == 0) {
        word = its.words.find(valueText(FieldValue::of(*spelt)));
      }
    }
    if (word != its.words.end()) {
      statement.text = word->second;
    } else {
      ++unnamed_[line];
    }
  }
  if (!fillPath(statement.path, its.path, values) || !fillName(its.name, values)) return;
  const std::string_view name = name_;
  statement.names = std::span(&name, 1);
  statement.numbers = std::span(&number, 1);
  statement.signal_kinds = std::span(&kind, 1);
  statement.unit = its.unit;
  packet.add(statement);
}

void PacketLines::add(PacketTextWriter& packet, std::span<const FieldValue> values,
                      std::span<const std::string> before) {
  ++datagrams_;
  not_finite_.clear();
  for (const JointsLine& line : decoder_.joints) addJoints(packet, line, values);
  for (std::size_t i = 0; i < decoder_.poses.size(); ++i) addPose(packet, i, values);
  for (std::size_t i = 0; i < decoder_.signals.size(); ++i) addSignal(packet, i, values);
  for (std::size_t i = 0; i < decoder_.events.size() && i < before.size(); ++i) {
    const EventLine& line = decoder_.events[i];
    if (values[line.changes].kind == FieldValue::Kind::missing || before[i].empty()) continue;
    if (valueText(values[line.changes]) == before[i]) continue;
    name_.clear();
    if (!appendTemplate(name_, line.text, values)) continue;
    name_.resize(std::min(name_.size(), limits::kStringBytes / 4));
    Statement statement;
    statement.kind = StatementKind::event;
    statement.text = name_;
    packet.add(statement);
  }
}

}  // namespace rocinante::decode
