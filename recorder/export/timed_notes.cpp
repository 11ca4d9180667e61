#include "recorder/export/timed_notes.h"

#include <fmt/format.h>

#include <algorithm>

namespace rocinante {
namespace {

std::string lossText(const LossSpan& loss) {
  std::string text = "lost at " + loss.endpoint + ":";
  const auto add = [&](std::uint64_t count, std::string_view where) {
    if (count > 0) text += fmt::format(" {} {}", count, where);
  };
  add(loss.counts.kernel, "in the kernel");
  add(loss.counts.queue, "in the recorder's queue");
  add(loss.counts.disk, "on the disk");
  add(loss.counts.truncated, "cut");
  return text;
}

}  // namespace

Result<TimedNotes> TimedNotes::of(MomentWalk& session, LogTime from, LogTime until,
                                  const std::vector<TimedNote>& more) {
  TimedNotes notes;
  const Result<const std::vector<Event>*> events = session.events();
  if (!events) return events.error();
  for (const Event& event : **events) {
    if (event.time < from || event.time >= until) continue;
    notes.notes_.push_back({event.time, EventLevel::info, event.source, event.text});
  }
  for (const LossSpan& loss : session.log().losses()) {
    if (loss.until < from || loss.until >= until) continue;
    notes.notes_.push_back({loss.until, EventLevel::warning, "rocinante-record", lossText(loss)});
  }
  for (const TimedNote& note : more) {
    if (note.time >= from && note.time < until) notes.notes_.push_back(note);
  }
  std::stable_sort(notes.notes_.begin(), notes.notes_.end(),
                   [](const TimedNote& a, const TimedNote& b) { return a.time < b.time; });
  return notes;
}

Status TimedNotes::write(SessionFormat& format, MessageSink& out, LogTime moment) {
  for (; next_ < notes_.size() && notes_[next_].time <= moment; ++next_) {
    const TimedNote& note = notes_[next_];
    Status written = format.event(out, note.time, note.level, note.name, note.text);
    if (!written) return written;
  }
  return {};
}

}  // namespace rocinante
