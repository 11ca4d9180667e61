// Any bytes as a log: opened, read from the start, sought, its attachments read. Nothing may crash,
// hang or take memory without bound, and the messages come in time order.

#include <cstdlib>
#include <limits>

#include "core/log/log_reader.h"

namespace {

using namespace rocinante;

/// Reads on; aborts where the order is broken. Damage that says so excuses it.
void readOn(LogReader& reader) {
  LogTime last{Nanoseconds(std::numeric_limits<std::int64_t>::min())};
  std::uint64_t last_place = 0;
  while (true) {
    const Result<std::optional<LogMessage>> message = reader.next();
    if (!message || !*message) return;
    const LogMessage& each = **message;
    if (each.channel == nullptr) std::abort();
    const bool in_order =
        each.log_time > last || (each.log_time == last && each.file_offset > last_place);
    if (!in_order && last_place != 0 && reader.damage().empty()) std::abort();
    last = each.log_time;
    last_place = each.file_offset;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const ByteView bytes(reinterpret_cast<const std::byte*>(data), size);
  Result<LogReader> reader = LogReader::openBytes(bytes, "fuzz");
  if (!reader) return 0;
  readOn(*reader);
  const LogSummary& summary = reader->summary();
  if (!reader->seek(summary.start + (summary.end - summary.start) / 2)) std::abort();
  readOn(*reader);
  for (std::size_t i = 0; i < reader->attachments().size(); ++i) (void)reader->readAttachment(i);
  return 0;
}
