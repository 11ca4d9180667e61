#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/copy/copy_source.h"
#include "core/copy/output_file.h"
#include "core/copy/piece_writer.h"

/// Makes a log from others: the shared part of cut, filter, merge, split, shift and recover.
///
///   LogReader -> CopySource -+                      +-> PieceWriter (SessionWriter) -> OutputFile
///   LogReader -> CopySource -+-> CopyMerge: items -+-> PieceWriter of the next piece ...
///
/// A CopySource gives the chosen items of one log in order; CopyMerge merges several; a PieceWriter
/// writes one output and makes its keyframes; an OutputFile gets its name once it is complete.
/// Inputs are only read. Memory does not grow with the logs.
namespace rocinante {

/// A part of an input that was not copied.
struct CopyGap {
  std::string input;
  DamageSpan span;    ///< from and to are 0 when the place is unknown
  bool costs = true;  ///< false: nothing is missing in the output
};

struct CopyReport {
  std::string session_id;
  std::optional<LogTime> origin;
  PieceCounts counts;
  std::uint64_t repeated = 0;  ///< messages that several pieces of one session hold
  std::vector<CopyGap> gaps;   ///< damage in the inputs
  std::vector<std::string> notes;
};

/// What a tool adds to a copy.
class CopyAddition {
 public:
  virtual ~CopyAddition() = default;
  /// Whether an attachment of the inputs is copied.
  virtual bool keeps(const LogAttachment& attachment) const = 0;
  /// Whether the cell that an input carries is copied: its record; its attachments are asked for,
  /// too.
  virtual bool keepsCell() const { return true; }
  /// Called once, before anything of the session is written.
  virtual Status begin(PieceWriter& piece, LogTime start) = 0;
  /// Called directly after each item was written.
  virtual Status follow(const CopyItem& item, PieceWriter& piece) = 0;
};

/// Makes one log from the sources. Closes the sink on success. `attachments` false leaves
/// attachments out.
Result<CopyReport> copyLogs(std::vector<CopySource>& sources, std::unique_ptr<ByteSink> sink,
                            const PieceOptions& options, const std::string& reason,
                            const CopyProgress& progress, bool attachments = true,
                            CopyAddition* addition = nullptr);

/// Copies foreign metadata and, if `attachments`, attachments that `addition` keeps; equal ones
/// once. Without its attachments a cell has no record either. Unreadable ones go to `gaps`.
Status copyExtras(const std::vector<CopySource>& sources, PieceWriter& piece, bool attachments,
                  std::vector<CopyGap>& gaps, const CopyAddition* addition = nullptr);

/// Adds the damage of the sources. Call after they are read.
void addGaps(const std::vector<CopySource>& sources, CopyReport& report);

/// The fraction of the sources' time before `time`, 0 to 1.
class CopySpan {
 public:
  explicit CopySpan(const std::vector<CopySource>& sources);
  double partAt(LogTime time) const;

 private:
  LogTime begin_ = LogTime::max();
  LogTime end_{};
};

/// Items between two progress calls.
inline constexpr std::uint64_t kProgressItems = 4096;

}  // namespace rocinante
