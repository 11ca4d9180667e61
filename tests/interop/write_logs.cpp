// Writes logs for another implementation of MCAP to read, each with what stands in it:
// NAME.mcap, and NAME.jsonl with one message a line, in the order of writing.
// usage: interop_logs FOLDER
#include <sodium.h>

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "core/log/log_writer.h"
#include "core/recording/session_writer.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kStartNs = 1'770'000'000'000'000'000;

std::string base64Of(ByteView bytes) {
  std::string text(sodium_base64_ENCODED_LEN(bytes.size(), sodium_base64_VARIANT_ORIGINAL), '\0');
  sodium_bin2base64(text.data(), text.size(), reinterpret_cast<const unsigned char*>(bytes.data()),
                    bytes.size(), sodium_base64_VARIANT_ORIGINAL);
  text.pop_back();  // the terminating zero
  return text;
}

struct LogPlan {
  std::string name;
  std::size_t channels = 1;
  std::size_t messages = 20'000;
  std::int64_t step_ns = 1'000'000;
  std::int64_t jitter_ns = 0;   ///< times lie up to this beside their place
  std::size_t flush_every = 0;  ///< messages after which 60 ms pass; 0: never
  std::size_t attachments = 0;
  LogWriterOptions writing{};
};

/// Messages of which some are equal, some empty, and most like what machines send.
class MessageMaker {
 public:
  explicit MessageMaker(unsigned seed) : random_(seed) {}

