// Recordings of public bug reports, in ../shared/field, each with a README that says what is right.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/check/log_account.h"
#include "core/foreign/recordings/bag_folder.h"
#include "core/foreign/recordings/recording_kind.h"
#include "core/foreign/ros/bag_import.h"
#include "core/log/import_record.h"
#include "core/mcap/byte_sink.h"
#include "core/session/timeline.h"
#include "tests/support/shared_data.h"

namespace rocinante::test {
namespace {

using testing::HasSubstr;

struct FieldCase {
  const char* folder;
  const char* recording;
  std::uint64_t messages, packets;
  bool is_whole;
  std::vector<const char*> told;   ///< in warnings or account
  std::vector<const char*> items;  ///< in the identity of the state at the end
};

void PrintTo(const FieldCase& field, std::ostream* out) {
  *out << field.folder << "/" << field.recording;
}

class FieldRecording : public testing::TestWithParam<FieldCase> {};

TEST_P(FieldRecording, IsReadAsItsReportAsks) {
  const FieldCase& field = GetParam();
  ROCINANTE_NEEDS_SHARED_FIELD(field.folder);
  const auto folder = sharedField(field.folder);
  Result<Cell> cell = loadCell(folder / "arm.urdf", {});
  ASSERT_TRUE(cell.ok()) << cell.error().text();
  const auto recording = folder / field.recording;
  std::vector<std::unique_ptr<ros::BagReader>> bags;
  for (const auto& file : filesOfRecording(recording)) {
    auto bag = openRecording(file, {});
    ASSERT_TRUE(bag.ok()) << bag.error().text();
    bags.push_back(std::move(*bag));
  }
  ros::ImportOptions options;
  options.cell = &*cell;
  options.damage = damageOfBagFolder(recording);
  Bytes log;
  const auto report = ros::importBags(std::move(bags), makeMemorySink(log), "field", options);
  if (field.messages == 0) {
    ASSERT_FALSE(report.ok());
    EXPECT_THAT(report.error().text(), HasSubstr(field.told.front()));
    return;
  }
  ASSERT_TRUE(report.ok()) << report.error().text();
  EXPECT_EQ(report->messages, field.messages);
  EXPECT_EQ(report->packets, field.packets);
  EXPECT_EQ(report->lostNothing(), field.is_whole);
  auto reader = LogReader::openBytes(log, "made");
  ASSERT_TRUE(reader.ok());
  Timeline session = Timeline::of(std::move(*reader));
  const LogAccount account = logAccount(session, &*cell);
  std::string told = account.sentence();
  for (const std::string& warning : ros::importWarnings(*report)) told += "\n" + warning;
  for (const char* const sentence : field.told) EXPECT_THAT(told, HasSubstr(sentence));
  const auto last = session.stateAt(session.end());
  ASSERT_TRUE(last.ok());
  for (const char* const item : field.items) {
    EXPECT_THAT((*last)->identityText(), HasSubstr(item));
  }
}

const FieldCase kCases[] = {
    {"23-ros1-leading-slash", "plain.bag", 40, 40, true, {}, {"pose arm 1.9"}},
    {"23-ros1-leading-slash", "prefixed.bag", 40, 40, true, {}, {"pose arm 1.9"}},
    {"24-same-stamp-order", "same.mcap", 30, 30, true, {}, {"joint arm shoulder=0.92"}},
    {"25-jointstate-sizes",
     "sizes.mcap",
     8,
     5,
     false,
     {"2 messages kept, but not the sensor_msgs/msg/JointState that the recording says",
      "values that are not finite: 2"},
     {"signal arm shoulder."}},
    {"26-two-publishers-zeros", "two.mcap", 75, 75, true, {}, {}},
    {"27-message-compression", "bag", 10, 10, true, {}, {"joint arm shoulder="}},
    {"27-message-compression", "bagm", 10, 10, true, {}, {"joint arm shoulder="}},
    {"28-split-overlap", "bag", 10, 10, true, {}, {"joint arm shoulder=0.9"}},
    {"46-unknown-types",
     "own.mcap",
     10,
     0,
     true,
     {"no message of the log is a packet: nothing moves; left out: 1 topic `/arm_state` (10 "
      "messages of my_robot_msgs/msg/ArmState, which do not become packets)"},
     {}},
    {"48-measured-and-desired", "two.mcap", 100, 100, true, {}, {}},
    {"56-sim-time-and-subsets", "sim.mcap", 20, 20, true, {}, {}},
    {"56-sim-time-and-subsets",
     "subsets.mcap",
     110,
     110,
     true,
     {},
     {"joint arm shoulder=", "joint arm elbow=", "joint arm grip="}},
    {"66-ros1-active", "active.bag.active", 20, 20, false, {"it was not closed"}, {}},
    {"66-ros1-active",
     "active-cut.bag.active",
     19,
     19,
     false,
     {"the bag ends inside a record"},
     {}},
    {"66-ros1-active", "cut-in-chunk.bag", 15, 15, false, {"ends inside a chunk"}, {}},
    {"66-ros1-active", "empty.bag", 0, 0, false, {"there is no message to import"}, {}},
    {"66-ros1-active", "only-open.bag.active", 10, 10, false, {"it was not closed"}, {}},
    {"66-ros1-active", "unindexed.bag", 20, 20, false, {"it was not closed"}, {}},
    {"66-ros1-active",
     "zero-filled.bag",
     10,
     10,
     false,
     {"it was not closed", "bytes of the bag are zeros"},
     {}},
};

INSTANTIATE_TEST_SUITE_P(Public, FieldRecording, testing::ValuesIn(kCases));

}  // namespace
}  // namespace rocinante::test
