#pragma once

#include <memory>
#include <string>

#include "recorder/capture/record.h"

namespace rocinante {

/// The open sink of a recording.
struct RecordSink {
  std::unique_ptr<CaptureSink> sink;
  std::string name;  ///< of the log, or the pattern of a ring's files
};

/// Creates the first log, or checks that a ring's files can be created. `now` is the session's
/// time; `notes` must outlive the sink. Fails when not even one piece can satisfy the options.
Result<RecordSink> makeSink(const RecordOptions& options, LogTime now, NoteBox& notes);

/// For an existing log, the only one of the recording.
std::unique_ptr<CaptureSink> sinkOf(LogWriter log, const RecordOptions& options, NoteBox& notes);

}  // namespace rocinante