  std::size_t channel(std::size_t count) { return random_() % count; }
  std::int64_t jitter(std::int64_t most) {
    return most == 0 ? 0 : static_cast<std::int64_t>(random_()) % (2 * most) - most;
  }
  Bytes payload(std::size_t number) {
    if (number % 997 == 0) return {};
    if (number % 499 == 0) {
      Bytes noise(random_() % 30'000);
      for (std::byte& each : noise) each = static_cast<std::byte>(random_());
      return noise;
    }
    std::string text = "RK1 source - -\njoints arm";
    for (int joint = 0; joint < 6; ++joint) {
      text += " " + std::to_string(static_cast<double>(random_() % 6283) / 1000);
    }
    const ByteView bytes = bytesOf(text);
    return {bytes.begin(), bytes.end()};
  }

 private:
  std::mt19937 random_;
};

void noteMessage(std::ofstream& notes, const std::string& topic, std::uint32_t sequence,
                 std::int64_t log_time, std::int64_t publish_time, ByteView payload) {
  // Times as text: JSON numbers lose digits elsewhere.
  const nlohmann::ordered_json line = {{"topic", topic},
                                       {"sequence", sequence},
                                       {"log_time", std::to_string(log_time)},
                                       {"publish_time", std::to_string(publish_time)},
                                       {"payload", base64Of(payload)}};
  notes << line.dump() << "\n";
}

Status writeLog(const fs::path& folder, const LogPlan& plan) {
  auto log = LogWriter::create(folder / (plan.name + ".mcap"), plan.writing, "interop");
  if (!log) return log.error();
  std::ofstream notes(folder / (plan.name + ".jsonl"));
  for (std::size_t i = 0; i < plan.attachments; ++i) {
    const Bytes data(i * 70'000, static_cast<std::byte>(i));
    Status attached =
        log->writeAttachment("files/" + std::to_string(i) + ".bin", "application/octet-stream",
                             LogTime(Nanoseconds(kStartNs)), data);
    if (!attached) return attached;
    Status told =
        log->writeMetadata({"note-" + std::to_string(i), {{"number", std::to_string(i)}}});
    if (!told) return told;
  }
  std::vector<ChannelId> channels;
  std::vector<std::string> topics;
  std::vector<std::uint32_t> sequences(plan.channels);
  for (std::size_t i = 0; i < plan.channels; ++i) {
    topics.push_back("/udp/19960/source" + std::to_string(i));
    const auto channel =
        log->addChannel(topics.back(), "octets", {{"remote", "127.0.0.1:" + std::to_string(i)}});
    if (!channel) return channel.error();
    channels.push_back(*channel);
  }
  MessageMaker make(7);
  SteadyTime now{};
  for (std::size_t i = 0; i < plan.messages; ++i) {
    const std::size_t channel = make.channel(plan.channels);
    // Every tenth message has the time of the one before.
    const std::int64_t place = static_cast<std::int64_t>(i % 10 == 9 ? i - 1 : i) * plan.step_ns;
    const std::int64_t log_time = kStartNs + place + make.jitter(plan.jitter_ns);
    const std::int64_t publish_time = log_time - 250'000;
    const Bytes payload = make.payload(i);
    const std::uint32_t sequence = sequences[channel]++;
    noteMessage(notes, topics[channel], sequence, log_time, publish_time, payload);
    Status written = log->write(channels[channel], sequence, LogTime(Nanoseconds(log_time)),
                                publish_time, payload);
    if (!written) return written;
    if (plan.flush_every != 0 && i % plan.flush_every == 0) {
      now += std::chrono::milliseconds(60);
      if (Status flushed = log->flushIfDue(now); !flushed) return flushed;
    }
  }
  return log->close("interop");
}

/// A session as the recorder writes it, with keyframes.
Status writeSession(const fs::path& folder, const std::string& name) {
  LogWriterOptions writing{};
  writing.chunk_bytes = 1U << 16U;
  auto log = LogWriter::create(folder / (name + ".mcap"), writing, "interop");
  if (!log) return log.error();
  KeyframeOptions keyframes;
  keyframes.packets = 500;
  SessionWriter session(std::move(*log), keyframes);
  std::ofstream notes(folder / (name + ".jsonl"));
  const std::string topic = "/udp/19960/arm";
  const auto channel = session.addChannel(topic, "rk1", {});
  if (!channel) return channel.error();
  for (std::uint32_t i = 0; i < 5'000; ++i) {
    const std::int64_t time = kStartNs + std::int64_t{i} * 1'000'000;
    const std::string text =
        "RK1 arm@1 " + std::to_string(i) + " -\njoints arm " + std::to_string(i) + " 0.5\n";
    noteMessage(notes, topic, i, time, time, bytesOf(text));
    Status written = session.write(*channel, i, LogTime(Nanoseconds(time)), time, bytesOf(text));
    if (!written) return written;
  }
  if (session.keyframes() == 0) {
    return Error{ErrorKind::unsupported, "no keyframe was written", name};
  }
  return session.log().close("interop");
}

Status writeAll(const fs::path& folder) {
  LogWriterOptions small;
  small.chunk_bytes = 1U << 16U;
  LogWriterOptions plain = small;
  plain.compression = LogWriterOptions::Compression::none;
  LogPlan one{"one_channel", 1};
  one.writing = small;
  LogPlan fifty{"fifty_channels", 50};
  fifty.writing = small;
  LogPlan disorder{"out_of_order", 50};
  disorder.jitter_ns = 2'000'000'000;
  disorder.attachments = 4;
  disorder.writing = small;
  LogPlan uncompressed{"uncompressed", 5};
  uncompressed.writing = plain;
  // Chunks that were begun in the file before they were full.
  LogPlan slow{"slow", 3};
  slow.flush_every = 50;
  slow.writing = small;
  LogPlan slow_plain = slow;
  slow_plain.name = "slow_uncompressed";
  slow_plain.writing = plain;
  LogPlan empty{"empty", 0, 0};
  for (const LogPlan& plan : {one, fifty, disorder, uncompressed, slow, slow_plain, empty}) {
    if (Status written = writeLog(folder, plan); !written) return written;
  }
  return writeSession(folder, "keyframes");
}

}  // namespace
}  // namespace rocinante

int main(int argc, char** argv) {
  if (argc != 2 || sodium_init() < 0) return 2;
  const rocinante::Status written = rocinante::writeAll(argv[1]);
  if (written) return 0;
  std::fprintf(stderr, "interop_logs: %s\n", written.error().text().c_str());
  return 1;
}
