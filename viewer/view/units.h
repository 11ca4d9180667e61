#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace rocinante {

enum class AngleUnit : std::uint8_t { degrees, radians };
enum class LengthUnit : std::uint8_t { millimetres, metres };

/// The units of what people read and type; files and packets have radians and metres.
struct Units {
  AngleUnit angle = AngleUnit::degrees;
  LengthUnit length = LengthUnit::millimetres;
  bool operator==(const Units&) const = default;
};

/// "23.60°" or "0.4119 rad": a hundredth of a degree, a ten-thousandth of a radian.
std::string angleText(double radians, AngleUnit unit);
/// "1234.5 mm" or "1.2345 m": a tenth of a millimetre.
std::string lengthText(double metres, LengthUnit unit);
/// The same without the unit, for columns of numbers.
std::string angleNumber(double radians, AngleUnit unit);
std::string lengthNumber(double metres, LengthUnit unit);
std::string_view nameOf(AngleUnit unit);   ///< "deg", "rad"
std::string_view nameOf(LengthUnit unit);  ///< "mm", "m"

/// Sets the unit of that name; false for another text.
bool setUnit(Units& units, std::string_view name);

/// Radians of "30", "30deg", "30°" or "0.5 rad"; without a unit, `unit`. Empty when the text is not
/// a finite number with one of these units.
std::optional<double> parseAngle(std::string_view text, AngleUnit unit);
/// Metres of "120", "120mm", "12cm" or "0.12 m".
std::optional<double> parseLength(std::string_view text, LengthUnit unit);

}  // namespace rocinante
