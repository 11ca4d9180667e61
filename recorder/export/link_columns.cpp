#include "recorder/export/link_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace rocinante {
namespace {

Result<SeriesKey> linkKey(const std::string& link, const std::string& frame) {
  auto key = parseSeriesKey(link + ":x" + (frame.empty() ? "" : " in " + frame));
  if (!key || key->kind != SeriesKey::Kind::link || key->frame.empty() != frame.empty()) {
    const bool is_link =
        parseSeriesKey(link + ":x").value_or(SeriesKey{}).kind == SeriesKey::Kind::link;
    return Error{ErrorKind::bad_argument,
                 is_link ? fmt::format("`{}` is not DEVICE or DEVICE/LINK", frame)
                         : fmt::format("`{}` is not DEVICE/LINK", link),
                 is_link ? "--in" : "--link"};
  }
  return *std::move(key);
}

}  // namespace

Result<LinkColumns> LinkColumns::of(const Cell& cell, const std::vector<std::string>& links,
                                    const std::string& frame, MomentWalk& session, LogTime moment) {
  LinkColumns columns(cell);
  for (const std::string& link : links) {
    auto key = linkKey(link, frame);
    if (!key) return key.error();
    if (!checkLink(cell, SessionState(), *key)) {
      const Result<const SessionState*> state = session.stateAt(moment);
      if (!state) return state.error();
      if (Status there = checkLink(cell, **state, *key); !there) return there.error();
    }
    if (columns.placed_.add(*key) * kPoseParts.size() < columns.columns_.size()) continue;
    for (const std::string_view part : kPoseParts) {
      key->part = part;
      columns.columns_.push_back(key->text());
    }
  }
  return columns;
}

bool LinkColumns::wereMoved(const SessionState& state, LogTime moment) {
  // Placing finds the carriers. Another one comes with a row, for what it carries says so.
  if (!std::exchange(knows_carriers_, true)) placed_.place(state);
  return std::ranges::any_of(placed_.devices(), [&](const std::string& name) {
    const DeviceState* const device = state.findDevice(name);
    return device != nullptr && device->last_write == moment;
  });
}

void LinkColumns::fill(const SessionState& state, std::span<double> row) {
  placed_.place(state);
  for (std::size_t i = 0; i < placed_.poses().size(); ++i) {
    const auto part = row.subspan(i * kPoseParts.size(), kPoseParts.size());
    if (const auto& pose = placed_.poses()[i]) {
      std::ranges::copy(poseNumbers(*pose), part.begin());
    } else {
      std::ranges::fill(part, std::numeric_limits<double>::quiet_NaN());
    }
  }
}

}  // namespace rocinante
