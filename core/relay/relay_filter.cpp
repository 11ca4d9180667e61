#include "core/relay/relay_filter.h"

#include <array>

#include "core/base/pattern.h"

namespace rocinante {
namespace {

using Kind = StatementKind;

constexpr std::uint32_t bitOf(Kind kind) { return std::uint32_t{1} << static_cast<unsigned>(kind); }

/// Kinds that are one thing to a listener.
constexpr std::array<std::uint32_t, 10> kGroups = {
    bitOf(Kind::joints) | bitOf(Kind::order) | bitOf(Kind::joint),
    bitOf(Kind::pose),
    bitOf(Kind::add) | bitOf(Kind::remove),
    bitOf(Kind::show) | bitOf(Kind::hide),
    bitOf(Kind::color),
    bitOf(Kind::line) | bitOf(Kind::erase),
    bitOf(Kind::points) | bitOf(Kind::erase),
    bitOf(Kind::label) | bitOf(Kind::erase),
    bitOf(Kind::view),
    bitOf(Kind::signal) | bitOf(Kind::signals),
};

}  // namespace

bool RelayFilter::passesEverything() const {
  return sources.empty() && devices.empty() && signals.empty() && kinds == ~std::uint32_t{0};
}

bool RelayFilter::passesSource(std::string_view source) const {
  return sources.empty() || anyPatternMatches(sources, source);
}

bool RelayFilter::passesDevice(std::string_view device) const {
  return devices.empty() || anyPatternMatches(devices, device);
}

bool RelayFilter::passesSignal(std::string_view path_and_name) const {
  return signals.empty() || anyPatternMatches(signals, path_and_name);
}

Result<std::uint32_t> statementKindsOf(std::string_view word) {
  for (unsigned i = 0; i < static_cast<unsigned>(Kind::seen); ++i) {
    if (nameOf(static_cast<Kind>(i)) != word) continue;
    const std::uint32_t bit = std::uint32_t{1} << i;
    std::uint32_t kinds = bit;
    for (const std::uint32_t group : kGroups) kinds |= (group & bit) != 0 ? group : 0;
    return kinds;
  }
  return Error{ErrorKind::bad_argument, "not a statement of packet text", std::string(word)};
}

}  // namespace rocinante
