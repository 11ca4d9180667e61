#include "core/copy/log_make.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/plain_text.h"
#include "core/copy/log_selection.h"
#include "core/log/log_profile.h"
#include "core/session/marks.h"
#include "core/session/timeline.h"

namespace rocinante {
namespace {

constexpr std::size_t kSessionIdDigits = 32;

}  // namespace

Result<std::vector<Event>> eventsOf(const std::filesystem::path& log, bool needed,
                                    StateDamage& hiding) {
  if (!needed) return std::vector<Event>{};
  Result<Timeline> timeline = Timeline::open(log);
  if (!timeline) return timeline.error();
  const Result<const std::vector<Event>*> found = timeline->events(&hiding);
  if (!found) return found.error();
  return **found;
}

Status knownFormat(const LogReader& reader) {
  const bool has_session = std::ranges::any_of(reader.metadata(), [](const LogMetadata& record) {
    return record.name == profile::kSession;
  });
  if (!has_session || reader.summary().format == profile::kFormat) return {};
  return Error{ErrorKind::unsupported,
               fmt::format("the log has format \"{}\"; only format {} can be copied, because a "
                           "copy claims that format",
                           plainText(reader.summary().format.substr(0, 40)), profile::kFormat),
               reader.name()};
}

Result<OpenedLog> openForCopy(const std::filesystem::path& log) {
  Result<LogReader> reader = LogReader::open(log);
  if (!reader) return reader.error();
  if (Status known = knownFormat(*reader); !known) return known.error();
  Result<std::vector<Event>> marks = readMarks(log);
  if (!marks) return marks.error();
  OpenedLog opened{std::move(*reader), {}};
  opened.options.marks = std::move(*marks);
  return opened;
}

Result<std::string> sessionIdOf(LogReader& reader) {
  if (!reader.summary().session_id.empty()) return reader.summary().session_id;
  Result<std::string> content = contentSha256(reader);
  if (!content) return content.error();
  return content->substr(0, kSessionIdDigits);
}

Result<CopyReport> makeLog(std::vector<CopySource>& sources, const MakeOptions& make,
                           const PieceOptions& piece, const std::string& reason, bool may_be_empty,
                           CopyAddition* addition) {
  std::vector<std::filesystem::path> inputs;
  for (const CopySource& source : sources) inputs.emplace_back(source.reader().name());
  Result<OutputFile> output = OutputFile::create(make.output, make.overwrite, inputs);
  if (!output) return output.error();
  Result<CopyReport> report = copyLogs(sources, output->takeSink(), piece, reason, make.progress,
                                       make.attachments, addition);
  if (!report) return output->named(report.error());
  if (report->counts.messages == 0 && !may_be_empty) {
    const CopySource& first = sources.front();
    return nothingChosen(first.reader(), first.options().selection, first.options().range);
  }
  if (Status named = output->commit(); !named) return named.error();
  return report;
}

}  // namespace rocinante
