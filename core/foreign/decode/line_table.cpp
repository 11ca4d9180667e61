#include "core/foreign/decode/line_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/foreign/decode/toml_values.h"
#include "core/math/trigonometry.h"
#include "core/packet/packet_limits.h"

namespace rocinante::decode {

void LineTable::read(TomlTable& decoder_table) {
  using Reader = void (LineTable::*)(TomlTable&);
  const auto readAll = [&](const char* key, const char* what, Reader reader) {
    for (TomlTable& table : decoder_table.tables(key, what)) {
      if (++lines_ > kMaxLines) {
        if (lines_ == kMaxLines + 1) {
          faults_.error(kBadValue, table.place(),
                        fmt::format("a decoder has at most {} lines", kMaxLines));
        }
        return;
      }
      (this->*reader)(table);
      table.finish();
    }
  };
  readAll("joint", "[[decoder.joint]]", &LineTable::readJoint);
  readAll("joints", "[[decoder.joints]]", &LineTable::readJoints);
  readAll("pose", "[[decoder.pose]]", &LineTable::readPose);
  readAll("event", "[[decoder.event]]", &LineTable::readEvent);
  if (decoder_.joints.empty() && decoder_.poses.empty() && decoder_.events.empty() && lines_ == 0) {
    faults_.error(
        "decoder.no-lines", decoder_.place,
        fmt::format("decoder {} makes nothing of its fields", quotedInFault(decoder_.name)),
        "add [[decoder.joint]], [[decoder.joints]], [[decoder.pose]] or "
        "[[decoder.event]]");
  }
}

LineTable::Scale LineTable::scaleOf(TomlTable& table) {
  Scale scale;
  scale.times = table.number("times").value_or(1.0);
  scale.plus = table.number("plus").value_or(0.0);
  if (table.flag("degrees").value_or(false)) {
    scale.times = radiansOf(scale.times);
    scale.plus = radiansOf(scale.plus);
  }
  return scale;
}

void LineTable::addJoint(const TextTemplate& device, std::string joint, Term value) {
  const auto same = [&](const JointsLine& line) { return line.device == device; };
  auto line = std::ranges::find_if(decoder_.joints, same);
  if (line == decoder_.joints.end()) {
    line = decoder_.joints.insert(decoder_.joints.end(), JointsLine{device, {}});
  }
  line->joints.push_back({std::move(joint), value});
}

void LineTable::readJoint(TomlTable& table) {
  const auto device = templateAt(table, "device");
  const auto joint = table.requiredName("joint");
  const auto field = table.requiredText("field");
  const Scale scale = scaleOf(table);
  const auto index = field ? fields_.find(*field, table.place("field")) : std::nullopt;
  if (!device || !joint || !index) return;
  addJoint(*device, *joint, {index, scale.times, scale.plus});
}

void LineTable::readJoints(TomlTable& table) {
  const auto device = templateAt(table, "device");
  const std::vector<std::string> joints = table.texts("joints");
  const std::vector<std::string> fields = table.texts("fields");
  const Scale scale = scaleOf(table);
  if (joints.empty() || joints.size() != fields.size() || joints.size() > limits::kJointValues) {
    table.error(kBadValue, "fields",
                fmt::format("{} joints have {} fields", joints.size(), fields.size()),
                "name one field for each joint");
    return;
  }
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const auto index = fields_.find(fields[i], table.place("fields"));
    if (joints[i].empty() || joints[i].size() > limits::kNameBytes) {
      table.error(kBadValue, "joints", quotedInFault(joints[i]) + " is not a valid name");
      return;
    }
    if (device && index) addJoint(*device, joints[i], {index, scale.times, scale.plus});
  }
}

/// Texts are fields, with - in front turned round; numbers are constants. All are scaled.
std::optional<std::vector<Term>> LineTable::termsAt(TomlTable& table, std::string_view key,
                                                    std::size_t count, double times) {
  const TomlNode* const array = table.node(key);
  if (array == nullptr) return std::nullopt;
  if (array->kind != TomlNode::Kind::array || array->items.size() != count) {
    table.error(kBadValue, key, fmt::format("`{}` is an array of {}", key, count),
                "each is the name of a field, or a number");
    return std::nullopt;
  }
  std::vector<Term> terms;
  for (const TomlNode& item : array->items) {
    if (item.kind == TomlNode::Kind::text) {
      const bool negated = item.text.starts_with('-');
      const auto index =
          fields_.find(std::string_view(item.text).substr(negated ? 1 : 0), item.place);
      if (!index) return std::nullopt;
      terms.push_back({index, negated ? -times : times, 0});
    } else if ((item.kind == TomlNode::Kind::integer || item.kind == TomlNode::Kind::number) &&
               std::isfinite(item.number)) {
      terms.push_back({std::nullopt, 1, item.number * times});
    } else {
      faults_.error(
          kBadValue, item.place,
          fmt::format("an element of `{}` is neither the name of a field nor a number", key));
      return std::nullopt;
    }
  }
  return terms;
}

