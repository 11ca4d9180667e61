#include "core/packet/item_text.h"

#include <array>

#include "core/base/bytes.h"
#include "core/base/pattern.h"
#include "core/packet/packet_limits.h"
#include "core/packet/packet_text.h"

namespace rocinante {
namespace {

Statement about(StatementKind kind, std::string_view name) {
  Statement statement;
  statement.kind = kind;
  statement.name = name;
  return statement;
}

PathView viewOf(const Path& path) { return {path.first, path.second, path.is_layer}; }

}  // namespace

bool isAboutDevice(const Statement& statement, std::span<const std::string> patterns) {
  const auto named = [&](std::string_view name) {
    return !name.empty() && anyPatternMatches(patterns, name);
  };
  if (isOfPath(statement.kind) || isSignal(statement.kind)) {
    return !statement.path.is_layer && named(statement.path.first);
  }
  const bool is_of_device = isOfDevice(statement.kind) || statement.kind == StatementKind::seen;
  return (is_of_device && named(statement.name)) || named(statement.carrier.first);
}

std::string statementText(const PresenceItem& item) {
  const PresenceValue& value = item.item.value;
  const bool is_removed = value.presence == Presence::removed;
  Statement statement = about(is_removed ? StatementKind::remove : StatementKind::add, item.device);
  statement.text = value.model;
  statement.kinematics = value.kinematics;
  return statementText(statement);
}

std::string poseText(std::string_view device, const PoseValue& value) {
  const Vec3& p = value.pose.position;
  const Quat& q = value.pose.orientation;
  const std::array<double, 7> numbers = {p.x, p.y, p.z, q.x, q.y, q.z, q.w};
  Statement statement = about(StatementKind::pose, device);
  statement.numbers = numbers;
  statement.carrier = viewOf(value.carrier);
  return statementText(statement);
}

std::string jointsText(std::string_view device, const std::vector<double>& values) {
  Statement statement = about(StatementKind::joints, device);
  statement.numbers = values;
  return statementText(statement);
}

std::string orderText(std::string_view device, const std::vector<std::string>& names) {
  const std::vector<std::string_view> views(names.begin(), names.end());
  Statement statement = about(StatementKind::order, device);
  statement.names = views;
  return statementText(statement);
}

std::string jointText(std::string_view device, std::string_view name, double value) {
  Statement statement = about(StatementKind::joint, device);
  statement.names = std::span(&name, 1);
  statement.numbers = std::span(&value, 1);
  return statementText(statement);
}

std::string statementText(const VisibilityItem& item) {
  const Visibility::Kind kind = item.item.value.kind;
  const bool is_hidden = kind == Visibility::Kind::hidden;
  Statement statement = about(is_hidden ? StatementKind::hide : StatementKind::show, {});
  statement.path = viewOf(item.path);
  statement.is_default = kind == Visibility::Kind::by_default;
  return statementText(statement);
}

std::string statementText(const ColorItem& item) {
  const std::optional<std::uint32_t>& rgba = item.item.value.rgba;
  Statement statement = about(StatementKind::color, {});
  statement.path = viewOf(item.path);
  statement.is_default = !rgba;
  statement.rgba = rgba.value_or(0);
  return statementText(statement);
}

std::string statementText(const DrawingItem& item) {
  const Drawing& drawing = item.drawing;
  Statement statement = about(drawing.kind, item.id);
  statement.rgba = drawing.rgba;
  statement.carrier = viewOf(drawing.carrier);
  statement.text = drawing.text;
  statement.numbers = *drawing.parts[item.part];
  statement.part_index = static_cast<std::uint32_t>(item.part) + 1;
  statement.part_count = static_cast<std::uint32_t>(drawing.parts.size());
  const double default_px =
      drawing.kind == StatementKind::points ? limits::kDefaultPointPx : limits::kDefaultLinePx;
  if (drawing.size_px != default_px) statement.size_px = drawing.size_px;
  return statementText(statement);
}

std::string statementText(const SignalItem& item) {
  const SignalValue& value = item.item.value;
  const std::string_view name = item.name.name;
  Statement statement = about(StatementKind::signal, {});
  statement.path = {item.device, item.name.link, false};
  statement.names = std::span(&name, 1);
  statement.numbers = std::span(&value.number, 1);
  statement.signal_kinds = std::span(&value.kind, 1);
  statement.text = value.text;
  statement.unit = value.unit;
  return statementText(statement);
}

std::string signalNameText(std::string_view device, const SignalName& name) {
  const std::string of(device);
  std::string text = statementText(SignalItem{of, name, Item<SignalValue>()});
  text.resize(text.rfind(' '));
  return text;
}

std::optional<NamedSignal> signalNamed(std::string_view text) {
  if (!text.starts_with("signal ")) return std::nullopt;
  PacketTextDecoder decoder;
  const std::string packet = "RK1 - - -\n" + std::string(text) + " 0\n";
  const Packet* const read = decoder.decode(bytesOf(packet));
  if (read == nullptr || !read->faults.empty() || read->statements.size() != 1) return std::nullopt;
  const Statement& statement = read->statements.front();
  NamedSignal named{std::string(statement.path.first),
                    {std::string(statement.path.second), std::string(statement.names.front())}};
  return signalNameText(named.device, named.name) == text ? std::optional(std::move(named))
                                                          : std::nullopt;
}

std::string statementText(const ViewItem& item) {
  const ViewValue& value = item.item.value;
  const std::array<double, 10> numbers = {
      value.eye.x,    value.eye.y,   value.eye.z, value.target.x, value.target.y,
      value.target.z, value.fov_deg, value.up.x,  value.up.y,     value.up.z};
  Statement statement = about(StatementKind::view, item.name);
  statement.numbers = numbers;
  statement.ortho_height_m = value.ortho_height_m;
  statement.carrier = viewOf(value.carrier);
  return statementText(statement);
}

std::string seenText(std::string_view device, LogTime time) {
  Statement statement = about(StatementKind::seen, device);
  statement.seen_ns = time.time_since_epoch().count();
  return statementText(statement);
}

std::string sourceText(std::string_view name, const SourceState& source) {
  PacketHeader header;
  header.source = name;
  header.run = source.run;
  header.sequence = source.highest_sequence;
  header.time_ns = source.time_ns;
  return headerText(header).substr(4);
}

}  // namespace rocinante
