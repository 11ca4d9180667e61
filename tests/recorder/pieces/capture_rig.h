#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/foreign/live/received_decoder.h"
#include "core/log/content_hash.h"
#include "core/log/log_reader.h"
#include "core/session/timeline.h"
#include "recorder/capture/record_sink.h"
#include "tests/core/recording/fake_clocks.h"
#include "tests/support/temporary_folder.h"

namespace rocinante::test {

/// A recording without sockets and clocks: datagrams at log times, straight into the writing half.
class CaptureRig {
 public:
  explicit CaptureRig(RecordOptions options, CaptureLimits limits = {}) {
    if (options.log.empty()) options.log = folder / "log.mcap";
    const Endpoint endpoint = Endpoint::parse("127.0.0.1:9").value();
    options.endpoints = {endpoint};
    Result<RecordSink> made = makeSink(options, logTime({}), notes);
    if (!made) {
      refusal = made.error();
      return;
    }
    writer.emplace(std::move(made->sink),
                   std::vector<ListenedEndpoint>{{endpoint, endpoint.address}}, std::move(limits),
                   options.decoders ? std::make_shared<LiveDecoder>(options.decoders) : nullptr);
  }

  /// Advances the time between two arrivals.
  void arrive(Nanoseconds at, std::string_view payload, std::uint16_t port = 5'000) {
    const SocketAddress sender = SocketAddress::parse("10.0.0.1", port).value();
    if (!taken.blocks.empty() &&
        taken.blocks.back()->add(0, logTime(at), sender, bytesOf(payload))) {
      return;
    }
    taken.blocks.push_back(queue.freeBlock());
    ASSERT_TRUE(taken.blocks.back());
    ASSERT_TRUE(taken.blocks.back()->add(0, logTime(at), sender, bytesOf(payload)));
  }
  void lose(Nanoseconds from, Nanoseconds until, std::uint64_t count) {
    EndpointLoss loss{0, logTime(from), logTime(until), {}};
    loss.counts.kernel = count;
    taken.losses.push_back(loss);
  }
  /// Everything before `reached` has arrived.
  void write(Nanoseconds reached) {
    taken.drained_until = logTime(reached) + ReorderWindow::kWidth;
    writer->write(std::exchange(taken, {}), queue);
    writer->flush(SteadyTime(reached + std::chrono::hours(1)));
  }
  RecordedFiles close() {
    writer->close("interrupted", queue);
    return writer->files();
  }

  TemporaryFolder folder;
  NoteBox notes;
  HandOver queue{64};
  TakenOver taken;
  std::optional<CaptureWriter> writer;
  std::optional<Error> refusal;
};

struct ReadMessage {
  std::string topic;
  std::uint32_t sequence;
  LogTime time;
  std::string payload;
};

/// The captured messages of a log, which must be undamaged.
inline std::vector<ReadMessage> messagesOf(const std::filesystem::path& path,
                                           std::string* content = nullptr) {
  std::vector<ReadMessage> messages;
  auto log = LogReader::open(path);
  EXPECT_TRUE(log.ok()) << log.error().text();
  if (!log) return messages;
  EXPECT_TRUE(log->summary().complete) << path;
  ContentHash hash;
  for (auto message = log->next(); message && *message; message = log->next()) {
    hash.add(**message);
    if (!(*message)->channel->captured()) continue;
    messages.push_back({(*message)->channel->topic, (*message)->sequence, (*message)->log_time,
                        std::string(textOf((*message)->payload))});
  }
  EXPECT_TRUE(log->damage().empty()) << path;
  if (content != nullptr) *content = hash.finish();
  return messages;
}

}  // namespace rocinante::test
