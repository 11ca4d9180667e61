#include "viewer/view/units.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <span>

namespace rocinante {
namespace {

constexpr double kDegreesInRadian = 180 / std::numbers::pi;

struct UnitWord {
  std::string_view text;
  double in_base;  ///< radians or metres of one
};
constexpr std::array kAngleWords{UnitWord{"deg", 1 / kDegreesInRadian},
                                 UnitWord{"°", 1 / kDegreesInRadian}, UnitWord{"rad", 1}};
// "m" last: "mm" ends in it, too.
constexpr std::array kLengthWords{UnitWord{"mm", 1e-3}, UnitWord{"cm", 1e-2}, UnitWord{"m", 1}};

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

std::optional<double> parseWithUnit(std::string_view text, std::span<const UnitWord> words,
                                    double otherwise) {
  text = trimmed(text);
  double factor = otherwise;
  for (const UnitWord& word : words) {
    if (!text.ends_with(word.text)) continue;
    text = trimmed(text.substr(0, text.size() - word.text.size()));
    factor = word.in_base;
    break;
  }
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0;
  const auto [stop, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = fault == std::errc() && stop == text.data() + text.size();
  if (!whole || !std::isfinite(value * factor)) return std::nullopt;
  return value * factor;
}

/// Without a sign for values that round to zero.
std::string roundedNumber(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.starts_with('-') && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
  return text;
}

}  // namespace

std::string angleNumber(double radians, AngleUnit unit) {
  return unit == AngleUnit::degrees ? roundedNumber(radians * kDegreesInRadian, 2)
                                    : roundedNumber(radians, 4);
}

std::string lengthNumber(double metres, LengthUnit unit) {
  return unit == LengthUnit::millimetres ? roundedNumber(metres * 1e3, 1)
                                         : roundedNumber(metres, 4);
}

std::string angleText(double radians, AngleUnit unit) {
  return angleNumber(radians, unit) + (unit == AngleUnit::degrees ? "°" : " rad");
}

std::string lengthText(double metres, LengthUnit unit) {
  return lengthNumber(metres, unit) + " " + std::string(nameOf(unit));
}

std::string_view nameOf(AngleUnit unit) { return unit == AngleUnit::degrees ? "deg" : "rad"; }
std::string_view nameOf(LengthUnit unit) { return unit == LengthUnit::millimetres ? "mm" : "m"; }

bool setUnit(Units& units, std::string_view name) {
  for (const AngleUnit unit : {AngleUnit::degrees, AngleUnit::radians}) {
    if (name != nameOf(unit)) continue;
    units.angle = unit;
    return true;
  }
  for (const LengthUnit unit : {LengthUnit::millimetres, LengthUnit::metres}) {
    if (name != nameOf(unit)) continue;
    units.length = unit;
    return true;
  }
  return false;
}

std::optional<double> parseAngle(std::string_view text, AngleUnit unit) {
  return parseWithUnit(text, kAngleWords, unit == AngleUnit::degrees ? 1 / kDegreesInRadian : 1);
}

std::optional<double> parseLength(std::string_view text, LengthUnit unit) {
  return parseWithUnit(text, kLengthWords, unit == LengthUnit::millimetres ? 1e-3 : 1);
}

}  // namespace rocinante
