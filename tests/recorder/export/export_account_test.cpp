// What an export leaves out of a log is in its account (docs/decisions/030): whatever is put into a
// session, or taken out of it, changes the output or the account.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <random>

#include "core/foreign/foxglove/foxglove_format.h"
#include "recorder/export/exports.h"
#include "recorder/ros_out/ros2_format.h"
#include "tests/recorder/export/written_session.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

using test::Said;
using testing::HasSubstr;

constexpr std::int64_t kOneSecond = 1'000'000'000;

constexpr const char* kExportedUrdf =
    "<robot name=\"m\"><link name=\"base\"/><link name=\"arm\"><visual><geometry>"
    "<box size=\"1 1 1\"/></geometry></visual></link><joint name=\"j\" type=\"continuous\">"
    "<parent link=\"base\"/><child link=\"arm\"/></joint></robot>";

/// What an export made, and what it told of the rest.
struct MadeExport {
  std::string output, told;
  auto operator<=>(const MadeExport&) const = default;
};

std::string joined(const Account& account, const std::vector<std::string>& gaps,
                   const std::vector<std::string>& notes = {}) {
  std::string text = accountSentence(account, Account::kMaxListed);
  for (const auto* list : {&gaps, &notes}) {
    for (const std::string& each : *list) text += "\n" + each;
  }
  return text;
}

class ExportAccount : public testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(folder_ / "m.urdf") << kExportedUrdf;
    auto cell = loadCell(folder_ / "m.urdf", {});
    ASSERT_TRUE(cell.ok());
    cell_ = std::move(*cell);
  }

  MomentWalk opened() {
    auto session = MomentWalk::open(folder_ / "s.mcap");
    EXPECT_TRUE(session.ok());
    return std::move(*session);
  }

  MadeExport toMessages(SessionFormat& format) {
    MomentWalk session = opened();
    Bytes bytes;
    auto out = ExportedMcap::start(makeMemorySink(bytes), format.profile());
    MessageExportOptions options;
    options.until = LogTime::max();
    auto report = exportMessages(session, &cell_, format, *out, options);
    EXPECT_TRUE(report.ok() && out->finish().ok());
    return {std::string(textOf(bytes)), joined(report->left_out, report->gaps)};
  }

  MadeExport toTable() {
    MomentWalk session = opened();
    SessionTable table(&cell_, {});
    MadeExport made;
    const auto writer = makeCsvTable([&](ByteView bytes) -> Status {
      made.output += textOf(bytes);
      return {};
    });
    TableOptions options;
    options.until = LogTime::max();
    const auto report = writeTable(session, table, *writer, options);
    EXPECT_TRUE(report.ok());
    made.told = joined(report->left_out, table.gaps(), table.remarks());
    return made;
  }

  MadeExport toGltf() {
    MomentWalk session = opened();
    auto recording = GltfRecording::make(folder_.path().string());
    GltfExportOptions options;
    options.until = LogTime::max();
    Account left_out;
    EXPECT_TRUE(recordGltf(session, cell_, *recording, options, left_out).ok());
    Bytes glb;
    const auto sink = makeMemorySink(glb);
    const auto facts = recording->write(*sink);
    EXPECT_TRUE(facts.ok());
    return {std::string(textOf(glb)), joined(left_out, facts->gaps, facts->notes)};
  }

  MadeExport toPcap() {
    auto log = LogReader::open(folder_ / "s.mcap");
    MadeExport made;
    PcapFile file([&](ByteView bytes) -> Status {
      made.output += textOf(bytes);
      return {};
    });
    const auto report = exportPcap(*log, LogTime{}, LogTime::max(), file, {});
    EXPECT_TRUE(report.ok());
    made.told = joined(report->left_out, report->gaps, report->notes);
    return made;
  }

  /// By format.
  std::vector<std::pair<std::string, MadeExport>> exported(const std::vector<Said>& all) {
    test::writeSession(folder_ / "s.mcap", all);
    const auto foxglove = makeFoxgloveFormat(), ros2 = makeRos2Format();
    return {{"foxglove", toMessages(*foxglove)},
            {"ros2", toMessages(*ros2)},
            {"table", toTable()},
            {"gltf", toGltf()},
            {"pcap", toPcap()}};
  }

  test::TemporaryFolder folder_;
  Cell cell_;
};

