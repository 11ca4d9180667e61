// Any bytes as a log: opened, read from the start and back, sought, its attachments read; then
// followed as a file that grows to them. Nothing may crash, hang or take memory without bound; the
// messages come in time order, and the same ones in both directions.

#include <sys/mman.h>
#include <unistd.h>

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

/// From the end, where readOn() left off, to the beginning.
void readBack(LogReader& reader) {
  std::size_t back = 0;
  while (*reader.previous()) ++back;
  std::size_t forth = 0;
  while (*reader.next()) ++forth;
  if (back != forth && reader.damage().empty()) std::abort();
}

/// As a file that grows in four steps.
void follow(ByteView bytes) {
  const int file = ::memfd_create("growing", MFD_CLOEXEC);
  if (file < 0) return;
  Result<LogReader> reader = LogReader::follow("/proc/self/fd/" + std::to_string(file));
  if (!reader) std::abort();
  for (std::size_t step = 1; step <= 4; ++step) {
    const std::size_t from = bytes.size() * (step - 1) / 4;
    const std::size_t until = bytes.size() * step / 4;
    if (::write(file, bytes.data() + from, until - from) < 0) std::abort();
    if (!reader->refresh()) break;
    while (const auto message = *reader->nextInFile()) {
      if (message->channel == nullptr) std::abort();
      // Every byte of a payload is read: a sanitizer sees one too many.
      std::size_t sum = 0;
      for (const std::byte byte : message->payload) sum += static_cast<std::size_t>(byte);
      if (sum > message->payload.size() * 255) std::abort();
    }
  }
  ::close(file);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const ByteView bytes(reinterpret_cast<const std::byte*>(data), size);
  follow(bytes);
  Result<LogReader> reader = LogReader::openBytes(bytes, "fuzz");
  if (!reader) return 0;
  readOn(*reader);
  readBack(*reader);
  const LogSummary& summary = reader->summary();
  if (!reader->seek(summary.start + (summary.end - summary.start) / 2)) std::abort();
  readOn(*reader);
  for (const LogChannel& channel : reader->channels()) {
    const Result<std::optional<LogMessage>> last = reader->lastOf(channel.id, summary.end);
    if (last && *last && (*last)->channel->id != channel.id) std::abort();
  }
  (void)reader->losses();
  for (std::size_t i = 0; i < reader->attachments().size(); ++i) (void)reader->readAttachment(i);
  return 0;
}
