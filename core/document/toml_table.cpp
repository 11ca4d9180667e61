#include "core/document/toml_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/base/hex_digit.h"
#include "core/base/name_hint.h"
#include "core/document/fault_list.h"
#include "core/math/transform.h"
#include "core/math/trigonometry.h"

namespace rocinante {
namespace {

constexpr std::size_t kLongestName = 255;

/// Scaled to unit length, unless the length is already 1 within rounding: a rotation that a program
/// wrote is then read back to the bit.
template <class T>
std::optional<T> unitOf(const T& given, double length_squared) {
  constexpr double kRounding = 2e-15;
  if (std::abs(length_squared - 1.0) <= kRounding) return given;
  return normalized(given);
}

bool isNumber(const TomlNode& node) {
  return node.kind == TomlNode::Kind::integer || node.kind == TomlNode::Kind::number;
}

}  // namespace

std::string tomlText(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      quoted += '\\';
      quoted += c;
    } else if (byte < 0x20 || byte == 0x7F) {
      quoted += fmt::format("\\u{:04X}", byte);
    } else {
      quoted += c;
    }
  }
  return quoted + "\"";
}

const TomlNode* TomlTable::find(std::string_view key) const {
  for (const TomlNode::Entry& entry : node_->entries) {
    if (entry.key == key) return &entry.value;
  }
  return nullptr;
}

const TomlNode* TomlTable::node(std::string_view key) {
  if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.emplace_back(key);
  return find(key);
}

const TomlNode* TomlTable::find(std::string_view key, TomlNode::Kind kind) {
  const TomlNode* value = node(key);
  if (value == nullptr || value->kind == kind) return value;
  if (kind == TomlNode::Kind::number && value->kind == TomlNode::Kind::integer) return value;
  faults_->error("cell.wrong-kind", value->place,
                 fmt::format("`{}` of {} is {}, where {} is expected", key, what_,
                             nameOf(value->kind), nameOf(kind)));
  return nullptr;
}

Place TomlTable::place(std::string_view key) const {
  const TomlNode* value = find(key);
  return value == nullptr ? place() : value->place;
}

bool TomlTable::has(std::string_view key) const { return find(key) != nullptr; }

void TomlTable::missing(std::string_view key) const {
  if (has(key)) return;  // it has the wrong type, already reported
  faults_->error("cell.missing-key", place(), fmt::format("{} lacks `{}`", what_, key));
}

std::optional<std::string> TomlTable::text(std::string_view key) {
  const TomlNode* value = find(key, TomlNode::Kind::text);
  if (value == nullptr) return std::nullopt;
  return value->text;
}

std::optional<std::string> TomlTable::requiredText(std::string_view key) {
  auto value = text(key);
  if (!value) missing(key);
  if (value && value->empty()) {
    error("cell.empty", key, fmt::format("`{}` of {} is empty", key, what_));
    return std::nullopt;
  }
  return value;
}

std::optional<std::string> TomlTable::requiredName(std::string_view key) {
  auto value = requiredText(key);
  if (!value) return value;
  if (value->size() <= kLongestName && value->find('/') == std::string::npos) return value;
  error("cell.bad-name", key, fmt::format("{} is not a valid name", quotedInFault(*value)),
        "names have at most 255 bytes and no slash");
  return std::nullopt;
}

std::optional<double> TomlTable::number(std::string_view key) {
  const TomlNode* value = find(key, TomlNode::Kind::number);
  if (value == nullptr) return std::nullopt;
  if (std::isfinite(value->number)) return value->number;
  error("cell.bad-number", key, fmt::format("`{}` of {} must be finite", key, what_));
  return std::nullopt;
}

std::optional<double> TomlTable::positiveNumber(std::string_view key) {
  const auto value = number(key);
  if (!value || *value > 0) return value;
  error("cell.bad-number", key, fmt::format("`{}` must be above 0", key));
  return std::nullopt;
}

std::optional<bool> TomlTable::flag(std::string_view key) {
  const TomlNode* value = find(key, TomlNode::Kind::flag);
  if (value == nullptr) return std::nullopt;
  return value->flag;
}

bool TomlTable::numbers(std::string_view key, double* values, std::size_t count) {
  const TomlNode* array = find(key, TomlNode::Kind::array);
  if (array == nullptr) return false;
  bool sound = array->items.size() == count;
  for (std::size_t i = 0; sound && i < count; ++i) {
    sound = isNumber(array->items[i]) && std::isfinite(array->items[i].number);
    values[i] = array->items[i].number;
  }
  if (!sound) {
    faults_->error("cell.bad-number", array->place,
                   fmt::format("`{}` of {} must be {} finite numbers", key, what_, count));
  }
  return sound;
}

std::optional<Vec3> TomlTable::vector(std::string_view key) {
  double v[3] = {};
  if (!numbers(key, v, 3)) return std::nullopt;
  return Vec3{v[0], v[1], v[2]};
}

std::optional<Vec3> TomlTable::requiredVector(std::string_view key) {
  auto value = vector(key);
  if (!value) missing(key);
  return value;
}

std::optional<Vec2> TomlTable::pair(std::string_view key) {
  double v[2] = {};
  if (!numbers(key, v, 2)) return std::nullopt;
  return Vec2{v[0], v[1]};
}

std::optional<Vec4> TomlTable::vector4(std::string_view key) {
  double v[4] = {};
  if (!numbers(key, v, 4)) return std::nullopt;
  return Vec4{v[0], v[1], v[2], v[3]};
}

