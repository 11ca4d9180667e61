#include "core/series/series_key.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/packet/item_text.h"
#include "core/series/derived_value.h"

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

/// "DEVICE/LINK" or "DEVICE", which leaves the link empty; false for anything else.
bool readPlace(std::string_view text, std::string& device, std::string& link) {
  const std::size_t slash = text.find('/');
  if (text.empty() || slash == 0 || slash + 1 == text.size()) return false;
  device = text.substr(0, slash);
  if (slash != text.npos) link = text.substr(slash + 1);
  return true;
}

/// "DEVICE:x", "DEVICE/LINK:x", "DEVICE/LINK:x in PATH".
std::optional<SeriesKey> poseKey(std::string_view text) {
  constexpr std::string_view kIn = " in ";
  const auto withoutFrame = [](std::string_view pose) -> std::optional<SeriesKey> {
    const std::size_t colon = pose.rfind(':');
    if (colon == pose.npos || !posePart(pose.substr(colon + 1))) return std::nullopt;
    SeriesKey key{SeriesKey::Kind::pose, {}, std::string(pose.substr(colon + 1))};
    if (!readPlace(pose.substr(0, colon), key.name, key.link)) return std::nullopt;
    if (!key.link.empty()) key.kind = SeriesKey::Kind::link;
    return key;
  };
  // A name may hold the word too: what is before it must end as a pose does.
  for (std::size_t in = text.find(kIn); in != text.npos; in = text.find(kIn, in + 1)) {
    auto key = withoutFrame(text.substr(0, in));
    if (key && key->kind == SeriesKey::Kind::link &&
        readPlace(text.substr(in + kIn.size()), key->frame, key->frame_link)) {
      return key;
    }
  }
  return withoutFrame(text);
}

}  // namespace

std::string SeriesKey::text() const {
  switch (kind) {
    case Kind::joint:
      return name + "." + part;
    case Kind::pose:
      return name + ":" + part;
    case Kind::link: {
      const std::string in_world = name + "/" + link + ":" + part;
      if (frame.empty()) return in_world;
      return in_world + " in " + frame + (frame_link.empty() ? "" : "/" + frame_link);
    }
    case Kind::derived:
      return name;
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
  if (auto derived = parseDerivedKey(text)) return derived;
  return parseStatedKey(text);
}

std::string notPlotted(std::string_view text) {
  return "`" + std::string(text) + "` cannot be plotted: it is not the name of a value";
}

std::optional<SeriesKey> parseStatedKey(std::string_view text) {
  if (auto rate = countKey(text, "rate", SeriesKey::Kind::rate)) return rate;
  if (auto loss = countKey(text, "loss", SeriesKey::Kind::loss)) return loss;
  if (const auto signal = signalNamed(text)) {
    return SeriesKey{SeriesKey::Kind::signal, signal->device, signal->name.name, signal->name.link};
  }
  if (auto pose = poseKey(text)) return pose;
  const std::size_t point = text.find('.');
  if (point == text.npos || point == 0 || point + 1 == text.size()) return std::nullopt;
  return SeriesKey{SeriesKey::Kind::joint, std::string(text.substr(0, point)),
                   std::string(text.substr(point + 1))};
}

std::optional<std::pair<std::string, std::string>> parsePath(std::string_view text) {
  constexpr std::string_view kOver = " over ";
  for (std::size_t at = text.find(kOver); at != text.npos; at = text.find(kOver, at + 1)) {
    const std::string_view y = text.substr(0, at), x = text.substr(at + kOver.size());
    if (parseSeriesKey(y) && parseSeriesKey(x)) return std::pair(std::string(y), std::string(x));
  }
  return std::nullopt;
}

}  // namespace rocinante
