#include "core/series/series_key.h"

#include <algorithm>
#include <array>

#include "core/packet/item_text.h"

namespace rocinante {
namespace {

/// "rate" or "rate/NAME".
std::optional<SeriesKey> countKey(std::string_view text, std::string_view word,
                                  SeriesKey::Kind kind) {
  if (text == word) return SeriesKey{kind};
  if (!text.starts_with(word) || text.size() < word.size() + 2 || text[word.size()] != '/') {
    return std::nullopt;
  }
  return SeriesKey{kind, std::string(text.substr(word.size() + 1))};
}

}  // namespace

std::string SeriesKey::text() const {
  switch (kind) {
    case Kind::joint:
      return name + "." + part;
    case Kind::pose:
      return name + ":" + part;
    case Kind::rate:
      return name.empty() ? "rate" : "rate/" + name;
    case Kind::loss:
      return name.empty() ? "loss" : "loss/" + name;
    case Kind::signal: {
      const SignalName named{link, part};
      return signalNameText(name, named);
    }
  }
  return {};
}

std::optional<std::size_t> posePart(std::string_view part) {
  const auto found = std::ranges::find(kPoseParts, part);
  if (found == kPoseParts.end()) return std::nullopt;
  return static_cast<std::size_t>(found - kPoseParts.begin());
}

std::array<double, 7> poseNumbers(const Pose& pose) {
  return {pose.position.x,    pose.position.y,    pose.position.z,   pose.orientation.x,
          pose.orientation.y, pose.orientation.z, pose.orientation.w};
}

std::optional<SeriesKey> parseSeriesKey(std::string_view text) {
  if (auto rate = countKey(text, "rate", SeriesKey::Kind::rate)) return rate;
  if (auto loss = countKey(text, "loss", SeriesKey::Kind::loss)) return loss;
  if (const auto signal = signalNamed(text)) {
    return SeriesKey{SeriesKey::Kind::signal, signal->device, signal->name.name, signal->name.link};
  }
  const std::size_t colon = text.rfind(':');
  if (colon != text.npos && colon > 0 && posePart(text.substr(colon + 1))) {
    return SeriesKey{SeriesKey::Kind::pose, std::string(text.substr(0, colon)),
                     std::string(text.substr(colon + 1))};
  }
  const std::size_t point = text.find('.');
  if (point == text.npos || point == 0 || point + 1 == text.size()) return std::nullopt;
  return SeriesKey{SeriesKey::Kind::joint, std::string(text.substr(0, point)),
                   std::string(text.substr(point + 1))};
}

}  // namespace rocinante
