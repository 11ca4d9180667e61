// Any bytes as a log that is recovered into memory. What comes out must be a whole log without
// damage that holds, in the same order, every captured message that could be read of the bytes, and
// the strict reader must take it from its first record to its last.

#include <cstdlib>
#include <string>
#include <vector>

#include "core/copy/log_edits.h"
#include "tests/support/stream_reader.h"

namespace {

using namespace rocinante;

/// The captured messages, each as bytes that are equal only for equal messages.
std::vector<std::string> captured(LogReader& reader) {
  std::vector<std::string> messages;
  if (!reader.rewind()) std::abort();
  while (true) {
    const Result<std::optional<LogMessage>> message = reader.next();
    if (!message || !*message) return messages;
    const LogMessage& each = **message;
    if (!each.channel->captured()) continue;
    messages.push_back(
        each.channel->topic + '\n' + each.channel->encoding + '\n' + std::to_string(each.sequence) +
        '\n' + std::to_string(each.log_time.time_since_epoch().count()) + '\n' +
        std::to_string(each.publish_time_ns) + '\n' + std::string(textOf(each.payload)));
  }
}

void readStrictly(ByteView file) {
  Result<test::StreamReader> reader = test::StreamReader::open(file);
  if (!reader) std::abort();
  while (true) {
    const Result<std::optional<mcap::Record>> record = reader->next();
    if (!record) std::abort();
    if (!*record) return;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const ByteView bytes(reinterpret_cast<const std::byte*>(data), size);
  Result<LogReader> before = LogReader::openBytes(bytes, "fuzz");
  if (!before) return 0;
  Bytes out;
  LogWriterOptions writing;
  writing.chunk_bytes = 1U << 16U;
  const Result<CopyReport> report =
      recoverBytes(bytes, "fuzz", {}, makeMemorySink(out), writing, {true, 100, {}}, {});
  const std::vector<std::string> expected = captured(*before);
  if (!report) {
    // Times that only a foreign log has, or nothing at all: then nothing may be lost by it.
    if (!expected.empty() && report.error().kind == ErrorKind::damaged) std::abort();
    return 0;
  }
  readStrictly(out);
  Result<LogReader> after = LogReader::openBytes(out, "recovered");
  if (!after || !after->summary().complete) std::abort();
  if (captured(*after) != expected) std::abort();
  if (!after->damage().empty()) std::abort();
  return 0;
}
