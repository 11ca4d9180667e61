#include <fmt/format.h>

#include "core/base/duration_text.h"
#include "core/base/figure_text.h"
#include "core/base/plain_text.h"
#include "recorder/diff/diff_place_json.h"
#include "recorder/diff/log_diff.h"

namespace rocinante {
namespace {

/// A payload's beginning on one line.
std::string payloadText(const DiffPlace& place) {
  if (!isUtf8(bytesOf(place.payload))) return plainText(place.payload);
  std::string line;
  std::string_view text = place.payload;
  while (text.ends_with('\n')) text.remove_suffix(1);
  for (const char c : text) {
    if (c == '\n') {
      line += " | ";
    } else {
      line += c;
    }
  }
  return plainText(line);
}

std::string placeText(const std::optional<DiffPlace>& place, LogTime origin) {
  if (!place) return "it has ended";
  return fmt::format("message {}, {} s, {}: {}", place->number,
                     secondsText(place->time - origin, 9), plainText(place->topic),
                     payloadText(*place));
}

std::string shiftText(Nanoseconds shift) {
  return fmt::format("{}{} s", shift > Nanoseconds(0) ? "+" : "", secondsText(shift, 3));
}

void addPayload(std::string& out, const LogDiff& diff) {
  const PayloadDiff& payload = *diff.payload;
  if (!payload.differs) {
    out += fmt::format("payload  the same {}\n", countText(payload.same, "message"));
    return;
  }
  out += fmt::format("payload  differs: {} in both, {} only in a, {} only in b\n",
                     countText(payload.same, "message"), payload.only_a, payload.only_b);
  out += fmt::format("  first, in a: {}\n", placeText(payload.first_a, diff.origin_a));
  out += fmt::format("  first, in b: {}\n", placeText(payload.first_b, diff.origin_b));
}

void addTime(std::string& out, const LogDiff& diff) {
  const TimeDiff& time = *diff.time;
  const std::uint64_t both = diff.payload->same;
  if (time.moved == 0) {
    out += fmt::format("time     the same, of {} in both\n", countText(both, "message"));
    return;
  }
  out += fmt::format("time     differs: {} of {} in both moved, by {} to {}\n", time.moved,
                     countText(both, "message"), shiftText(time.least), shiftText(time.most));
  out += fmt::format("  first, by {}: {}\n", shiftText(time.first_shift),
                     placeText(time.first_a, diff.origin_a));
  out += fmt::format("  largest, by {}: {}\n", shiftText(time.largest_shift),
                     placeText(time.largest_a, diff.origin_a));
}

void addItems(std::string& out, std::string_view side, const std::vector<std::string>& items,
              std::uint64_t all) {
  for (const std::string& item : items) out += fmt::format("  {}: {}\n", side, plainText(item));
  if (all > items.size()) out += fmt::format("  {}: and {} more\n", side, all - items.size());
}

void addState(std::string& out, const LogDiff& diff) {
  const StateDiff& state = *diff.state;
  if (!state.differs) {
    out += "state    the same at every moment\n";
    return;
  }
  out += fmt::format("state    differs from {} s on; {}\n",
                     secondsText(state.first - diff.origin_a, 9),
                     state.ends_differ ? "the ends differ too" : "the ends are the same");
  addItems(out, "only in a", state.only_a, state.items_only_a);
  addItems(out, "only in b", state.only_b, state.items_only_b);
}

}  // namespace

std::string diffText(const LogDiff& diff) {
  std::string out = fmt::format("a  {}\nb  {}\n", plainText(diff.name_a), plainText(diff.name_b));
  if (diff.payload) addPayload(out, diff);
  if (diff.time) addTime(out, diff);
  if (diff.state) addState(out, diff);
  return out;
}

std::string diffJson(const LogDiff& diff) {
  Json out;
  out["format"] = 1;
  out["a"] = diff.name_a;
  out["b"] = diff.name_b;
  out["same"] = diff.same();
  out["messages_a"] = diff.messages_a;
  out["messages_b"] = diff.messages_b;
  if (diff.payload) {
    out["payload"] = {{"same", !diff.payload->differs},
                      {"in_both", diff.payload->same},
                      {"only_a", diff.payload->only_a},
                      {"only_b", diff.payload->only_b},
                      {"first_a", placeJson(diff.payload->first_a)},
                      {"first_b", placeJson(diff.payload->first_b)}};
  }
  if (diff.time) {
    out["time"] = {{"same", diff.time->moved == 0},
                   {"moved", diff.time->moved},
                   {"least_shift_ns", diff.time->least.count()},
                   {"most_shift_ns", diff.time->most.count()},
                   {"first", placeJson(diff.time->first_a)},
                   {"first_shift_ns", diff.time->first_shift.count()},
                   {"largest", placeJson(diff.time->largest_a)},
                   {"largest_shift_ns", diff.time->largest_shift.count()}};
  }
  if (diff.state) {
    out["state"] = {
        {"same", !diff.state->differs},
        {"ends_same", !diff.state->ends_differ},
        {"first_ns",
         diff.state->differs ? Json(diff.state->first.time_since_epoch().count()) : Json(nullptr)},
        {"only_a", diff.state->only_a},
        {"only_b", diff.state->only_b},
        {"items_only_a", diff.state->items_only_a},
        {"items_only_b", diff.state->items_only_b}};
  }
  return jsonText(out);
}

}  // namespace rocinante
