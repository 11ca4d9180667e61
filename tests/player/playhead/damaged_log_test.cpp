// Playing a log that is damaged in the middle.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "core/base/atomic_file.h"
#include "tests/player/playhead/deck.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;
using test::Deck;

constexpr int kMessages = 400;

std::string payloadOf(int number) {
  return "RK1 arm@r1 " + std::to_string(number) + " -\njoints arm " + std::to_string(number) + "\n";
}

/// 400 messages, 10 ms apart, in chunks of about a dozen; one byte of the middle chunk is changed.
std::filesystem::path writeDamaged(const std::filesystem::path& path) {
  LogWriterOptions options;
  options.chunk_bytes = 2048;
  options.compression = LogWriterOptions::Compression::none;
  auto writer = LogWriter::create(path, options, "session").value();
  const ChannelId channel = writer.addChannel("/udp/1/arm", "rk1", {{"source", "arm"}}).value();
  for (int i = 0; i < kMessages; ++i) {
    const LogTime at(1s + i * 10ms);
    EXPECT_TRUE(
        writer.write(channel, static_cast<std::uint32_t>(i), at, 0, bytesOf(payloadOf(i))).ok());
  }
  EXPECT_TRUE(writer.close("test").ok());
  std::string bytes = readFile(path).value();
  const std::size_t middle = bytes.find(payloadOf(kMessages / 2));
  EXPECT_NE(middle, bytes.npos);
  bytes[middle] ^= '\x55';
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

class DamagedLog : public testing::Test {
 protected:
  DamagedLog() : log_(writeDamaged(folder_ / "log")) {
    MultiLogReader logs = MultiLogReader::open({log_}).value();
    EXPECT_TRUE(logs.seek(TapePosition{}, MultiLogReader::Which::captured).ok());
    while (const auto message = logs.next().value()) {
      all_.emplace_back(textOf(message->payload));
      times_.push_back(message->log_time);
    }
    damage_ = logs.damage();
    for (std::size_t i = 1; i < times_.size(); ++i) {
      if (times_[i] - times_[i - 1] > 10ms) hole_ = i;
    }
  }
  std::string second(LogTime time) const {
    return std::to_string(
               std::chrono::duration_cast<std::chrono::milliseconds>(time - LogTime(1s)).count()) +
           "ms";
  }

  test::TemporaryFolder folder_;
  std::filesystem::path log_;
  std::vector<std::string> all_, damage_;
  std::vector<LogTime> times_;
  std::size_t hole_ = 0;  ///< the first message after the damage
};

TEST_F(DamagedLog, IsPlayedAroundItsDamage) {
  ASSERT_GT(hole_, 0U);
  ASSERT_FALSE(damage_.empty());
  ASSERT_LT(all_.size(), static_cast<std::size_t>(kMessages));
  Deck deck({log_});
  deck.playFor(1min);
  EXPECT_EQ(deck.payloads(), all_);
  EXPECT_EQ(deck.playhead().state(), Playhead::State::ended);
  deck.expectStateOfPlace();
}

TEST_F(DamagedLog, IsSoughtIntoAndSteppedAcross) {
  ASSERT_GT(hole_, 0U);
  PlayheadOptions options;
  options.start_paused = true;
  Deck deck({log_}, options);
  const LogTime inside = times_[hole_] - 15ms;
  EXPECT_THAT(deck.say("seek " + second(inside)), testing::StartsWith("ok "));
  deck.expectStateOfPlace();
  deck.say("step");
  EXPECT_EQ(deck.payloads().back(), all_[hole_]);
  deck.say("back 2");
  deck.expectStateOfPlace();
  deck.say("step 3");
  ASSERT_EQ(deck.payloads().size(), 4U);
  EXPECT_EQ(deck.payloads()[1], all_[hole_ - 1]);
  EXPECT_EQ(deck.payloads()[2], all_[hole_]);
  EXPECT_EQ(deck.payloads()[3], all_[hole_ + 1]);
  deck.expectStateOfPlace();
}

TEST_F(DamagedLog, BesideAnotherLogLosesNothingOfThat) {
  std::vector<test::WrittenMessage> whole;
  for (int i = 0; i < kMessages; ++i) {
    whole.push_back({1s + i * 10ms, "RK1 b - -\njoints b " + std::to_string(i) + "\n", "/udp/1/b"});
  }
  const auto other = test::writeLog(folder_ / "other", whole);
  Deck deck({log_, other});
  deck.playFor(1min);
  EXPECT_EQ(deck.payloads().size(), all_.size() + whole.size());
  deck.expectStateOfPlace();
}

}  // namespace
}  // namespace rocinante
