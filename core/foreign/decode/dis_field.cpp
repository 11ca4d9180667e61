#include "core/foreign/decode/dis_field.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace rocinante::decode {
namespace {

using Quantity = DisField::Quantity;

constexpr auto kQuantities = std::to_array<std::pair<std::string_view, Quantity>>({
    {"version", Quantity::version},
    {"exercise", Quantity::exercise},
    {"site", Quantity::site},
    {"application", Quantity::application},
    {"entity", Quantity::entity},
    {"force", Quantity::force},
    {"kind", Quantity::kind},
    {"domain", Quantity::domain},
    {"country", Quantity::country},
    {"category", Quantity::category},
    {"subcategory", Quantity::subcategory},
    {"specific", Quantity::specific},
    {"extra", Quantity::extra},
    {"appearance", Quantity::appearance},
    {"marking", Quantity::marking},
    {"velocity.x", Quantity::velocity_x},
    {"velocity.y", Quantity::velocity_y},
    {"velocity.z", Quantity::velocity_z},
    {"location.x", Quantity::location_x},
    {"location.y", Quantity::location_y},
    {"location.z", Quantity::location_z},
    {"orientation.psi", Quantity::psi},
    {"orientation.theta", Quantity::theta},
    {"orientation.phi", Quantity::phi},
    {"local.x", Quantity::local_x},
    {"local.y", Quantity::local_y},
    {"local.z", Quantity::local_z},
    {"local.qx", Quantity::local_qx},
    {"local.qy", Quantity::local_qy},
    {"local.qz", Quantity::local_qz},
    {"local.qw", Quantity::local_qw},
});

/// The metrics of articulated parts, the lowest five bits of a parameter type, from 1.
constexpr std::array<std::string_view, 16> kMetrics{
    "position",  "position-rate",  "extension", "extension-rate", "x",       "x-rate",
    "y",         "y-rate",         "z",         "z-rate",         "azimuth", "azimuth-rate",
    "elevation", "elevation-rate", "rotation",  "rotation-rate"};
constexpr std::uint32_t kMetricBits = 31;
constexpr std::uint32_t kClassStep = 32;

/// Part classes that come in tens, PART-1 to PART-10.
struct Parts {
  std::uint32_t first;
  std::string_view name;
};
constexpr std::uint32_t kPartsEach = 10;
constexpr std::array<Parts, 10> kParts{{{4096, "primary-turret"},
                                        {4416, "primary-gun"},
                                        {4736, "primary-launcher"},
                                        {5056, "primary-defense"},
                                        {5376, "primary-radar"},
                                        {5696, "secondary-turret"},
                                        {6016, "secondary-gun"},
                                        {6336, "secondary-launcher"},
                                        {6656, "secondary-defense"},
                                        {6976, "secondary-radar"}}};

std::optional<std::uint32_t> partNumber(std::string_view text, std::uint32_t most) {
  std::uint32_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, fault] = std::from_chars(text.data(), end, number);
  if (fault != std::errc() || stop != end || number > most) return std::nullopt;
  return number;
}

std::optional<std::uint32_t> classNamed(std::string_view part) {
  if (const auto number = partNumber(part, UINT32_MAX)) {
    if (*number % kClassStep != 0) return std::nullopt;
    return number;
  }
  const std::size_t dash = part.rfind('-');
  if (dash == part.npos) return std::nullopt;
  const auto found = std::ranges::find(kParts, part.substr(0, dash), &Parts::name);
  const auto number = partNumber(part.substr(dash + 1), kPartsEach);
  if (found == kParts.end() || !number || *number == 0) return std::nullopt;
  return found->first + (*number - 1) * kClassStep;
}

std::optional<std::uint32_t> metricNamed(std::string_view metric) {
  if (const auto number = partNumber(metric, kMetricBits)) return number;
  const auto found = std::ranges::find(kMetrics, metric);
  if (found == kMetrics.end()) return std::nullopt;
  return static_cast<std::uint32_t>(found - kMetrics.begin()) + 1;
}

}  // namespace

std::optional<DisField> disFieldNamed(std::string_view name) {
  const auto known =
      std::ranges::find(kQuantities, name, &std::pair<std::string_view, Quantity>::first);
  if (known != kQuantities.end()) return DisField{known->second, 0};
  const std::size_t dot = name.find('.');
  if (dot == name.npos) return std::nullopt;
  const auto part = classNamed(name.substr(0, dot));
  const auto metric = metricNamed(name.substr(dot + 1));
  if (!part || !metric) return std::nullopt;
  return DisField{Quantity::articulation, *part + *metric};
}

std::string articulationName(std::uint32_t parameter_type) {
  const std::uint32_t metric = parameter_type & kMetricBits;
  const std::uint32_t part = parameter_type - metric;
  std::string name = std::to_string(part);
  for (const Parts& each : kParts) {
    if (part < each.first || part >= each.first + kPartsEach * kClassStep) continue;
    name = std::string(each.name) + '-' + std::to_string((part - each.first) / kClassStep + 1);
  }
  name += '.';
  if (metric == 0 || metric > kMetrics.size()) return name + std::to_string(metric);
  return name += kMetrics[metric - 1];
}

}  // namespace rocinante::decode
