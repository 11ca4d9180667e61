#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/net/udp_socket.h"
#include "tests/support/programs.h"

namespace rocinante {
namespace {

using ::testing::HasSubstr;

constexpr std::string_view kArm =
    "<robot name=\"arm\"> <link name=\"base\"/> <link name=\"hand\"/> <joint name=\"turn\" "
    "type=\"continuous\"> <parent link=\"base\"/> <child link=\"hand\"/> </joint> </robot>";

test::ProgramResult judgeLive(std::string_view packet) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "arm.urdf") << kArm;
  test::Program check = test::Program::start(
      "rocinante-check", {"arm.urdf", "--live", "127.0.0.1:0", "--duration", "60s"}, folder.path());
  const std::string said = check.waitForLine("listening on ");
  const Result<Endpoint> to = Endpoint::parse(said.substr(said.find("udp://")));
  EXPECT_TRUE(to.ok()) << said;
  Result<UdpSender> sender = UdpSender::open(*to);
  EXPECT_TRUE(sender.ok());
  EXPECT_TRUE(sender->send(bytesOf(packet)).ok());
  // Stopping judges what came until then; until it has come, there is nothing to stop for.
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  return check.stop();
}

TEST(CheckProgram, JudgesWhatArrivesUntilItIsStopped) {
  const test::ProgramResult fits = judgeLive("RK1 me - -\njoints arm 1\n");
  EXPECT_EQ(fits.exit_code, 0) << fits.out << fits.err;
  EXPECT_THAT(fits.out, HasSubstr("1 packet of 1 source"));
  EXPECT_TRUE(fits.out.ends_with("\ncompatible\n")) << fits.out;

  const test::ProgramResult differs = judgeLive("RK1 me - -\njoints arm 1 2\n");
  EXPECT_EQ(differs.exit_code, 1);
  EXPECT_THAT(differs.out, HasSubstr("[packet.joint-count]"));

  const test::ProgramResult unknown = judgeLive("hello");
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_TRUE(unknown.out.ends_with("nothing judged: no packet could be decoded\n")) << unknown.out;
}

}  // namespace
}  // namespace rocinante
