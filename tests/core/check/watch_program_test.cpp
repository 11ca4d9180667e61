#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/net/udp_socket.h"
#include "tests/support/programs.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/udp_queue.h"

namespace rocinante {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

constexpr std::string_view kWatchedArm =
    "<robot name=\"arm\"> <link name=\"base\"/> <link name=\"hand\"/> <joint name=\"turn\" "
    "type=\"revolute\"> <parent link=\"base\"/> <child link=\"hand\"/> <limit lower=\"-2\" "
    "upper=\"2\" effort=\"1\" velocity=\"9\"/> </joint> </robot>";

/// `check --watch`, and a source that sends to it.
class Watched {
 public:
  explicit Watched(std::vector<std::string> arguments) {
    std::ofstream(folder / "arm.urdf") << kWatchedArm;
    arguments.insert(arguments.begin(), {"arm.urdf", "--live", "127.0.0.1:0", "--watch"});
    program.emplace(test::Program::start("rocinante-check", arguments, folder.path()));
    const std::string said = program->waitForLine("watching udp://");
    const Result<Endpoint> to = Endpoint::parse(said.substr(said.find("udp://")));
    EXPECT_TRUE(to.ok()) << said;
    port = to->address.port;
    sender_.emplace(UdpSender::open(*to).value());
  }

  void say(double value) { send("joints arm " + std::to_string(value)); }
  void send(const std::string& statement) {
    const std::string packet =
        "RK1 me@a " + std::to_string(++sequence_) + " -\n" + statement + "\n";
    EXPECT_TRUE(sender_->send(bytesOf(packet)).ok());
  }
  /// The line of standard output, once it is there.
  std::string waitFor(std::string_view text) { return program->waitForOutput(text); }

  const test::TemporaryFolder folder;
  std::optional<test::Program> program;
  std::uint16_t port = 0;

 private:
  std::optional<UdpSender> sender_;
  std::uint64_t sequence_ = 0;
};

TEST(CheckWatch, TellsBeginningAndEndAndExitsWithOne) {
  Watched watched({"--hold", "300ms"});
  watched.say(1);
  watched.say(3);
  watched.waitFor(" begins: error: arm/turn is outside its limits");
  watched.waitFor(" ends: error: arm/turn is outside its limits");
  const test::ProgramResult result = watched.program->stop();
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.out,
              HasSubstr("2 packets; lasting: nothing; 1 finding began\nincompatible\n"));
}

TEST(CheckWatch, SaysYesWhenNothingWasFoundAndNothingJudgedWithoutAPacket) {
  Watched fits({"--hold", "60s"});
  fits.say(1);
  Watched empty({"--json", "--duration", "200ms"});
  const test::ProgramResult nothing = empty.program->finish();
  EXPECT_EQ(nothing.exit_code, 2);
  const auto summary = nlohmann::json::parse(nothing.out);
  EXPECT_EQ(summary["event"], "summary");
  EXPECT_EQ(summary["verdict"], "nothing_judged");
  ASSERT_TRUE(test::waitUntilTaken(fits.port));
  fits.program->signal(SIGTERM);
  const test::ProgramResult yes = fits.program->finish();
  EXPECT_EQ(yes.exit_code, 0) << yes.out << yes.err;
  EXPECT_THAT(yes.out, AllOf(HasSubstr("\ncompatible\n"), Not(HasSubstr("begins"))));
}

TEST(CheckWatch, UntilFindingEndsItByItself) {
  Watched watched({"--until-finding", "--json"});
  watched.say(1);
  watched.say(3);
  const test::ProgramResult result = watched.program->finish();
  EXPECT_EQ(result.exit_code, 1) << result.out << result.err;
  const auto first = nlohmann::json::parse(result.out.substr(0, result.out.find('\n')));
  EXPECT_EQ(first["event"], "begins");
  EXPECT_EQ(first["rule"], "joint.limit");
  EXPECT_EQ(first["packet"], 2);
}

TEST(CheckWatch, RunsACommandWithTheFindingOnItsInput) {
  const test::TemporaryFolder tools;
  const std::filesystem::path script = tools / "note-it";
  std::ofstream(script) << "#!/bin/sh\nread -r line\necho \"told $* $line\"\nexit 3\n";
  std::filesystem::permissions(script, std::filesystem::perms::owner_all);
  Watched watched({"--hold", "200ms", "--on-finding", script.string() + " --to 'me;you'"});
  watched.say(3);
  const std::string begins = watched.program->waitForLine("\"event\":\"begins\"");
  EXPECT_THAT(begins, StartsWith("told --to 'me;you' {")) << "no shell reads the words";
  const auto json = nlohmann::json::parse(begins.substr(begins.find('{')));
  EXPECT_EQ(json["rule"], "joint.limit");
  watched.program->waitForLine("\"event\":\"ends\"");
  const test::ProgramResult result = watched.program->stop();
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("note-it --to 'me;you' failed (exit 3)"));
}

TEST(CheckWatch, ManyCommandsThatHangStopNothing) {
  const test::TemporaryFolder tools;
  const std::filesystem::path script = tools / "hang";
  std::ofstream(script) << "#!/bin/sh\nexec sleep 60\n";
  std::filesystem::permissions(script, std::filesystem::perms::owner_all);
  Watched watched({"--on-finding", script.string()});
  // More findings at a time than commands may run and wait.
  for (int i = 0; i < 100; ++i) watched.send("joints stranger" + std::to_string(i) + " 1");
  watched.waitFor("stranger99");
  const test::ProgramResult result = watched.program->stop();
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("not run, too many at a time"));
}

TEST(CheckWatch, TellsAServiceManagerThatItIsReadyAndAlive) {
  const std::string name = "@rocinante-check-watch-" + std::to_string(::getpid());
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::memcpy(address.sun_path + 1, name.data() + 1, name.size() - 1);
  const int manager = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + name.size());
  ASSERT_EQ(::bind(manager, reinterpret_cast<const sockaddr*>(&address), size), 0);
  const timeval patience{60, 0};
  ::setsockopt(manager, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  ::setenv("NOTIFY_SOCKET", name.c_str(), 1);
  ::setenv("WATCHDOG_USEC", "200000", 1);
  Watched watched({});
  ::unsetenv("NOTIFY_SOCKET");
  ::unsetenv("WATCHDOG_USEC");
  std::string said;
  int alive = 0;
  while (alive < 3) {
    std::array<char, 512> bytes{};
    const ssize_t got = ::recv(manager, bytes.data(), bytes.size(), 0);
    ASSERT_GT(got, 0) << said;
    const std::string line(bytes.data(), static_cast<std::size_t>(got));
    if (line == "WATCHDOG=1") ++alive;
    said += line + "\n";
  }
  EXPECT_THAT(said, StartsWith("READY=1\n"));
  EXPECT_THAT(said, HasSubstr("STATUS="));
  watched.program->stop();
  ::close(manager);
}

}  // namespace
}  // namespace rocinante
