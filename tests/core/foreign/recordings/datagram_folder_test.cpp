#include "core/foreign/recordings/datagram_folder.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <fstream>

#include "core/foreign/recordings/bag_folder.h"
#include "core/foreign/recordings/datagram_times.h"
#include "core/foreign/ros/bag_import.h"
#include "tests/core/log/log_support.h"
#include "tests/support/temporary_folder.h"

namespace rocinante::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Rule = DatagramOrder::Rule;

/// "NAME@TIME_NS" of the files, which were changed at 1, 2, 3 ... ns.
std::vector<std::string> orderedNames(const std::vector<std::string>& names, Rule rule) {
  std::vector<DatagramFile> files;
  for (const std::string& name : names) {
    files.push_back({name, static_cast<std::int64_t>(files.size() + 1), 0});
  }
  const DatagramOrder order = orderedDatagrams(std::move(files));
  EXPECT_EQ(order.rule, rule);
  std::vector<std::string> ordered;
  for (const TimedDatagram& each : order.datagrams) {
    ordered.push_back(each.name + "@" + std::to_string(each.time.time_since_epoch().count()));
  }
  return ordered;
}

TEST(DatagramTimes, AreTheNamesWhenAllOfThemAreTimes) {
  EXPECT_THAT(
      orderedNames({"1700000000.25.bin", "1700000000250000001", "1700000000249.raw",
                    "1700000000249999.x", "1700000000", "999999999.000000001"},
                   Rule::names_are_times),
      ElementsAre("999999999.000000001@999999999000000001", "1700000000@1700000000000000000",
                  "1700000000249.raw@1700000000249000000", "1700000000249999.x@1700000000249999000",
                  "1700000000.25.bin@1700000000250000000",
                  "1700000000250000001@1700000000250000001"));
}

TEST(DatagramTimes, AreThoseOfTheFilesInTheOrderOfNumbers) {
  EXPECT_THAT(orderedNames({"p2.raw", "p10.raw", "p09.raw", "q1.raw"}, Rule::names_are_numbers),
              ElementsAre("q1.raw@4", "p2.raw@4", "p09.raw@4", "p10.raw@4"));
  // Too long for a time, and for any whole number.
  EXPECT_THAT(orderedNames({"99999999999999999999999", "100000000000000000000000"},
                           Rule::names_are_numbers),
              ElementsAre("99999999999999999999999@1", "100000000000000000000000@2"));
}

TEST(DatagramTimes, AreThoseOfTheFilesWhenNamesSayNothing) {
  EXPECT_THAT(orderedNames({"b.raw", "a.raw", "1.raw"}, Rule::changed),
              ElementsAre("b.raw@1", "a.raw@2", "1.raw@3"));
  EXPECT_THAT(orderedNames({"9223372036854775807.1", "-1", ".5"}, Rule::names_are_numbers),
              testing::SizeIs(3));
}

class DatagramFolderTest : public testing::Test {
 protected:
  void put(const std::string& name, std::string_view bytes, std::int64_t changed_ns = 0) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    const timespec time{changed_ns / 1'000'000'000, changed_ns % 1'000'000'000};
    const timespec both[2] = {time, time};
    ASSERT_EQ(::utimensat(AT_FDCWD, (folder_ / name).c_str(), both, 0), 0);
  }

  Result<ros::ImportReport> import() {
    auto opened = openDatagramFolder(folder_.path());
    if (!opened) return opened.error();
    std::vector<std::unique_ptr<ros::BagReader>> all;
    all.push_back(std::move(*opened));
    log_.clear();
    return ros::importBags(std::move(all), makeMemorySink(log_), "session", {});
  }

  const TemporaryFolder folder_;
  Bytes log_;
};

TEST_F(DatagramFolderTest, KeepsEachFileAsACapturedDatagram) {
  constexpr std::int64_t kDay = 1'700'000'000'000'000'000;
  const std::string octets("\0\xFFraw", 5);
  put("d.1", octets, kDay + 5);
  put("d.2", "RK1 a@b 1 -\njoints arm 1\n", kDay + 3);
  put("d.3", "", kDay + 7);
  put(".hidden4", "x");
  std::filesystem::create_directory(folder_ / "5");
  ASSERT_EQ(::mkfifo((folder_ / "6").c_str(), 0600), 0);
  const auto report = import();
  ASSERT_TRUE(report) << report.error().text();
  EXPECT_TRUE(report->lostNothing());
  EXPECT_THAT(report->notes,
              ElementsAre(HasSubstr("the numbers in their files' names"),
                          HasSubstr("1 file changed before the one in front"),
                          HasSubstr("3 folder or hidden or special files passed over")));
  LogReader reader = openLog(log_);
  for (const LogChannel& channel : reader.channels()) {
    EXPECT_FALSE(channel.imported()) << channel.topic;
  }
  std::vector<std::string> kept;
  for (const KeptMessage& message : readAll(reader)) {
    if (message.topic == "/datagrams") kept.push_back(message.payload);
  }
  EXPECT_THAT(kept, ElementsAre(octets, "RK1 a@b 1 -\njoints arm 1\n", ""));
  EXPECT_EQ(nanosecondsOf(report->start), kDay + 5);
  EXPECT_EQ(nanosecondsOf(report->end), kDay + 7);
}

TEST_F(DatagramFolderTest, SaysWhatItLeavesOut) {
  EXPECT_THAT(import().error().text(), HasSubstr("the folder has no files"));
  put("1", std::string((1U << 20U) + 1, 'x'));
  put("2", "x", 1);
  const auto report = import();
  ASSERT_TRUE(report) << report.error().text();
  EXPECT_FALSE(report->lostNothing());
  EXPECT_THAT(report->damage, ElementsAre(HasSubstr("1 file of more than 1 MiB left out")));
  // Before 1970 a log has no times.
  put("2", "x", -5'000'000'000);
  EXPECT_THAT(import().error().text(), HasSubstr("no message"));
}

TEST_F(DatagramFolderTest, AnIdDependsOnItsFilesAlone) {
  put("a", "1", 5);
  const auto first = datagramFolderId(folder_.path());
  ASSERT_TRUE(first);
  EXPECT_EQ(*datagramFolderId(folder_.path()), *first);
  put("b", "1", 5);
  EXPECT_NE(*datagramFolderId(folder_.path()), *first);
}

TEST_F(DatagramFolderTest, FindsTheFilesOfABag) {
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

TEST_F(DatagramFolderTest, ReadsHowManyMessagesABagHas) {
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

TEST_F(DatagramFolderTest, NamesTheFilesThatABagLacks) {
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
