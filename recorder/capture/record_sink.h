#pragma once

#include <memory>
#include <string>

#include "recorder/capture/record.h"

namespace rocinante {

/// What a recording is to go into, made ready.
struct RecordSink {
  std::unique_ptr<CaptureSink> sink;
  std::string name;  ///< of the log, or of what a ring's files will be called
};

/// Makes the first log, or looks whether a ring's files can be made. `now` is the session's time;
/// `notes` must outlive the sink. Fails where not even one piece would be as the options want it.
Result<RecordSink> makeSink(const RecordOptions& options, LogTime now, NoteBox& notes);

/// For a log that was made already, which stays the only one.
std::unique_ptr<CaptureSink> sinkOf(LogWriter log, const RecordOptions& options, NoteBox& notes);

}  // namespace rocinante
