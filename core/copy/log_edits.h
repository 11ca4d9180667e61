#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/copy/log_make.h"
#include "core/foreign/decode/datagram_decoders.h"
#include "core/foreign/decode/decode_account.h"

namespace rocinante {

/// Merges several logs. Pieces of one session give that session, and shared messages are taken
/// once; different sessions give a new one whose id is derived from theirs. Times count from the
/// earliest origin. At equal times the log named first comes first, and among pieces of one session
/// the one that begins first.
Result<CopyReport> mergeLogs(const std::vector<std::filesystem::path>& logs,
                             const MakeOptions& make);

/// Copies the messages and times that `selection` names into a self-contained log. `reason` is the
/// tool's name. not_found when no captured message is chosen.
Result<CopyReport> cutLog(const std::filesystem::path& log, const SelectionOptions& selection,
                          const MakeOptions& make, const std::string& reason,
                          CopyAddition* addition = nullptr);

struct ShiftOptions {
  std::string by;        ///< a duration; or
  std::string to;        ///< RFC 3339: the new origin of the session
  bool publish = false;  ///< move the senders' times too
};

/// Moves a log in time. bad_argument when a time would be before 1970 or after 2262.
Result<CopyReport> shiftLog(const std::filesystem::path& log, const ShiftOptions& shift,
                            const MakeOptions& make);

/// Copies the readable part of a log that is cut off, damaged, without an index or never closed
/// into a complete log. Keeps the input's end reason if it is known. Marks beside the log are
/// copied into it. damaged when nothing can be read. The report's gaps that cost something are what
/// is missing; the checksum of the whole data section is checked too.
Result<CopyReport> recoverLog(const std::filesystem::path& log, const MakeOptions& make);

/// The same for bytes in memory, into any sink; `name` is used in messages.
Result<CopyReport> recoverBytes(ByteView bytes, std::string name, std::vector<Event> marks,
                                std::unique_ptr<ByteSink> sink, const LogWriterOptions& log,
                                const KeyframeOptions& keyframes, const CopyProgress& progress);

struct DecodeReport {
  CopyReport copy;
  decode::DecodeAccount account;
};

/// Makes a log with the packets that `decoders` make of a log's octets, in place of those that
/// others made: captured messages stay as they are.
Result<DecodeReport> decodeLog(const std::filesystem::path& log, decode::DatagramDecoders& decoders,
                               const MakeOptions& make);

}  // namespace rocinante
