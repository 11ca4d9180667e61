#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>

#include "core/log/log_reader.h"
#include "core/net/udp_socket.h"
#include "tests/support/programs.h"

// Follows a log while a recorder writes it, both as programs, over loopback.
namespace rocinante::test {
namespace {

class FollowARecorder : public testing::TestWithParam<const char*> {
 protected:
  FollowARecorder()
      : recorder_(Program::start("rocinante-record", {"udp://127.0.0.1:0", "-o", log().string(),
                                                      "--compression", GetParam()})) {
    std::istringstream words(recorder_.waitForLine("recording "));
    for (std::string word; words >> word;) {
      if (word.starts_with("udp://")) endpoint_ = word;
    }
  }

  std::filesystem::path log() const { return folder_ / "log.mcap"; }
  Program follow(std::vector<std::string> options) {
    options.insert(options.begin(), {"follow", log().string(), "--format", "json"});
    return Program::start("rocinante-log", options);
  }

  TemporaryFolder folder_;
  Program recorder_;
  std::string endpoint_;
};

TEST_P(FollowARecorder, AndSeeEachDatagramBesideItAndAllOfThemAtItsEnd) {
  Program all = follow({"--from-start"});
  Program some = follow({"--from-start", "--channel", "*/second"});
  Result<Endpoint> endpoint = Endpoint::parse(endpoint_);
  ASSERT_TRUE(endpoint.ok()) << endpoint.error().text();
  Result<UdpSender> sender = UdpSender::open(*endpoint);
  ASSERT_TRUE(sender.ok()) << sender.error().text();
  Result<LogReader> follower = Error{ErrorKind::not_found, "not open yet", {}};
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  for (int i = 0; i < 25; ++i) {
    const std::string datagram = std::string("RK1 ") + (i % 5 == 0 ? "second " : "first ") +
                                 std::to_string(i) + " -\njoints arm " + std::to_string(i);
    ASSERT_TRUE(sender->send(bytesOf(datagram)).ok());
    // It comes before the next one is sent: nothing has to be closed for that.
    std::string came;
    while (came.empty() && std::chrono::steady_clock::now() < give_up) {
      if (!follower.ok()) follower = LogReader::follow(log());
      if (follower.ok()) {
        const Result<std::optional<LogMessage>> message = follower->nextInFile();
        ASSERT_TRUE(message.ok()) << message.error().text();
        if (*message && (*message)->channel->captured()) came = textOf((*message)->payload);
        if (!*message) {
          ASSERT_TRUE(follower->refresh().ok());
        }
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ASSERT_EQ(came, datagram);
    ASSERT_FALSE(follower->ended());
  }
  EXPECT_EQ(recorder_.stop().exit_code, 0);
  const ProgramResult all_seen = all.finish();
  const ProgramResult some_seen = some.finish();
  EXPECT_EQ(all_seen.exit_code, 0) << all_seen.err;
  EXPECT_EQ(some_seen.exit_code, 0) << some_seen.err;
  const ProgramResult stored =
      runProgram("rocinante-log", {"cat", log().string(), "--format", "json"});
  EXPECT_EQ(all_seen.out, stored.out);
  EXPECT_EQ(std::ranges::count(all_seen.out, '\n'), 25);
  EXPECT_EQ(std::ranges::count(some_seen.out, '\n'), 5);
  while (!follower->ended()) ASSERT_TRUE(follower->refresh().ok());
  EXPECT_TRUE(follower->damage().empty());
  const ProgramResult doctor = runProgram("rocinante-log", {"doctor", log().string()});
  EXPECT_EQ(doctor.exit_code, 0) << doctor.out;
}

TEST_P(FollowARecorder, UntilCtrlCWhichIsNoFailure) {
  Program follower = follow({"--from-start"});
  Result<UdpSender> sender = UdpSender::open(*Endpoint::parse(endpoint_));
  ASSERT_TRUE(sender.ok());
  ASSERT_TRUE(sender->send(bytesOf("RK1 arm - -\n")).ok());
  // It follows as soon as it shows something.
  EXPECT_FALSE(follower.waitForOutput("RK1 arm").empty());
  const ProgramResult result = follower.stop();
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(recorder_.stop().exit_code, 0);
}

INSTANTIATE_TEST_SUITE_P(Compression, FollowARecorder, testing::Values("zstd", "none"));

}  // namespace
}  // namespace rocinante::test
