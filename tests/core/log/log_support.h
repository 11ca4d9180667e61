#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/log/log_reader.h"
#include "core/log/log_writer.h"

namespace rocinante::test {

/// A message with its own copy of the payload, for comparisons.
struct KeptMessage {
  std::string topic;
  std::uint32_t sequence = 0;
  std::int64_t log_time_ns = 0;
  std::int64_t publish_time_ns = 0;
  std::string payload;
  auto operator<=>(const KeptMessage&) const = default;
};

inline void PrintTo(const KeptMessage& message, std::ostream* out) {
  *out << message.topic << " #" << message.sequence << " at " << message.log_time_ns << ": "
       << message.payload;
}

inline LogTime at(std::int64_t nanoseconds) { return LogTime(Nanoseconds(nanoseconds)); }

inline KeptMessage keep(const LogMessage& message) {
  return {message.channel->topic, message.sequence, message.log_time.time_since_epoch().count(),
          message.publish_time_ns, std::string(textOf(message.payload))};
}

/// Every message from the reader's current position.
inline std::vector<KeptMessage> readAll(LogReader& reader) {
  std::vector<KeptMessage> messages;
  while (true) {
    Result<std::optional<LogMessage>> message = reader.next();
    if (!message.ok()) {
      ADD_FAILURE() << message.error().text();
      break;
    }
    if (!*message) break;
    messages.push_back(keep(**message));
  }
  return messages;
}

inline std::vector<std::string> payloads(LogReader& reader) {
  std::vector<std::string> out;
  for (const KeptMessage& message : readAll(reader)) out.push_back(message.payload);
  return out;
}

inline LogWriter makeWriter(Bytes& out, const LogWriterOptions& options = {}) {
  Result<LogWriter> writer = LogWriter::createOn(makeMemorySink(out), options, "session-1");
  EXPECT_TRUE(writer.ok());
  return std::move(*writer);
}

/// The reader refers to `bytes` for as long as it lives.
inline LogReader openLog(ByteView bytes) {
  Result<LogReader> reader = LogReader::openBytes(bytes, "test.mcap");
  EXPECT_TRUE(reader.ok()) << reader.error().text();
  return std::move(*reader);
}
LogReader openLog(Bytes&& gone) = delete;

/// A fresh allocation of exactly `size` bytes, so that AddressSanitizer sees one byte too many.
inline Bytes cutAt(const Bytes& bytes, std::size_t size) {
  Bytes cut(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
  cut.shrink_to_fit();
  return cut;
}

}  // namespace rocinante::test
