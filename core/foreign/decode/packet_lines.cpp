#include "core/foreign/decode/packet_lines.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/math/transform.h"
#include "core/packet/packet_limits.h"
#include "core/packet/text_number.h"

namespace rocinante::decode {
namespace {

template <std::size_t count>
std::optional<std::array<double, count>> numbersOf(const std::array<Term, count>& terms,
                                                   std::span<const FieldValue> values) {
  std::array<double, count> numbers{};
  for (std::size_t i = 0; i < count; ++i) {
    const std::optional<double> number = numberOf(terms[i], values);
    if (!number) return std::nullopt;
    numbers[i] = *number;
  }
  return numbers;
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
  return appendTemplate(name_, name, values) && isName(name_);
}

void PacketLines::addJoints(PacketTextWriter& packet, const JointsLine& line,
                            std::span<const FieldValue> values) {
  if (!fillName(line.device, values)) return;
  joints_.clear();
  numbers_.clear();
  for (const JointsLine::Joint& joint : line.joints) {
    const std::optional<double> number = numberOf(joint.value, values);
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

void PacketLines::addPose(PacketTextWriter& packet, const PoseLine& line,
                          std::span<const FieldValue> values) {
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
    rotation = normalized(Quat((*q)[3], (*q)[0], (*q)[1], (*q)[2]));
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

void PacketLines::add(PacketTextWriter& packet, std::span<const FieldValue> values,
                      std::span<const std::string> before) {
  for (const JointsLine& line : decoder_.joints) addJoints(packet, line, values);
  for (const PoseLine& line : decoder_.poses) addPose(packet, line, values);
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
