#include "core/check/log_account.h"

#include <gmock/gmock.h>

#include <fstream>

#include "core/bundle/cell_or_log.h"
#include "core/log/import_record.h"
#include "core/log/log_writer.h"
#include "core/recording/session_writer.h"
#include "tests/support/temporary_folder.h"

namespace rocinante::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr const char* kAccountArm = R"(<robot name="arm"><link name="base"/><link name="tool"/>
  <joint name="j" type="continuous"><parent link="base"/><child link="tool"/></joint></robot>)";
constexpr const char* kTable = R"(<robot name="table"><link name="top"/></robot>)";
constexpr const char* kAccountCell = R"(format = 1
[[device]]
name = "left"
model = "arm.urdf"
[[device]]
name = "right"
model = "arm.urdf"
[[device]]
name = "spare"
model = "arm.urdf"
optional = true
[[device]]
name = "table"
model = "table.urdf"
)";

class LogAccountTest : public testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(folder_ / "arm.urdf") << kAccountArm;
    std::ofstream(folder_ / "table.urdf") << kTable;
    std::ofstream(folder_ / "c.cell.toml") << kAccountCell;
    Result<Cell> cell = loadCell(folder_ / "c.cell.toml", {});
    ASSERT_TRUE(cell.ok());
    cell_ = std::move(*cell);
  }

  LogAccount of(const std::vector<std::pair<std::string, std::string>>& said,
                const std::string& left_out = {}, const std::string& ended = "done") {
    LogWriterOptions options;
    options.overwrite = true;
    auto log = LogWriter::create(folder_ / "s.mcap", options, "session-1");
    EXPECT_TRUE(log.ok());
    SessionWriter session(std::move(*log), {});
    std::int64_t time = 1'000'000'000;
    for (const auto& [encoding, text] : said) {
      const auto channel = session.addChannel("/udp/" + encoding, encoding, {});
      EXPECT_TRUE(channel.ok());
      EXPECT_TRUE(session.write(*channel, 0, LogTime(Nanoseconds(time)), time, bytesOf(text)).ok());
      ++time;
    }
    if (!left_out.empty()) {
      EXPECT_TRUE(session.log()
                      .writeMetadata({std::string(kImportRecord),
                                      {{std::string(kImportLeftOutKey), left_out}}})
                      .ok());
    }
    EXPECT_TRUE(session.log().close(ended).ok());
    const auto account = logAccount(folder_ / "s.mcap", &cell_);
    EXPECT_TRUE(account.ok());
    return account ? *account : LogAccount();
  }

  TemporaryFolder folder_;
  Cell cell_;
};

TEST_F(LogAccountTest, NamesWhatNoPacketMoves) {
  const LogAccount one = of({{"rk1", "RK1 s 0 -\njoint left j=1\n"}});
  EXPECT_THAT(one.at_rest, ElementsAre("right"));
  EXPECT_EQ(one.sentence(), "no packet of the log moves right (1 of 2 devices with joints)");
  EXPECT_EQ(one.note(), "");
  // A pose moves it, a name that the model lacks does not, and what `add` brought is there.
  EXPECT_THAT(
      of({{"rk1", "RK1 s 0 -\npose left 0 0 1 0 0 0 1\njoint right k=1\nadd spare arm.urdf\n"}})
          .at_rest,
      ElementsAre("right", "spare"));
  const LogAccount all = of({{"rk1", "RK1 s 0 -\njoint left j=1\njoint right j=0\n"}});
  EXPECT_TRUE(all.empty());
  EXPECT_EQ(all.sentence(), "");
}

