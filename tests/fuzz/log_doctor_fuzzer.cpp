// Any bytes as a log that is examined. Nothing may crash, hang or take memory without bound; both
// reports can be written; and in what breaks no rule, the reader finds no damage either.

#include <cstdlib>

#include "core/log/log_reader.h"
#include "recorder/doctor/log_doctor.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace rocinante;
  const ByteView bytes(reinterpret_cast<const std::byte*>(data), size);
  const Result<DoctorReport> report = examineBytes(bytes, "fuzz");
  if (!report) return 0;
  if (doctorText(*report).empty() || doctorJson(*report, false).empty()) std::abort();
  if (!report->clean()) return 0;
  Result<LogReader> reader = LogReader::openBytes(bytes, "fuzz");
  if (!reader) std::abort();
  while (true) {
    const Result<std::optional<LogMessage>> message = reader->next();
    if (!message) std::abort();
    if (!*message) break;
  }
  if (!reader->damage().empty()) std::abort();
  return 0;
}
