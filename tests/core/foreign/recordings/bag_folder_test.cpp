#include "core/foreign/recordings/bag_folder.h"

#include <gmock/gmock.h>

#include <fstream>

#include "core/foreign/recordings/recording_kind.h"
#include "tests/support/temporary_folder.h"

namespace rocinante::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class BagFolderTest : public testing::Test {
 protected:
  void put(const std::string& name, std::string_view bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
  }

  const TemporaryFolder folder_;
};

TEST_F(BagFolderTest, OtherFoldersAreRefusedWithWhatIsTaken) {
  put("1.raw", "RK1 a@b 1 -\n");
  EXPECT_EQ(recordingKindOf(folder_.path()), RecordingKind::none);
  EXPECT_THAT(openRecording(folder_.path(), "").error().text(),
              HasSubstr("a folder is read only if it is a ROS 2 bag, with metadata.yaml"));
  put("metadata.yaml", "");
  put("bag_0.db3.zstd", "");
  EXPECT_THAT(refusalOf(folder_.path()), testing::Optional(HasSubstr("zstd -d FILE")));
  put("bag_0.db3", "");
  EXPECT_EQ(recordingKindOf(folder_.path()), RecordingKind::bag);
}

TEST_F(BagFolderTest, FindsTheFilesOfABag) {
  put("bag_1.db3", "");
  put("bag_0.db3", "");
  EXPECT_THAT(filesOfBagFolder(folder_.path()), IsEmpty());
  put("metadata.yaml", "");
  EXPECT_THAT(filesOfBagFolder(folder_.path()),
              ElementsAre(folder_ / "bag_0.db3", folder_ / "bag_1.db3"));
  // Those that it lists; a copy is not read, and is named.
  put("metadata.yaml", "relative_file_paths: [bag_1.db3, bag_2.mcap.zstd]\n");
  put("bag_2.mcap", "");
  EXPECT_THAT(filesOfBagFolder(folder_.path()),
              ElementsAre(folder_ / "bag_1.db3", folder_ / "bag_2.mcap"));
  EXPECT_THAT(damageOfBagFolder(folder_.path()),
              ElementsAre(HasSubstr("does not list the file bag_0.db3: it is not read")));
}

TEST_F(BagFolderTest, ReadsHowManyMessagesABagHas) {
  put("a.db3", "");
  put("b.db3", "");
  const auto stated = [&](const std::string& metadata) {
    put("metadata.yaml", metadata);
    std::vector<std::string> told;
    for (const ros::StatedMessages& each : statedOfBagFolder(folder_.path(), 3)) {
      told.push_back(std::to_string(each.first) + "+" + std::to_string(each.inputs) + " " +
                     each.name + " " + std::to_string(each.count.value_or(99)) + each.compression);
    }
    return told;
  };
  const std::string head = "rosbag2_bagfile_information:\n  message_count: 7\n";
  EXPECT_THAT(stated(head), ElementsAre("3+2 the bag 7"));
  EXPECT_THAT(stated("compression_format: lz4\ncompression_mode: MESSAGE\n"),
              ElementsAre("3+2 the bag 99lz4"));
  EXPECT_THAT(stated("compression_format: zstd\ncompression_mode: MESSAGE\n"), IsEmpty());
  EXPECT_THAT(stated("compression_format: lz4\ncompression_mode: FILE\n"), IsEmpty());
  // Only the bag's own count and those of its files count.
  EXPECT_THAT(
      stated(head + "  topics_with_message_count:\n  - message_count: 5\n    topic_metadata:\n"
                    "      message_count: 6\n  files:\n  - path: b.db3\n    duration:\n"
                    "      nanoseconds: 2\n    message_count: 4\n  - message_count: 3\n"
                    "    path: a.db3\n  - path: gone.db3\n    message_count: 9\n"),
      ElementsAre("4+1 b.db3 4", "3+1 a.db3 3", "3+2 the bag 7"));
  EXPECT_THAT(stated("message_count: -1\nfiles:\n- message_count: 1\n- path:\n"), IsEmpty());
  put("metadata.yaml", "");
  EXPECT_THAT(statedOfBagFolder(folder_.path(), 0), IsEmpty());
}

TEST_F(BagFolderTest, NamesTheFilesThatABagLacks) {
  put("bag_0.mcap", "");
  const auto lacks = [&](const std::string& metadata) {
    put("metadata.yaml", metadata);
    std::vector<std::string> sentences = damageOfBagFolder(folder_.path());
    for (std::string& each : sentences) each = each.substr(0, each.find(" ("));
    return sentences;
  };
  const std::string head = "rosbag2_bagfile_information:\n  version: 5\n";
  EXPECT_THAT(lacks(head + "  relative_file_paths:\n    - bag_0.mcap\n"), IsEmpty());
  EXPECT_THAT(lacks(head + "  relative_file_paths:\n    - 'bag/bag_0.mcap'\n    - \"bag_1.mcap\"\n"
                           "  files:\n    - path: bag_2.mcap\n"),
              ElementsAre("the bag's file bag_1.mcap is missing: its messages are not there"));
  EXPECT_THAT(lacks(head + "  relative_file_paths: [bag_0.mcap, bag_7.mcap]\n"),
              ElementsAre("the bag's file bag_7.mcap is missing: its messages are not there"));
  // Unpacked beside the name that is listed; and one that is not unpacked.
  put("bag_1.mcap.zstd", "");
  EXPECT_THAT(lacks(head + "  relative_file_paths:\n  - bag_0.mcap.zstd\n  - bag_1.mcap.zstd\n"),
              ElementsAre("the bag's file bag_1.mcap.zstd is compressed; `zstd -d` unpacks it"));
  std::string many = head + "  relative_file_paths:\n    - bag_0.mcap\n";
  for (int i = 0; i < 100'000; ++i) many += "    - gone_" + std::to_string(i) + ".mcap\n";
  EXPECT_EQ(lacks(many).size(), 21U);
  for (const char* const odd : {"relative_file_paths:\n- \n-\n- ..\n", "[", ":\n:::\n", "- - -"}) {
    EXPECT_THAT(lacks(odd), testing::SizeIs(testing::Le(2)));
  }
}

}  // namespace
}  // namespace rocinante::test
