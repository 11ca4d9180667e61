#include "core/foreign/table/table_column.h"

#include <algorithm>
#include <limits>
#include <string>

#include "core/foreign/table/table_header.h"
#include "core/packet/text_number.h"

namespace rocinante {
namespace {

__extension__ using Wide = __int128;

}  // namespace

std::optional<Nanoseconds> tableSeconds(std::string_view text, int down) {
  double ignored = 0;
  const char* at = text.data();
  if (!readNumber(at, text.data() + text.size(), ignored) || at != text.data() + text.size()) {
    return std::nullopt;
  }
  bool negative = false;
  bool in_fraction = false;
  bool any_dropped = false;
  Wide digits = 0;
  int exponent = 9 - down;  // the unit is the nanosecond
  std::size_t i = 0;
  if (text[0] == '-' || text[0] == '+') negative = text[i++] == '-';
  for (; i < text.size() && text[i] != 'e' && text[i] != 'E'; ++i) {
    if (text[i] == '.') {
      in_fraction = true;
      continue;
    }
    // 30 digits hold every possible time to well below a nanosecond.
    any_dropped = digits >= Wide{1'000'000'000'000'000} * 1'000'000'000'000'000;
    if (!any_dropped) digits = digits * 10 + (text[i] - '0');
    exponent += (any_dropped ? 1 : 0) - (in_fraction ? 1 : 0);
  }
  if (i < text.size()) {
    const bool is_negative = text[++i] == '-';
    if (text[i] == '-' || text[i] == '+') ++i;
    int written = 0;
    for (; i < text.size(); ++i) written = std::min(written * 10 + (text[i] - '0'), 100'000);
    exponent += is_negative ? -written : written;
  }
  constexpr Wide kMax = std::numeric_limits<std::int64_t>::max();
  for (; exponent > 0 && digits != 0; --exponent) {
    if (digits > kMax) return std::nullopt;
    digits *= 10;
  }
  int last_dropped = 0;
  for (; exponent < 0 && (digits != 0 || last_dropped != 0); ++exponent) {
    last_dropped = static_cast<int>(digits % 10);
    digits /= 10;
  }
  if (last_dropped >= 5) ++digits;
  if (digits > kMax) return std::nullopt;
  const auto count = static_cast<std::int64_t>(digits);
  return Nanoseconds(negative ? -count : count);
}

bool isLinkColumn(std::string_view name) {
  if (isSignalColumn(name)) return false;
  const std::size_t slash = name.find('/');
  if (slash == name.npos || slash == 0) return false;
  return std::ranges::any_of(kPoseEndings, [&](std::string_view ending) {
    return name.ends_with(ending) || name.find(std::string(ending) + " in ", slash) != name.npos;
  });
}

bool isSignalColumn(std::string_view name) {
  constexpr std::string_view kBegin = "signal ";
  if (!name.starts_with(kBegin)) return false;
  // One that is not written as in packets is named as that. Only `signal tower.joint` and
  // `signal tower:x` are of a device whose name has a blank.
  const bool has_two =
      std::ranges::count(name, ' ') == 2 && !name.ends_with(' ') && name[kBegin.size()] != ' ';
  return has_two || name.find_first_of(".:") == name.npos;
}

bool isDerivedColumn(std::string_view name) {
  const auto isStated = [](std::string_view text) {
    if (text.starts_with("signal ")) return std::ranges::count(text, ' ') == 2;
    const std::size_t point = text.find('.');
    return isLinkColumn(text) || (point != text.npos && point > 0 && point + 1 < text.size()) ||
           std::ranges::any_of(kPoseEndings,
                               [&](std::string_view ending) { return text.ends_with(ending); });
  };
  if (name.starts_with("d/dt ")) return true;
  if (name.starts_with("mean ")) {
    const std::size_t blank = name.find(' ', 5);
    return blank != name.npos && tableSeconds(name.substr(5, blank - 5));
  }
  constexpr std::string_view kMinus = " - ";
  for (std::size_t at = name.find(kMinus); at != name.npos; at = name.find(kMinus, at + 1)) {
    if (at > 0 && isStated(name.substr(0, at)) && isStated(name.substr(at + kMinus.size()))) {
      return true;
    }
  }
  return false;
}

std::optional<TableColumn> tableColumn(std::string_view name) {
  if (isDerivedColumn(name)) return std::nullopt;
  if (isSignalColumn(name) || isLinkColumn(name)) return std::nullopt;
  for (std::size_t part = 0; part < kPoseEndings.size(); ++part) {
    const std::string_view ending = kPoseEndings[part];
    if (!name.ends_with(ending) || name.size() == ending.size()) continue;
    return TableColumn{name.substr(0, name.size() - ending.size()), {}, part, {}};
  }
  struct Quantity {
    std::string_view ending, quantity;
  };
  constexpr std::array<Quantity, 3> kQuantities = {
      {{"/position", ""}, {"/velocity", ".velocity"}, {"/effort", ".effort"}}};
  for (const auto& [ending, quantity] : kQuantities) {
    if (!name.starts_with('/') || !name.ends_with(ending)) continue;
    const std::string_view path = name.substr(0, name.size() - ending.size());
    const std::size_t slash = path.rfind('/');
    if (slash == path.npos || slash == 0 || slash + 1 == path.size()) return std::nullopt;
    return TableColumn{{}, path.substr(slash + 1), std::nullopt, path.substr(0, slash), quantity};
  }
  const std::size_t point = name.find('.');
  if (point == name.npos || point == 0 || point + 1 == name.size()) return std::nullopt;
  return TableColumn{name.substr(0, point), name.substr(point + 1), std::nullopt, {}};
}

std::optional<std::size_t> plainPosePart(std::string_view name) {
  for (std::size_t part = 0; part < kPoseEndings.size(); ++part) {
    const std::string_view plain = kPoseEndings[part].substr(1);
    if (name == plain || (part < 3 && name.size() == 2 && name[0] == 't' && name[1] == plain[0])) {
      return part;
    }
  }
  return std::nullopt;
}

std::string_view notAValue(std::string_view name) {
  if (timeUnitOf(name)) return "another time";
  if (name.starts_with(kClearanceColumn)) return "a distance";
  if (isDerivedColumn(name)) return "derived of others";
  if (isLinkColumn(name)) return "the pose of a link";
  return {};
}

}  // namespace rocinante
