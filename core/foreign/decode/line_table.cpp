#include "core/foreign/decode/line_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/foreign/decode/toml_values.h"
#include "core/math/trigonometry.h"
#include "core/packet/packet_limits.h"
#include "core/packet/packet_text.h"

namespace rocinante::decode {
namespace {

/// Numbers are doubles: beyond 2^53 their bits are not exact.
constexpr std::int64_t kMaxBit = 52;

/// Whether no field is in it.
bool hasFixedText(const TextTemplate& of) {
  return std::ranges::none_of(of.parts, [](const auto& part) { return part.field.has_value(); });
}
std::string_view fixedText(const TextTemplate& of) {
  return of.parts.empty() ? std::string_view() : std::string_view(of.parts.front().text);
}

}  // namespace

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
  readAll("signal", "[[decoder.signal]]", &LineTable::readSignal);
  readAll("signals", "[[decoder.signals]]", &LineTable::readSignals);
  readAll("event", "[[decoder.event]]", &LineTable::readEvent);
  if (lines_ == 0) {
    faults_.error(
        "decoder.no-lines", decoder_.place,
        fmt::format("decoder {} makes nothing of its fields", quotedInFault(decoder_.name)),
        "add [[decoder.joint]], [[decoder.joints]], [[decoder.pose]], [[decoder.signal]] or "
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

void LineTable::readSignal(TomlTable& table) {
  SignalLine line;
  const auto name = templateAt(table, "name");
  const auto field = table.requiredText("field");
  const auto index = field ? fields_.find(*field, table.place("field")) : std::nullopt;
  line.is_text = table.flag("text").value_or(false);
  readNumber(table, line);
  readBits(table, line);
  readWords(table, line);
  const bool is_number = !line.is_text && !line.is_boolean && line.words.empty();
  for (const char* const key : {"unit", "scale", "offset"}) {
    if (!is_number && table.has(key)) {
      table.error(kBadValue, key, fmt::format("`{}` is of a number, and this signal is none", key),
                  "`text`, `bit` and `values` make states");
    }
  }
  if (line.is_text && (line.bits > 0 || !line.words.empty())) {
    table.error(kBadValue, "text", "`text` is the field as it is, without `bit`, `bits`, `values`");
  }
  if (name && hasFixedText(*name) && !isName(fixedText(*name))) {
    table.error(kBadValue, "name", quotedInFault(fixedText(*name)) + " is not a valid name");
  }
  if (!readPath(table, line) || !name || !index) return;
  line.name = *name;
  line.value.field = index;
  decoder_.signals.push_back(std::move(line));
}

void LineTable::readSignals(TomlTable& table) {
  SignalLine line;
  const bool has_path = readPath(table, line);
  const std::vector<std::string> names = table.texts("names");
  const std::vector<std::string> fields = table.texts("fields");
  readNumber(table, line);
  if (names.empty() || names.size() != fields.size() || names.size() > limits::kSignalValues) {
    table.error(kBadValue, "fields",
                fmt::format("{} signals have {} fields", names.size(), fields.size()),
                "name one field for each signal");
    return;
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto index = fields_.find(fields[i], table.place("fields"));
    if (!isName(names[i])) {
      table.error(kBadValue, "names", quotedInFault(names[i]) + " is not a valid name");
      return;
    }
    if (!has_path || !index) continue;
    line.name = {{{names[i], std::nullopt}}};
    line.value.field = index;
    decoder_.signals.push_back(line);
  }
}

bool LineTable::readPath(TomlTable& table, SignalLine& line) {
  const auto path = templateAt(table, "path");
  if (!path) return false;
  line.path = *path;
  const std::string_view text = fixedText(*path);
  const std::size_t slash = text.find('/');
  const bool has_link = slash != text.npos;
  const bool is_path =
      isName(text.substr(0, slash)) && (!has_link || isName(text.substr(slash + 1)));
  if (!hasFixedText(*path) || is_path) return true;
  table.error(kBadValue, "path", quotedInFault(text) + " is not DEVICE, DEVICE/LINK or -");
  return false;
}

void LineTable::readNumber(TomlTable& table, SignalLine& line) {
  line.value.times = table.number("scale").value_or(1.0);
  line.value.plus = table.number("offset").value_or(0.0);
  line.unit = table.text("unit").value_or("");
  if (table.has("unit") && !isUnit(line.unit)) {
    table.error(kBadValue, "unit",
                quotedInFault(line.unit) +
                    " is not 1 to 32 printable ASCII characters without spaces and quotes",
                unitHint(line.unit));
  }
}

/// `bit = 3`, or `bits = [first, how many]` as of a field.
void LineTable::readBits(TomlTable& table, SignalLine& line) {
  if (const auto bit = wholeAt(table, "bit", 0, kMaxBit)) {
    line.is_boolean = true;
    line.first_bit = static_cast<unsigned>(*bit);
    line.bits = 1;
  }
  const TomlNode* const bits = table.node("bits");
  if (bits == nullptr) return;
  if (table.has("bit")) table.error(kBadValue, "bits", "give `bit` or `bits`, not both");
  if (bits->kind != TomlNode::Kind::array || bits->items.size() != 2) {
    table.error(kBadValue, "bits", "`bits` is [first, how many]", "bit 0 is the least significant");
    return;
  }
  const auto first = wholeOf(bits->items[0], "bits", 0, kMaxBit, faults_);
  if (!first) return;
  const auto many = wholeOf(bits->items[1], "bits", 1, kMaxBit + 1 - *first, faults_);
  line.first_bit = static_cast<unsigned>(*first);
  line.bits = static_cast<unsigned>(many.value_or(1));
}

void LineTable::readWords(TomlTable& table, SignalLine& line) {
  const TomlNode* const words = table.node("values");
  if (words == nullptr) return;
  if (words->kind != TomlNode::Kind::table || words->entries.empty()) {
    table.error(kBadValue, "values", "`values` is a table: { \"0\" = \"idle\" }");
    return;
  }
  if (line.is_boolean)
    table.error(kBadValue, "values", "a `bit` is true or false, without `values`");
  for (const TomlNode::Entry& entry : words->entries) {
    const bool is_text = entry.value.kind == TomlNode::Kind::text;
    if (is_text && entry.value.text.size() <= limits::kStringBytes) {
      line.words.emplace(entry.key, entry.value.text);
    } else {
      faults_.error(kBadValue, entry.value.place,
                    "each of `values` is a text of at most 4096 bytes");
    }
  }
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
