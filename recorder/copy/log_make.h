#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
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

}  // namespace rocinante