void LineTable::readPose(TomlTable& table) {
  PoseLine line;
  const auto device = templateAt(table, "device");
  const double scale = table.number("position_times").value_or(1.0);
  if (const auto position = termsAt(table, "position", 3, scale)) {
    std::ranges::copy(*position, line.position.begin());
  } else if (!table.has("position") && !table.has("euler") && !table.has("quaternion")) {
    table.error("decoder.missing-key", "device",
                "a pose needs `position`, `euler` or `quaternion`");
  }
  if (table.has("euler") && table.has("quaternion")) {
    table.error(kBadValue, "euler", "a pose has `euler` or `quaternion`, not both");
  }
  if (table.has("quaternion")) {
    line.rotation = PoseLine::Rotation::quaternion;
    const auto order = choiceAt(table, "quaternion_order", {"xyzw", "wxyz"});
    if (const auto terms = termsAt(table, "quaternion", 4, 1.0)) {
      const std::size_t shift = order.value_or(0) == 1 ? 1 : 0;
      for (std::size_t i = 0; i < 4; ++i) line.quaternion[i] = (*terms)[(i + shift) % 4];
    }
  } else if (table.has("euler")) {
    readEuler(table, line);
  }
  if (!device) return;
  line.device = *device;
  decoder_.poses.push_back(std::move(line));
}

void LineTable::readEuler(TomlTable& table, PoseLine& line) {
  line.rotation = PoseLine::Rotation::euler;
  const bool degrees = table.flag("degrees").value_or(false);
  if (const auto terms = termsAt(table, "euler", 3, degrees ? radiansOf(1.0) : 1.0)) {
    std::ranges::copy(*terms, line.angles.begin());
  }
  const auto about = choiceAt(table, "euler_axes", {"fixed", "turned"});
  line.fixed_axes = about.value_or(0) == 0;
  const std::string order = table.text("euler_order").value_or("xyz");
  const bool sound = order.size() == 3 && order.find_first_not_of("xyz") == order.npos &&
                     order[0] != order[1] && order[1] != order[2];
  if (!sound) {
    table.error(kBadValue, "euler_order",
                quotedInFault(order) + " is not an order of three rotations",
                "one looks like \"xyz\" or \"zyx\": the axes in the order of `euler`");
    return;
  }
  for (std::size_t i = 0; i < 3; ++i) line.axes[i] = order[i] - 'x';
}

void LineTable::readEvent(TomlTable& table) {
  EventLine line;
  const auto text = templateAt(table, "text");
  const auto changes = table.requiredText("changes");
  const auto index = changes ? fields_.find(*changes, table.place("changes")) : std::nullopt;
  if (!text || !index) return;
  line.text = *text;
  line.changes = *index;
  decoder_.events.push_back(std::move(line));
}

/// "ship-{id}": {{ and }} are braces.
std::optional<TextTemplate> LineTable::templateAt(TomlTable& table, std::string_view key) {
  const std::optional<std::string> text = table.requiredText(key);
  if (!text) return std::nullopt;
  TextTemplate made;
  std::string literal;
  for (std::size_t at = 0; at < text->size(); ++at) {
    const char each = (*text)[at];
    const bool doubled = at + 1 < text->size() && (*text)[at + 1] == each;
    if ((each == '{' || each == '}') && doubled) {
      literal += each;
      ++at;
    } else if (each == '{' || each == '}') {
      const std::size_t end = text->find('}', at);
      if (each == '}' || end == text->npos) {
        table.error(kBadValue, key, fmt::format("a brace of `{}` has no other one", key),
                    "write {{ and }} for braces");
        return std::nullopt;
      }
      const auto index = fields_.find(text->substr(at + 1, end - at - 1), table.place(key));
      if (!index) return std::nullopt;
      made.parts.push_back({std::exchange(literal, {}), index});
      at = end;
    } else {
      literal += each;
    }
  }
  if (!literal.empty()) made.parts.push_back({std::move(literal), std::nullopt});
  return made;
}

}  // namespace rocinante::decode
