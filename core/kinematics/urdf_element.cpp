#include "core/kinematics/urdf_element.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/document/fault_list.h"
#include "core/math/transform.h"

namespace rocinante {
namespace {

constexpr std::string_view kTemplateHint =
    "expand the template first: xacro model.xacro > model.urdf";

constexpr std::string_view kEntityHint =
    "an entity of the file's own DOCTYPE is not expanded: write its text";

bool isTemplate(std::string_view text) {
  return text.find("${") != std::string_view::npos || text.find("$(") != std::string_view::npos;
}

}  // namespace

std::optional<UrdfElement> UrdfElement::child(const char* name) const {
  const tinyxml2::XMLElement* first = element_->FirstChildElement(name);
  if (first == nullptr) return std::nullopt;
  if (const tinyxml2::XMLElement* second = first->NextSiblingElement(name)) {
    faults().error("urdf.repeated-element", context_->places.of(*second),
                   fmt::format("<{}> has a second <{}>", tag(), name), "the first one is used");
  }
  return UrdfElement(*first, *context_);
}

std::string UrdfElement::text(const char* attribute) const {
  const char* value = element_->Attribute(attribute);
  return value == nullptr ? std::string() : std::string(value);
}

void UrdfElement::missing(const char* attribute) const {
  faults().error("urdf.missing-attribute", place(),
                 fmt::format("<{}> lacks its attribute `{}`", tag(), attribute));
}

std::optional<std::string> UrdfElement::requiredText(const char* attribute) const {
  std::string value = text(attribute);
  if (!value.empty()) return value;
  missing(attribute);
  return std::nullopt;
}

bool UrdfElement::numbers(const char* attribute, double* values, std::size_t count) const {
  const char* given = element_->Attribute(attribute);
  if (given == nullptr) return false;
  const std::string_view text = given;
  std::size_t at = 0, found = 0;
  bool sound = true;
  while (sound) {
    at = text.find_first_not_of(" \t\r\n", at);
    if (at == std::string_view::npos) break;
    const std::size_t end = std::min(text.find_first_of(" \t\r\n", at), text.size());
    std::string_view word = text.substr(at, end - at);
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
    double value = 0;
    const auto [behind, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    sound = error == std::errc{} && behind == word.data() + word.size() && std::isfinite(value);
    if (sound && found < count) values[found] = value;
    ++found;
    at = end;
  }
  if (sound && found == count) return true;
  const std::string_view hint = isTemplate(text)                           ? kTemplateHint
                                : text.find('&') != std::string_view::npos ? kEntityHint
                                                                           : std::string_view();
  faults().error(
      "urdf.bad-number", place(attribute),
      fmt::format("`{}` of <{}> is {}, where {} expected", attribute, tag(), quotedInFault(text),
                  count == 1 ? "a number is" : fmt::format("{} numbers are", count)),
      std::string(hint));
  return false;
}

std::optional<double> UrdfElement::number(const char* attribute) const {
  double value = 0;
  if (!numbers(attribute, &value, 1)) return std::nullopt;
  return value;
}

std::optional<double> UrdfElement::requiredNumber(const char* attribute) const {
  if (!has(attribute)) missing(attribute);
  return number(attribute);
}

std::optional<Vec3> UrdfElement::vector(const char* attribute) const {
  double v[3] = {};
  if (!numbers(attribute, v, 3)) return std::nullopt;
  return Vec3{v[0], v[1], v[2]};
}

std::optional<Vec4> UrdfElement::vector4(const char* attribute) const {
  double v[4] = {};
  if (!numbers(attribute, v, 4)) return std::nullopt;
  return Vec4{v[0], v[1], v[2], v[3]};
}

Pose UrdfElement::origin() const {
  const auto given = child("origin");
  if (!given) return {};
  const Vec3 position = given->vector("xyz").value_or(Vec3{0, 0, 0});
  if (const auto turn = given->vector4("quat_xyzw")) {
    const Quat stated{turn->w, turn->x, turn->y, turn->z};
    if (const auto unit = normalized(stated)) {
      if (!isUnitLength(stated)) {
        faults().leaveOut("length", "origin/@quat_xyzw", given->place("quat_xyzw"),
                          "it is off 1 by more than 0.001, and the quaternion is normalised",
                          Severity::warning);
      }
      return {position, *unit};
    }
    faults().error("urdf.bad-number", given->place("quat_xyzw"),
                   "`quat_xyzw` of <origin> is zero, which is no rotation", "0 0 0 1 is none");
    return {position};
  }
  return {position, quaternionFromRpy(given->vector("rpy").value_or(Vec3{0, 0, 0}))};
}

}  // namespace rocinante
