#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/copy/log_copy.h"

namespace rocinante {

/// Options of an output, for every tool.
struct MakeOptions {
  std::filesystem::path output;
  bool overwrite = false;
  LogWriterOptions log;
  KeyframeOptions keyframes;
  bool attachments = true;  ///< copied too
  CopyProgress progress;
};

/// Every event of a log, oldest first, if `needed`: events in datagrams, and marks. Damage that may
/// hide an event is added to `hiding`.
Result<std::vector<Event>> eventsOf(const std::filesystem::path& log, bool needed,
                                    StateDamage& hiding);

/// An input log with the marks beside it; nothing chosen yet.
struct OpenedLog {
  LogReader reader;
  CopySource::Options options;
};
/// unsupported when the log has an unknown format: its copy would claim to have ours.
Result<OpenedLog> openForCopy(const std::filesystem::path& log);
Status knownFormat(const LogReader& reader);

/// The log's session id, or the beginning of its content_sha256 if another program wrote it without
/// one.
Result<std::string> sessionIdOf(LogReader& reader);

/// Runs copyLogs() into the file that `make` names, which appears whole or not at all. not_found,
/// and no file, when no captured message was chosen, unless `may_be_empty`.
Result<CopyReport> makeLog(std::vector<CopySource>& sources, const MakeOptions& make,
                           const PieceOptions& piece, const std::string& reason, bool may_be_empty,
                           CopyAddition* addition = nullptr);

}  // namespace rocinante
