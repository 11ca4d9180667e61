#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "recorder/copy/copy_source.h"
#include "recorder/copy/output_file.h"
#include "recorder/copy/piece_writer.h"

/// How a log is made out of others: what cut, filter, merge, split, shift and recover share.
///
///   LogReader -> CopySource -+                      +-> PieceWriter (SessionWriter) -> OutputFile
///   LogReader -> CopySource -+-> CopyMerge: items -+-> PieceWriter of the next piece ...
///
/// A CopySource gives what is chosen of one log, in order; CopyMerge puts several together; a
/// PieceWriter writes one output and makes its keyframes; an OutputFile appears under its name once
/// everything stands in it. Inputs are only read. Memory does not grow with the logs.
namespace rocinante {

/// Something of an input that did not go over.
struct CopyGap {
  std::string input;
  DamageSpan span;    ///< from and to are 0 when the place is not known
  bool costs = true;  ///< false: nothing is missing in the output
};

struct CopyReport {
  std::string session_id;
  std::optional<LogTime> origin;
  PieceCounts counts;
  std::uint64_t repeated = 0;  ///< messages that several pieces of one session held
  std::vector<CopyGap> gaps;   ///< damage of the inputs
  std::vector<std::string> notes;
};

/// Makes one log out of the sources. The sink is closed on success. `attachments` false
/// leaves those out.
Result<CopyReport> copyLogs(std::vector<CopySource>& sources, std::unique_ptr<ByteSink> sink,
                            const PieceOptions& options, const std::string& reason,
                            const CopyProgress& progress, bool attachments = true);

/// The metadata that is not ours and, if `attachments`, those, each that is equal once. What cannot
/// be read of them goes to `gaps`.
Status copyExtras(const std::vector<CopySource>& sources, PieceWriter& piece, bool attachments,
                  std::vector<CopyGap>& gaps);

/// What of the sources could not be used, once they are read.
void addGaps(const std::vector<CopySource>& sources, CopyReport& report);

/// Which part of the sources' time lies before `time`, 0 to 1.
class CopySpan {
 public:
  explicit CopySpan(const std::vector<CopySource>& sources);
  double partAt(LogTime time) const;

 private:
  LogTime begin_ = LogTime::max();
  LogTime end_{};
};

/// How often progress is told, in items.
inline constexpr std::uint64_t kProgressItems = 4096;

}  // namespace rocinante
