#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/result.h"
#include "recorder/copy/log_copy.h"

namespace rocinante {

/// How an output is to be made, whichever tool makes it.
struct MakeOptions {
  std::filesystem::path output;
  bool overwrite = false;
  LogWriterOptions log;
  KeyframeOptions keyframes;
  bool attachments = true;  ///< copied too
  CopyProgress progress;
};

/// Every event of a log, oldest first, if `needed`: those of its datagrams, and the marks that
/// people set. Damage of the log that may hide one is added to `hiding`.
Result<std::vector<Event>> eventsOf(const std::filesystem::path& log, bool needed,
                                    StateDamage& hiding);

/// A log opened to be copied from, with the marks beside it; nothing chosen yet.
struct OpenedLog {
  LogReader reader;
  CopySource::Options options;
};
/// unsupported when the log has a format that we do not know: its copy would claim to have ours.
Result<OpenedLog> openForCopy(const std::filesystem::path& log);
Status knownFormat(const LogReader& reader);

/// What names the session of a log that does not say it itself (one made by another program): the
/// beginning of its content_sha256.
Result<std::string> sessionIdOf(LogReader& reader);

/// copyLogs() into the file that `make` names: it appears whole or not at all. not_found, and no
/// file, when no captured message was chosen, unless `may_be_empty`.
Result<CopyReport> makeLog(std::vector<CopySource>& sources, const MakeOptions& make,
                           const PieceOptions& piece, const std::string& reason, bool may_be_empty);

/// The part of a log that `selection` names, its times included, as a log that stands alone.
/// `reason` is the tool's name. not_found when no captured message is chosen.
Result<CopyReport> cutLog(const std::filesystem::path& log, const SelectionOptions& selection,
                          const MakeOptions& make, const std::string& reason);

/// Several logs as one. Those of one session stay that session, and what several of them hold is
/// taken once; else a new one, named by theirs. Times count from the earliest origin. At one time
/// the log named first comes first, and of pieces of one session the one that begins first.
Result<CopyReport> mergeLogs(const std::vector<std::filesystem::path>& logs,
                             const MakeOptions& make);

struct ShiftOptions {
  std::string by;        ///< a duration; or
  std::string to;        ///< RFC 3339: when the session's origin shall have been
  bool publish = false;  ///< the senders' times too
};

/// The log at another time. bad_argument when a time would lie before 1970 or beyond 2262.
Result<CopyReport> shiftLog(const std::filesystem::path& log, const ShiftOptions& shift,
                            const MakeOptions& make);

}  // namespace rocinante