TEST_F(ExportAccount, NoMutationIsSilent) {
  const std::vector<Said> whole = {
      {0, "RK1 s 0 -\njoint m j=0\npose m 0 0 0 0 0 0 1\n"},
      {kOneSecond, "RK1 s 1 -\njoint m j=1\n"},
      {2 * kOneSecond, "RK1 s 2 -\njoint m j=2\npose m 1 0 0 0 0 0 1\n"},
      {3 * kOneSecond, "RK1 s 3 -\njoint m j=3\n"}};
  const char* const statements[] = {"hide m/arm",
                                    "color m #ff0000",
                                    "line p #ffffff 0 0 0 1 1 1",
                                    "points q #ffffff 0 0 0",
                                    "label l 0 0 0 \"x\"",
                                    "event \"here\"",
                                    "view v 1 1 1 0 0 0 45",
                                    "joint m j=9",
                                    "signals m j.velocity=1",
                                    "signal m/arm force 2 N",
                                    "signal - mode \"auto\"",
                                    "pose m 5 0 0 0 0 0 1",
                                    "no statement that is known"};
  const auto before = exported(whole);
  const auto isTold = [&](const std::vector<Said>& mutated, const std::string& what) {
    const auto after = exported(mutated);
    for (std::size_t i = 0; i < after.size(); ++i) {
      EXPECT_NE(after[i].second, before[i].second) << after[i].first << ": " << what;
    }
  };
  for (const std::string statement : statements) {
    std::vector<Said> mutated = whole;
    if (statement.starts_with("no ")) {
      mutated.push_back({3 * kOneSecond + 1, statement});
    } else {
      mutated[2].text += statement + "\n";
    }
    isTold(mutated, statement);
  }
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::vector<Said> mutated = whole;
    mutated.erase(mutated.begin() + static_cast<std::ptrdiff_t>(i));
    isTold(mutated, "without packet " + std::to_string(i));
  }
}

TEST_F(ExportAccount, AttachmentsAndMarksAreNamed) {
  LogWriterOptions options;
  auto log = LogWriter::create(folder_ / "s.mcap", options, "session-1");
  ASSERT_TRUE(log.ok());
  const LogTime time{std::chrono::seconds(5)};
  ASSERT_TRUE(log->writeAttachment("notes.txt", "text/plain", time, bytesOf("x")).ok());
  ASSERT_TRUE(log->writeAttachment("cell/m.urdf", "text/xml", time, bytesOf("x")).ok());
  ASSERT_TRUE(log->writeAttachment("cell.json", "text/json", time, bytesOf("x")).ok());
  SessionWriter session(std::move(*log), {});
  const auto channel = session.addChannel("/udp/test", "rk1", {});
  const auto mark = session.addChannel("/rocinante/mark", "json", {});
  ASSERT_TRUE(session.write(*channel, 0, time, 0, bytesOf("RK1 s 0 -\njoint m j=0\n")).ok());
  ASSERT_TRUE(session.write(*mark, 0, time, 0, bytesOf(R"({"text":"x"})")).ok());
  ASSERT_TRUE(session.log().close("done").ok());
  EXPECT_EQ(toTable().told,
            "left out: 1 topic `/rocinante/mark` (a table has joints and poses), 1 attachment "
            "`notes.txt` (a table has joints and poses)");
  EXPECT_THAT(toGltf().told, HasSubstr("`notes.txt`"));
  EXPECT_THAT(toPcap().told, HasSubstr("1 message `/rocinante/mark` (was no datagram"));
  const auto foxglove = makeFoxgloveFormat();
  EXPECT_THAT(toMessages(*foxglove).told, HasSubstr("`notes.txt`"));
}

}  // namespace
}  // namespace rocinante
