#include "core/copy/log_edits.h"

namespace rocinante {

Result<CopyReport> cutLog(const std::filesystem::path& log, const SelectionOptions& selection,
                          const MakeOptions& make, const std::string& reason,
                          CopyAddition* addition) {
  if (Status free = checkOutput(make.output, make.overwrite, {{log}}); !free) return free.error();
  Result<OpenedLog> opened = openForCopy(log);
  if (!opened) return opened.error();
  StateDamage hiding;
  const Result<std::vector<Event>> events =
      eventsOf(log, !selection.from_event.empty() || !selection.until_event.empty(), hiding);
  if (!events) return events.error();
  const Result<TimeRange> range = rangeOf(selection, opened->reader.summary(), *events);
  if (!range) return range.error();
  opened->options.range = *range;
  opened->options.selection = selection;
  const Result<std::string> session_id = sessionIdOf(opened->reader);
  if (!session_id) return session_id.error();
  Result<CopySource> source = CopySource::of(std::move(opened->reader), std::move(opened->options),
                                             std::nullopt, make.progress);
  if (!source) return source.error();
  std::vector<CopySource> sources;
  sources.push_back(std::move(*source));
  Result<CopyReport> report =
      makeLog(sources, make, {make.log, make.keyframes, *session_id, sources.front().origin()},
              reason, false, addition);
  if (report && !hiding.empty()) {
    report->notes.push_back("another matching event may be missing: " + hiding.text());
  }
  return report;
}

}  // namespace rocinante
