#include "core/base/figure_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <numbers>
#include <optional>

namespace rocinante {
namespace {

constexpr std::uint64_t kMax = std::uint64_t{1} << 63U;

char lower(char letter) {
  return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

std::optional<std::uint64_t> bytesOfUnit(std::string_view unit) {
  std::string low(unit);
  std::ranges::transform(low, low.begin(), lower);
  if (low.empty() || low == "b") return 1;
  constexpr std::string_view kPrefixes = "kmgt";
  const std::size_t power = kPrefixes.find(low.front());
  if (power == std::string_view::npos) return std::nullopt;
  const std::string_view rest = std::string_view(low).substr(1);
  if (rest != "b" && rest != "ib") return std::nullopt;
  std::uint64_t bytes = 1;
  for (std::size_t i = 0; i <= power; ++i) bytes *= rest == "b" ? 1'000 : 1'024;
  return bytes;
}

Error malformed(std::string_view text) {
  return Error{ErrorKind::bad_argument, "a size is 100MB, 64MiB, 1.5GB or bytes",
               std::string(text)};
}

}  // namespace

std::string sizeText(std::uint64_t bytes) {
  if (bytes < 1'000) return fmt::format("{} B", bytes);
  constexpr std::array kPrefixed{"kB", "MB", "GB", "TB", "PB", "EB"};
  double value = static_cast<double>(bytes) / 1'000.0;
  std::size_t unit = 0;
  // 999.95 would show as 1000.0.
  while (value >= 999.95 && unit + 1 < kPrefixed.size()) {
    value /= 1'000.0;
    ++unit;
  }
  return fmt::format("{:.1f} {}", value, kPrefixed[unit]);
}

Result<std::uint64_t> parseSize(std::string_view text) {
  const char* const end = text.data() + text.size();
  std::uint64_t whole = 0;
  auto [at, fault] = std::from_chars(text.data(), end, whole);
  if (fault != std::errc()) return malformed(text);
  std::string_view decimals;
  if (at != end && *at == '.') {
    const char* const first = ++at;
    while (at != end && *at >= '0' && *at <= '9') ++at;
    decimals = {first, static_cast<std::size_t>(at - first)};
    // Six, so that their product with a TiB stays below 2^63.
    if (decimals.empty() || decimals.size() > 6) return malformed(text);
  }
  if (at != end && *at == ' ') ++at;
  const auto unit = bytesOfUnit({at, static_cast<std::size_t>(end - at)});
  if (!unit || whole >= kMax / *unit) return malformed(text);
  std::uint64_t parts = 0;
  std::uint64_t scale = 1;
  for (const char digit : decimals) {
    parts = parts * 10 + static_cast<std::uint64_t>(digit - '0');
    scale *= 10;
  }
  return whole * *unit + parts * *unit / scale;
}

std::string countText(std::uint64_t number, std::string_view one) {
  std::string text = std::to_string(number) + " " + std::string(one);
  return number == 1 ? text : text + "s";
}

std::string angleText(double radians) {
  return fmt::format("{:.6g}°", radians * (180 / std::numbers::pi));
}

}  // namespace rocinante
