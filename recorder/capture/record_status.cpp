#include "recorder/capture/record_status.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/size_text.h"

namespace rocinante {
namespace {

using std::chrono::seconds;

constexpr Nanoseconds kDiskSpan = seconds(10);

double perSecond(std::uint64_t now, std::uint64_t before, Nanoseconds span) {
  return span > Nanoseconds(0) ? static_cast<double>(now - std::min(now, before)) / secondsOf(span)
                               : 0;
}

/// "43 s", "12 min", "5.2 h", "12 days", "over a year".
std::string roughly(double span_s) {
  if (span_s < 120) return fmt::format("{:.0f} s", span_s);
  if (span_s < 7'200) return fmt::format("{:.0f} min", span_s / 60);
  if (span_s < 172'800) return fmt::format("{:.1f} h", span_s / 3'600);
  if (span_s < 365 * 86'400.0) return fmt::format("{:.0f} days", span_s / 86'400);
  return "over a year";
}

}  // namespace

/// The latest progress up to `elapsed`, or else the first.
const RecordProgress& RecordStatus::before(Nanoseconds elapsed) const {
  const auto later = std::ranges::find_if(
      told_, [&](const RecordProgress& each) { return each.elapsed > elapsed; });
  return later == told_.begin() ? *later : *std::prev(later);
}

std::string RecordStatus::text(const RecordProgress& now) {
  if (told_.empty()) told_.emplace_back();
  const RecordProgress& second_ago = before(now.elapsed - seconds(1));
  const RecordProgress& long_ago = told_.front();
  const double rate = perSecond(now.packets, second_ago.packets, now.elapsed - second_ago.elapsed);
  const double disk_rate =
      perSecond(now.log_bytes, long_ago.log_bytes, now.elapsed - long_ago.elapsed);
  std::string text =
      fmt::format("{:.1f} s   {:.0f} packets/s   {} packets   {} lost   {}", secondsOf(now.elapsed),
                  rate, now.packets, now.lost, sizeText(now.log_bytes));
  if (!now.started) text += "   waiting to start";
  if (now.held > Nanoseconds(0)) text += fmt::format("   holding {:.1f} s", secondsOf(now.held));
  text += fmt::format("   queue {:.0f} %", 100 * now.queue_fill);
  if (now.disk_free_bytes) {
    text += fmt::format("   {} free", sizeText(*now.disk_free_bytes));
    if (disk_rate > 0) {
      text += ", for " + roughly(static_cast<double>(*now.disk_free_bytes) / disk_rate);
    }
  }
  told_.push_back(now);
  while (now.elapsed - told_.front().elapsed > kDiskSpan) told_.pop_front();
  return text;
}

}  // namespace rocinante
