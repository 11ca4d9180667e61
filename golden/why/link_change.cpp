#include "golden/why/link_change.h"

#include <fmt/format.h>

#include <cmath>

namespace rocinante {
namespace {

/// Without a minus in front of a zero.
double rounded(double value, double step) {
  const double nearest = std::round(value / step) * step;
  return nearest == 0 ? 0.0 : nearest;
}

std::string groupedDigits(std::int64_t number) {
  std::string digits = std::to_string(number);
  for (auto at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > 0; at -= 3) {
    digits.insert(static_cast<std::size_t>(at), 1, ',');
  }
  return digits;
}

}  // namespace

std::string_view nameOf(ChangeKind kind) {
  switch (kind) {
    case ChangeKind::moved:
      return "moved";
    case ChangeKind::appeared:
      return "appeared";
    case ChangeKind::vanished:
      return "vanished";
    case ChangeKind::shape:
      return "shape";
    case ChangeKind::color:
      return "colour";
    case ChangeKind::drawing:
      return "drawing";
    case ChangeKind::camera:
      return "camera";
  }
  return "colour";
}

std::string nameText(const IdentityName& name) {
  if (name.device.empty()) return "background";
  if (name.device == "drawing") return "drawing " + name.link;
  return name.link.empty() ? name.device : name.device + "/" + name.link;
}

std::string nameText(const LinkChange& change) {
  if (change.inset.empty()) return nameText(change.name);
  const std::string inset = "inset " + change.inset;
  return change.kind == ChangeKind::camera ? inset : inset + ", " + nameText(change.name);
}

std::string whatText(const LinkChange& change) {
  switch (change.kind) {
    case ChangeKind::moved:
      if (!change.moved_px) return "moved";
      // A movement below a tenth of a pixel must not print as (0.0, 0.0).
      return std::hypot((*change.moved_px)[0], (*change.moved_px)[1]) >= 0.1
                 ? fmt::format("moved by ({:.1f}, {:.1f}) px", rounded((*change.moved_px)[0], 0.1),
                               rounded((*change.moved_px)[1], 0.1))
                 : "moved by less than 0.1 px";
    case ChangeKind::appeared:
      return "appeared";
    case ChangeKind::vanished:
      return "vanished";
    case ChangeKind::shape:
      return "shape changed";
    case ChangeKind::drawing:
      return "text or drawing";
    case ChangeKind::camera:
      return change.camera;
    case ChangeKind::color:
      break;
  }
  const auto& shift = change.color_shift;
  return fmt::format("colour changed by ({:+.0f}, {:+.0f}, {:+.0f})", rounded(shift[0], 1),
                     rounded(shift[1], 1), rounded(shift[2], 1));
}

std::string changeText(const LinkChange& change, std::int64_t differing) {
  return fmt::format("{}: {} of {} differing pixel{}, {}", nameText(change),
                     groupedDigits(change.pixels), groupedDigits(differing),
                     differing == 1 ? "" : "s", whatText(change));
}

}  // namespace rocinante
