#include <gtest/gtest.h>
#include <sys/mount.h>

#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "core/log/log_reader.h"
#include "core/net/udp_socket.h"
#include "tests/support/programs.h"
#include "tests/support/udp_queue.h"

// The real program on a real disk that fills up.
namespace rocinante {
namespace {

using PlainJson = nlohmann::json;
using std::chrono::milliseconds;

/// A disk of 2 MiB, if this process may create one.
class SmallDisk {
 public:
  SmallDisk() {
    mounted_ = ::mount("rocinante-test", folder_.path().c_str(), "tmpfs", 0, "size=2m") == 0;
  }
  ~SmallDisk() {
    if (mounted_) ::umount2(folder_.path().c_str(), MNT_DETACH);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

  bool mounted() const { return mounted_; }
  std::filesystem::path log() const { return folder_ / "log.mcap"; }

 private:
  test::TemporaryFolder folder_;
  bool mounted_ = false;
};

/// Records noise until the program ends by itself: datagrams of `payload_bytes`, `burst` per
/// millisecond.
void fillUp(const std::string& compression, std::size_t payload_bytes, int burst) {
  const SmallDisk disk;
  if (!disk.mounted()) GTEST_SKIP() << "no file system can be mounted here";
  auto program =
      test::Program::start("rocinante-record", {"127.0.0.1:0", "-o", disk.log().string(), "--json",
                                                "--compression", compression, "--duration", "60s"});
  std::istringstream line(program.waitForLine("recording "));
  std::string endpoint;
  line >> endpoint >> endpoint;
  const Endpoint bound = Endpoint::parse(endpoint).value();
  UdpSender sender = std::move(UdpSender::open(bound).value());
  std::mt19937_64 random(5);
  std::vector<std::string> payloads(static_cast<std::size_t>(burst));
  std::uint64_t sent = 0;
  // More than the disk holds, message index and all; it ends in between.
  while (sent * (payload_bytes + 16) < 3U << 20U) {
    std::vector<ByteView> views;
    for (std::string& payload : payloads) {
      payload.resize(payload_bytes);
      for (char& c : payload) c = static_cast<char>(random());
      views.push_back(bytesOf(payload));
    }
    if (!sender.send(views)) break;
    sent += views.size();
    std::this_thread::sleep_for(milliseconds(1));
    // Datagrams must not accumulate before a recorder that does not get to run.
    ASSERT_TRUE(test::waitUntilTaken(bound.address.port));
  }
  const test::ProgramResult result = program.finish();
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.err.find("No space left on device"), std::string::npos) << result.err;
  const PlainJson summary = PlainJson::parse(result.out, nullptr, false);
  EXPECT_EQ(summary["complete"], false);
  EXPECT_EQ(summary["reason"], "refused");
  EXPECT_GT(summary["packets"], 0);
  EXPECT_GT(summary["losses"]["disk"], 0);

  auto log = LogReader::open(disk.log());
  ASSERT_TRUE(log.ok()) << log.error().text();
  EXPECT_TRUE(log->summary().complete) << "the file is not whole";
  EXPECT_EQ(log->summary().end_reason, "refused");
  EXPECT_EQ(log->summary().messages, summary["packets"]);
  std::uint64_t disk_losses = 0;
  for (const LossSpan& each : log->losses()) disk_losses += each.counts.disk;
  EXPECT_EQ(disk_losses, summary["losses"]["disk"]) << "what was lost is not told in the file";
  std::uint64_t found = 0;
  for (auto message = log->next(); message && *message; message = log->next()) {
    if ((*message)->channel->captured()) ++found;
  }
  EXPECT_EQ(found, summary["packets"]);
  EXPECT_TRUE(log->damage().empty());
  // The reserved space is not wasted: the stored data fills nearly all of the disk except the last
  // chunk, which fast senders fill at once.
  EXPECT_GT(std::filesystem::file_size(disk.log()), 800'000U);
}

TEST(RecordOntoASmallDisk, EndsInAWholeFileWhenPacketsComeSlowly) { fillUp("zstd", 1'000, 2); }
TEST(RecordOntoASmallDisk, EndsInAWholeFileWhenPacketsComeFast) { fillUp("zstd", 1'000, 60); }
TEST(RecordOntoASmallDisk, EndsInAWholeFileUncompressed) { fillUp("none", 1'000, 10); }
TEST(RecordOntoASmallDisk, EndsInAWholeFileOfTinyPackets) { fillUp("zstd", 8, 100); }

}  // namespace
}  // namespace rocinante