TEST_F(LogAccountTest, NamesWhatTheCellLacks) {
  const std::string moves = "RK1 s 0 -\njoint left j=1\njoint right j=1\n";
  const LogAccount two =
      of({{"rk1", moves + "pose ur10 0 0 1 0 0 0 1\njoints x 1\ncolor y #ffffff\n"}});
  EXPECT_THAT(two.not_in_cell, ElementsAre("ur10", "x"));
  EXPECT_EQ(two.note(), "the cell has no device ur10 and x, which the log moves");
  // What `add` brings has a rule of its own, and what nobody moves any more is gone.
  EXPECT_TRUE(of({{"rk1", moves + "add part arm.urdf\njoints part 1\njoints x 1\nremove x\n"}})
                  .not_in_cell.empty());
  EXPECT_EQ(of({{"rk1", "RK1 s 0 -\njoints x 1\n"}}).note(),
            "the cell has no device x, which the log moves; no packet of the log moves left and "
            "right");
}

TEST_F(LogAccountTest, OfALogWithoutPacketsNamesItsTopics) {
  const LogAccount account = of({{"octets", "what is this"}});
  EXPECT_TRUE(account.no_packets);
  EXPECT_NE(account.note(), "");
  EXPECT_EQ(account.sentence(),
            "no message of the log is a packet: nothing moves; left out: 1 topic `/udp/octets` "
            "(octets, and no decoder made packets of them)");
}

TEST_F(LogAccountTest, ReadsWhatAnImportLeftOut) {
  const LogAccount account = of({{"rk1", "RK1 s 0 -\njoint left j=1\njoint right j=1\n"}},
                                "note\t3\ttopic\t/camera\tpictures\t\nnot a line\n"
                                "warning\t-1\ttopic\t/x\ty\tz\nwarning\t1\ttopic\t/y\t\t\n");
  EXPECT_EQ(account.sentence(), "left out: 3 topics `/camera` (pictures), 1 topic `/y`");
  EXPECT_EQ(account.left_out.leftOut()[1].severity, Severity::warning);
}

TEST_F(LogAccountTest, OfAnImportIsTold) {
  const std::string moves = "RK1 s 0 -\njoint left j=1\njoint right j=1\n";
  // A capture becomes channels like those of a recorder: its end says that it was imported.
  const std::vector<std::pair<std::string, std::string>> said = {{"rk1", moves}, {"octets", "?"}};
  EXPECT_EQ(of(said).note(), "") << "a recorder keeps it on purpose";
  EXPECT_EQ(of(said, {}, std::string(kImportedEnd)).note(),
            "left out: 1 topic `/udp/octets` (octets, and no decoder made packets of them)");
  Account account;
  account.leaveOut({.kind = "trailer", .reason = "not recorded", .count = 5});
  account.leaveOut({.kind = "frame", .name = "ARP", .reason = "no datagram"});
  // Also after another program copied the log.
  EXPECT_EQ(of({{"rk1", moves}}, accountLines(account)).note(),
            "left out: 5 trailers (not recorded), 1 frame `ARP` (no datagram)");
  account.leaveOut({.kind = "value", .name = "effort", .reason = "r", .count = 3});
  EXPECT_EQ(of({{"rk1", moves}}, accountLines(account)).note(),
            "left out: 5 trailers (not recorded), 1 frame `ARP` (no datagram), and 3 things more; "
            "rocinante check lists all");
  EXPECT_EQ(of({{"rk1", moves}}, {}, std::string(kImportedEnd)).note(), "");
}

TEST_F(LogAccountTest, LinesOfHostileFilesAreBounded) {
  std::string lines;
  for (int i = 0; i < 2000; ++i) {
    lines += "note\t1\ttopic\t/" + std::to_string(i) + "\t\x1b[31m\t\n";
  }
  const Account account = accountOfLines(lines);
  EXPECT_EQ(account.leftOut().size(), Account::kMaxListed);
  EXPECT_EQ(account.total(), 2000U);
  EXPECT_EQ(account.leftOut()[0].reason, "\\x1b[31m");
  EXPECT_EQ(accountOfLines(accountLines(account)).total(), 2000U);
  EXPECT_THAT(accountOfLines("\t\t\t\t\t\n\n1\t2\n").leftOut(), IsEmpty());
}

}  // namespace
}  // namespace rocinante::test
