#include "core/copy/log_copy.h"

#include <algorithm>
#include <set>

#include "core/base/hash.h"
#include "core/copy/copy_merge.h"
#include "core/log/log_profile.h"

namespace rocinante {

CopySpan::CopySpan(const std::vector<CopySource>& sources) {
  for (const CopySource& source : sources) {
    const LogSummary& summary = source.reader().summary();
    const TimeRange& range = source.options().range;
    begin_ = std::min(begin_, source.shifted(std::max(summary.start, range.from)));
    end_ = std::max(end_, source.shifted(std::min(summary.end, range.until)));
  }
}

double CopySpan::partAt(LogTime time) const {
  if (end_ <= begin_) return 1;
  const double part =
      static_cast<double>((time - begin_).count()) / static_cast<double>((end_ - begin_).count());
  return std::clamp(part, 0.0, 1.0);
}

Status copyExtras(const std::vector<CopySource>& sources, PieceWriter& piece, bool attachments,
                  std::vector<CopyGap>& gaps, const CopyAddition* addition) {
  std::set<std::pair<std::string, std::map<std::string, std::string>>> metadata;
  std::set<std::tuple<std::string, std::string, std::string>> copied;
  for (const CopySource& source : sources) {
    const LogReader& reader = source.reader();
    for (const LogMetadata& record : reader.metadata()) {
      if (record.name == profile::kSession || record.name == profile::kEnd) continue;
      const bool keeps_cell = attachments && (addition == nullptr || addition->keepsCell());
      if (record.name == profile::kCell && !keeps_cell) continue;
      if (!metadata.emplace(record.name, record.entries).second) continue;
      if (Status written = piece.addMetadata(record); !written) return written;
    }
    for (std::size_t i = 0; attachments && i < reader.attachments().size(); ++i) {
      LogAttachment attachment = reader.attachments()[i];
      if (addition != nullptr && !addition->keeps(attachment)) continue;
      const Result<Bytes> data = reader.readAttachment(i);
      if (!data) {
        gaps.push_back({reader.name(), {0, 0, data.error().text(), std::uint64_t{0}}, true});
        continue;
      }
      Sha256 hash;
      hash.add(*data);
      const Sha256::Digest digest = hash.finish();
      if (!copied.emplace(attachment.name, attachment.media_type, hexOf(digest)).second) {
        continue;
      }
      // An attachment from outside the session's time is not shifted.
      const std::int64_t time = attachment.log_time.time_since_epoch().count();
      if (time != 0) attachment.log_time = std::max(source.shifted(attachment.log_time), LogTime{});
      if (Status written = piece.addAttachment(attachment, *data); !written) return written;
    }
  }
  return {};
}

void addGaps(const std::vector<CopySource>& sources, CopyReport& report) {
  for (const CopySource& source : sources) {
    for (const DamageSpan& span : source.reader().damage()) {
      // Damage without bytes, or known to have cost no message, leaves the output complete.
      const bool costs = span.to > span.from && span.messages_lost != std::uint64_t{0};
      report.gaps.push_back({source.reader().name(), span, costs});
    }
    report.notes.insert(report.notes.end(), source.notes().begin(), source.notes().end());
  }
}

Result<CopyReport> copyLogs(std::vector<CopySource>& sources, std::unique_ptr<ByteSink> sink,
                            const PieceOptions& options, const std::string& reason,
                            const CopyProgress& progress, bool attachments,
                            CopyAddition* addition) {
  CopyReport report;
  report.session_id = options.session_id;
  report.origin = options.origin;
  Result<PieceWriter> piece = PieceWriter::start(std::move(sink), options);
  if (!piece) return piece.error();
  if (Status copied = copyExtras(sources, *piece, attachments, report.gaps, addition); !copied)
    return copied.error();
  if (addition != nullptr) {
    const LogTime start = options.origin.value_or(LogTime{});
    if (Status begun = addition->begin(*piece, start); !begun) return begun.error();
  }
  const CopySpan span(sources);
  CopyMerge merge(sources);
  for (std::uint64_t count = 1;; ++count) {
    const Result<const CopyItem*> item = merge.next();
    if (!item) return item.error();
    if (*item == nullptr) break;
    if (progress && count % kProgressItems == 0) {
      if (Status on = progress(span.partAt((*item)->time)); !on) return on.error();
    }
    if (Status added = piece->add(**item); !added) return added.error();
    if (addition == nullptr) continue;
    if (Status followed = addition->follow(**item, *piece); !followed) return followed.error();
  }
  if (Status closed = piece->finish(reason); !closed) return closed.error();
  report.counts = piece->counts();
  report.repeated = merge.repeated();
  addGaps(sources, report);
  return report;
}

}  // namespace rocinante