std::optional<Vec3> TomlTable::direction(std::string_view key) {
  const auto given = vector(key);
  if (!given) return std::nullopt;
  return unitOf(*given, given->x * given->x + given->y * given->y + given->z * given->z);
}

std::optional<std::pair<double, double>> TomlTable::range(std::string_view key) {
  double v[2] = {};
  if (!numbers(key, v, 2)) return std::nullopt;
  if (v[0] <= v[1]) return std::pair(v[0], v[1]);
  error("cell.bad-range", key,
        fmt::format("`{}` of {} is [lowest, highest], but {} is above {}", key, what_, v[0], v[1]));
  return std::nullopt;
}

std::vector<std::string> TomlTable::texts(std::string_view key) {
  std::vector<std::string> values;
  const TomlNode* array = find(key, TomlNode::Kind::array);
  if (array == nullptr) return values;
  for (const TomlNode& item : array->items) {
    if (item.kind == TomlNode::Kind::text) {
      values.push_back(item.text);
    } else {
      faults_->error("cell.wrong-kind", item.place,
                     fmt::format("`{}` of {} holds {}, where strings are expected", key, what_,
                                 nameOf(item.kind)));
    }
  }
  return values;
}

std::optional<glm::vec4> TomlTable::color(std::string_view key) {
  const auto value = text(key);
  if (!value) return std::nullopt;
  bool sound = (value->size() == 7 || value->size() == 9) && value->front() == '#';
  glm::vec4 color{0.0F, 0.0F, 0.0F, 1.0F};
  for (std::size_t i = 1; sound && i + 1 < value->size(); i += 2) {
    const int high = hexDigit((*value)[i]), low = hexDigit((*value)[i + 1]);
    sound = high >= 0 && low >= 0;
    color[static_cast<int>(i / 2)] = static_cast<float>(high * 16 + low) / 255.0F;
  }
  if (sound) return color;
  error("cell.bad-color", key, fmt::format("{} is not a colour", quotedInFault(*value)),
        "colours are \"#rrggbb\" or \"#rrggbbaa\"");
  return std::nullopt;
}

Pose TomlTable::pose() {
  Pose pose;
  pose.position = vector("xyz").value_or(Vec3{0, 0, 0});
  const auto rpy = vector("rpy"), rpy_deg = vector("rpy_deg");
  const auto quaternion = vector4("quaternion");
  if (int{has("rpy")} + int{has("rpy_deg")} + int{has("quaternion")} > 1) {
    faults_->error("cell.two-orientations", place(),
                   fmt::format("{} has more than one of rpy, rpy_deg and quaternion", what_));
  }
  if (rpy) pose.orientation = quaternionFromRpy(*rpy);
  if (rpy_deg) {
    pose.orientation =
        quaternionFromRpy({radiansOf(rpy_deg->x), radiansOf(rpy_deg->y), radiansOf(rpy_deg->z)});
  }
  if (quaternion) {
    const Quat given{quaternion->w, quaternion->x, quaternion->y, quaternion->z};
    const auto unit = unitOf(
        given, given.w * given.w + given.x * given.x + given.y * given.y + given.z * given.z);
    if (unit) {
      pose.orientation = *unit;
    } else {
      error("cell.zero-quaternion", "quaternion", "the quaternion is zero",
            "the identity rotation is [0, 0, 0, 1]: x y z w");
    }
  }
  return pose;
}

std::optional<TomlTable> TomlTable::table(std::string_view key, std::string what) {
  const TomlNode* value = find(key, TomlNode::Kind::table);
  if (value == nullptr) return std::nullopt;
  return TomlTable(*value, std::move(what), *faults_);
}

std::vector<TomlTable> TomlTable::tables(std::string_view key, const std::string& what) {
  std::vector<TomlTable> tables;
  const TomlNode* array = node(key);
  if (array == nullptr) return tables;
  bool sound = array->kind == TomlNode::Kind::array;
  for (const TomlNode& item : array->items) {
    if (item.kind == TomlNode::Kind::table) {
      tables.emplace_back(item, what, *faults_);
    } else {
      sound = false;
    }
  }
  if (!sound) {
    faults_->error("cell.wrong-kind", array->place,
                   fmt::format("`{}` of {} must be tables", key, what_),
                   fmt::format("write {}", what));
  }
  return tables;
}

namespace {

/// "rate_hz" of "rate": the one key that has a unit behind it; empty when there is none.
std::string_view keyWithUnit(std::string_view key, const std::vector<std::string_view>& known) {
  std::string_view found;
  for (const std::string_view each : known) {
    if (!each.starts_with(key) || each.size() == key.size() || each[key.size()] != '_') continue;
    if (!found.empty()) return {};
    found = each;
  }
  return found;
}

}  // namespace

void TomlTable::finish() const {
  std::vector<std::string_view> known(known_.begin(), known_.end());
  std::sort(known.begin(), known.end());
  for (const TomlNode::Entry& entry : node_->entries) {
    if (entry.key.starts_with("x-")) continue;
    if (std::binary_search(known.begin(), known.end(), entry.key)) continue;
    std::string hint;
    if (faults_->lists("cell.unknown-key")) {
      const std::string_view longer = keyWithUnit(entry.key, known);
      hint =
          longer.empty() ? didYouMean(entry.key, known) : fmt::format("did you mean `{}`?", longer);
      if (hint.empty()) hint = fmt::format("its keys are {}", fmt::join(known, ", "));
    }
    faults_->error("cell.unknown-key", entry.place,
                   fmt::format("{} has an unknown key {}", what_, quotedInFault(entry.key)),
                   std::move(hint));
  }
}

}  // namespace rocinante
