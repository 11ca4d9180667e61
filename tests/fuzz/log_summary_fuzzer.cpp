// Any bytes as the summary of a log whose data is sound, its checksum right, so that the reader has
// to judge what they say. Nothing may crash, hang or take memory without bound; every payload is
// one that was written; and where less comes back, damage says so.

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <set>
#include <string>

#include "core/base/hash.h"
#include "core/log/log_reader.h"
#include "core/log/log_writer.h"
#include "core/mcap/append_record.h"
#include "core/mcap/parse_record.h"
#include "core/mcap/records.h"

namespace {

using namespace rocinante;

constexpr int kMessages = 24;

struct SoundLog {
  Bytes data;  ///< up to its DataEnd, that included
  std::set<std::string> payloads;
};

SoundLog makeSoundLog() {
  SoundLog log;
  LogWriterOptions options;
  options.chunk_bytes = 400;
  Result<LogWriter> writer = LogWriter::createOn(makeMemorySink(log.data), options, "session");
  if (!writer) std::abort();
  const Result<ChannelId> a = writer->addChannel("/udp/19960/arm", "rk1", {});
  const Result<ChannelId> b = writer->addChannel("/udp/19960/tool", "octets", {});
  if (!a || !b) std::abort();
  for (int i = 0; i < kMessages; ++i) {
    const std::string payload = "joints arm " + std::to_string(i);
    log.payloads.insert(payload);
    if (!writer->write(i % 4 == 3 ? *b : *a, 0, LogTime(Nanoseconds(1000 + i)), 1,
                       bytesOf(payload))) {
      std::abort();
    }
  }
  if (!writer->writeAttachment("note", "text/plain", LogTime{}, bytesOf("abc"))) std::abort();
  if (!writer->close("finished")) std::abort();
  mcap::Footer footer;
  if (!mcap::parse(ByteView(log.data).last(28).first(20), footer)) std::abort();
  log.data.resize(static_cast<std::size_t>(footer.summary_start));
  return log;
}

Bytes withSummary(const Bytes& data, ByteView summary) {
  Bytes file = data;
  file.insert(file.end(), summary.begin(), summary.end());
  mcap::Footer footer;
  footer.summary_start = data.size();
  append(file, footer);
  const std::uint32_t crc =
      crc32(ByteView(file).subspan(data.size(), file.size() - data.size() - 4));
  std::memcpy(file.data() + file.size() - 4, &crc, sizeof(crc));
  file.insert(file.end(), mcap::magic().begin(), mcap::magic().end());
  return file;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const SoundLog kLog = makeSoundLog();
  const Bytes file =
      withSummary(kLog.data, ByteView(reinterpret_cast<const std::byte*>(data), size));
  Result<LogReader> reader = LogReader::openBytes(file, "fuzz");
  if (!reader) std::abort();
  int count = 0;
  while (const std::optional<LogMessage> message = *reader->next()) {
    if (!kLog.payloads.contains(std::string(textOf(message->payload)))) std::abort();
    ++count;
  }
  if (count > kMessages || (count < kMessages && reader->damage().empty())) std::abort();
  int back = 0;
  while (*reader->previous()) ++back;
  if (back != count && reader->damage().empty()) std::abort();
  for (ChannelId channel = 0; channel < 3; ++channel) {
    (void)reader->lastOf(channel, reader->summary().end);
  }
  (void)reader->losses();
  for (std::size_t i = 0; i < reader->attachments().size(); ++i) (void)reader->readAttachment(i);
  return 0;
}
