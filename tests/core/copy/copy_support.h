#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "core/base/duration_text.h"
#include "core/copy/log_make.h"
#include "core/packet/packet_text.h"
#include "core/recording/session_writer.h"
#include "core/session/timeline.h"
#include "tests/core/log/log_support.h"
#include "tests/core/packet/random_session.h"
#include "tests/support/temporary_folder.h"

namespace rocinante::test {

/// Log times of these sessions begin here.
inline constexpr std::int64_t kSessionStart = 1'770'000'000'000'000'000;

struct RandomLogOptions {
  std::size_t count = 300;
  std::size_t keyframe_packets = 40;
  std::size_t chunk_bytes = 3000;
  std::string session_id = "session-1";
  std::int64_t start_ns = kSessionStart;
  bool attach = true;
  std::string remote = "127.0.0.1:4000";
};

/// Writes a session to `path` with everything that a log can hold: several sources on several
/// channels, restated datagrams, other bytes, losses, clock steps, an attachment, foreign metadata,
/// keyframes, equal times.
inline void writeRandomLog(const std::filesystem::path& path, std::uint64_t seed,
                           const RandomLogOptions& options = {}) {
  LogWriterOptions writing;
  writing.chunk_bytes = options.chunk_bytes;
  writing.overwrite = true;
  Result<LogWriter> log = LogWriter::create(path, writing, options.session_id);
  ASSERT_TRUE(log.ok()) << log.error().text();
  if (options.attach) {
    const std::string cell = "format = 1\n";
    ASSERT_TRUE(
        log->writeAttachment("cell.toml", "application/toml", at(options.start_ns), bytesOf(cell))
            .ok());
    ASSERT_TRUE(log->writeMetadata({"operator", {{"name", "Amelie"}}}).ok());
  }
  SessionWriter session(std::move(*log),
                        {true, options.keyframe_packets, std::chrono::seconds(10)});
  std::map<std::string, ChannelId> channels;
  std::map<ChannelId, std::uint32_t> sequences;
  const auto channelOf = [&](const std::string& topic, const std::string& encoding,
                             const std::string& source) {
    const auto found = channels.find(topic);
    if (found != channels.end()) return found->second;
    std::map<std::string, std::string> metadata{{"remote", options.remote}};
    if (!source.empty()) metadata["source"] = source;
    if (topic.starts_with("/rocinante/decoded")) metadata["decoder"] = "probe-1";
    const ChannelId id = *session.addChannel(topic, encoding, metadata);
    channels.emplace(topic, id);
    return id;
  };
  RandomSession random(seed);
  PacketTextDecoder decoder;
  std::int64_t last_loss = options.start_ns;
  std::int64_t time_ns = options.start_ns;
  for (std::size_t i = 0; i < options.count; ++i) {
    const RandomSession::Datagram said = random.next();
    // Now and then at the same time as the last.
    if (i == 0 || random.below(8) != 0) {
      time_ns = options.start_ns + std::llround(said.seconds * 1e9);
    }
    const PacketHeader* const header = decoder.decodeHeader(bytesOf(said.text));
    std::string topic = "/udp/1/octets";
    std::string source;
    if (header != nullptr) {
      source = std::string(header->source);
      topic = (header->by.empty() ? "/udp/1/" : "/rocinante/restated/udp/1/") + encodeName(source);
    }
    const ChannelId channel = channelOf(topic, header != nullptr ? "rk1" : "octets", source);
    const std::uint32_t sequence = sequences[channel]++;
    ASSERT_TRUE(
        session.write(channel, sequence, at(time_ns), time_ns - 5, bytesOf(said.text)).ok());
    if (random.below(25) == 0) {
      const std::string bytes("\x00\xff\x01", 3);
      const ChannelId octets = channelOf("/udp/1/127.0.0.1", "octets", {});
      const std::uint32_t number = sequences[octets]++;
      ASSERT_TRUE(session.write(octets, number, at(time_ns), time_ns, bytesOf(bytes)).ok());
      const std::string packet = "RK1 decoded:probe - -\njoints probe " + std::to_string(number);
      const ChannelId packets =
          channelOf("/rocinante/decoded/udp/1/127.0.0.1", "rk1", "decoded:probe");
      ASSERT_TRUE(session.write(packets, number, at(time_ns), time_ns, bytesOf(packet)).ok());
    }
    if (random.below(40) == 0) {
      ASSERT_TRUE(
          session.log().writeLoss({"udp://:1", at(last_loss), at(time_ns), {1, 2, 0, 0}}).ok());
      last_loss = time_ns;
    }
    if (random.below(60) == 0) {
      const std::string step = "{\"noticed_ns\":" + std::to_string(time_ns) + ",\"step_ns\":-5}";
      const ChannelId clock = channelOf("/rocinante/clock", "json", {});
      const std::uint32_t number = sequences[clock]++;
      ASSERT_TRUE(session.write(clock, number, at(time_ns), time_ns, bytesOf(step)).ok());
    }
  }
  ASSERT_TRUE(session.log().close("stopped").ok());
}

/// The captured messages, in order.
inline std::vector<KeptMessage> capturedOf(const std::filesystem::path& path) {
  std::vector<KeptMessage> kept;
  Result<LogReader> reader = LogReader::open(path);
  EXPECT_TRUE(reader.ok()) << reader.error().text();
  if (!reader) return kept;
  while (true) {
    const Result<std::optional<LogMessage>> message = reader->next();
    if (!message.ok() || !*message) break;
    if ((*message)->channel->captured()) kept.push_back(keep(**message));
  }
  EXPECT_TRUE(reader->damage().empty()) << path << ": " << reader->damage().front().cause;
  EXPECT_TRUE(reader->summary().complete);
  return kept;
}

inline std::vector<KeptMessage> messagesOf(const std::filesystem::path& path) {
  Result<LogReader> reader = LogReader::open(path);
  EXPECT_TRUE(reader.ok()) << reader.error().text();
  return reader.ok() ? readAll(*reader) : std::vector<KeptMessage>{};
}

inline LogReader openLogAt(const std::filesystem::path& path) {
  Result<LogReader> reader = LogReader::open(path);
  EXPECT_TRUE(reader.ok()) << reader.error().text();
  return std::move(*reader);
}

inline std::size_t countOn(const std::vector<KeptMessage>& messages, std::string_view topic) {
  std::size_t count = 0;
  for (const KeptMessage& message : messages) count += message.topic == topic ? 1U : 0U;
  return count;
}

inline std::string hashOf(const std::filesystem::path& path) {
  Result<LogReader> reader = LogReader::open(path);
  return reader.ok() ? contentSha256(*reader).value_or("") : "";
}

/// Expects the same states in both logs at the times of the messages in [from, until) and just
/// before the next.
inline void expectSameStates(const std::filesystem::path& expected,
                             const std::filesystem::path& actual, std::int64_t from,
                             std::int64_t until) {
  Result<Timeline> a = Timeline::open(expected);
  Result<Timeline> b = Timeline::open(actual);
  ASSERT_TRUE(a.ok() && b.ok());
  std::vector<std::int64_t> times{from};
  for (const KeptMessage& message : capturedOf(expected)) {
    if (message.log_time_ns < from || message.log_time_ns >= until) continue;
    times.push_back(message.log_time_ns - 1);
    times.push_back(message.log_time_ns);
  }
  for (const std::int64_t time : times) {
    if (time < from || time >= until) continue;
    const Result<const SessionState*> in_a = a->stateAt(at(time));
    const Result<const SessionState*> in_b = b->stateAt(at(time));
    ASSERT_TRUE(in_a.ok() && in_b.ok());
    ASSERT_TRUE((*in_a)->sameAs(**in_b)) << "at " << time << " expected\n"
                                         << (*in_a)->identityText() << "\nbut\n"
                                         << (*in_b)->identityText();
  }
}

inline MakeOptions makeAt(const std::filesystem::path& path) {
  MakeOptions make;
  make.output = path;
  make.log.chunk_bytes = 2000;
  make.keyframes.packets = 30;
  return make;
}

/// `nanoseconds` as a session time for the command line.
inline std::string rfcOf(std::int64_t nanoseconds) {
  return rfc3339Text(WallTime(Nanoseconds(nanoseconds)));
}

}  // namespace rocinante::test
