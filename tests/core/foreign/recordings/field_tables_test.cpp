// Tables, captures and clocks that people who do this job stumbled over (../shared/field): how much
// of each becomes datagrams or packets, and what is named.
#include <gmock/gmock.h>

#include <cstdlib>

#include "core/foreign/recordings/opened_recording.h"
#include "core/log/import_record.h"
#include "core/log/log_reader.h"
#include "core/report/account.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace rocinante::test {
namespace {

struct TableCase {
  const char* file;
  std::uint64_t packets;          ///< packets, or captured datagrams
  const char* word;               ///< in some of them
  std::uint64_t packets_with_it;  ///< how many of them have it
  const char* named;  ///< in a warning or the account; empty: there is nothing; null: any
};

constexpr TableCase kTableCases[] = {
    {"29-stamps-zero-and-reset/zero.mcap", 10, "joint arm", 10, nullptr},
    {"29-stamps-zero-and-reset/reset.mcap", 20, "joint arm", 20, nullptr},
    {"31-mcap-damage/badchunk.mcap", 900, "joint arm", 900, "fails its checksum"},
    {"31-mcap-damage/whole.mcap", 1000, "joint arm", 1000, nullptr},
    {"71-clock-1970/jump.mcap", 20, "joint arm", 20, nullptr},
    {"30-csv-dialects/nan.csv", 3, "elbow=", 2, ""},
    {"30-csv-dialects/nan-first.csv", 3, "elbow=", 2, ""},
    {"30-csv-dialects/pandas.csv", 2, "elbow=", 2, "row numbers"},
    {"30-csv-dialects/plotjuggler.csv", 2, "elbow=", 2, ""},
    {"30-csv-dialects/quoted.csv", 2, "signals arm torque%2C%20request=", 2, ""},
    {"30-csv-dialects/semicolon.csv", 2, "elbow=", 2, ""},
    {"30-csv-dialects/spaces.csv", 2, "elbow=", 2, ""},
    {"30-csv-dialects/null.jsonl", 3, "elbow=", 2, ""},
    {"30-csv-dialects/tum.txt", 2, "pose arm", 2, ""},
    {"32-pcapng-interfaces/links.pcapng", 10, "joints arm", 10, ""},
    {"32-pcapng-interfaces/offset.pcapng", 10, "joints arm", 10, ""},
    {"32-pcapng-interfaces/sections.pcapng", 10, "joints arm", 10, ""},
    {"32-pcapng-interfaces/simple.pcapng", 5, "joints arm", 5, "5 times (simple packet blocks"},
    {"32-pcapng-interfaces/three.pcapng", 30, "joints arm", 30, ""},
    {"33-padding-trailers/pad.pcap", 20, "joints arm", 15, "5 trailers `UDP options`"},
    {"34-cooked-vlan/mix.pcap", 10, "joints arm", 10, ""},
    {"34-cooked-vlan/sll2vlan.pcap", 5, "joints arm", 5, ""},
    {"35-ipv6-fragments/hopbyhop.pcap", 10, "joints arm", 10, ""},
    {"36-pcap-gaps-order-snap/gap.pcap", 10, "joints arm", 10, ""},
    {"36-pcap-gaps-order-snap/ns.pcap", 5, "joints arm", 5, ""},
    {"36-pcap-gaps-order-snap/order.pcap", 10, "joints arm", 10, "5 times (before that"},
    {"36-pcap-gaps-order-snap/snap.pcap", 5, "", 5, "5 datagrams shorter than sent"},
    {"36-pcap-gaps-order-snap/usec.pcap", 2, "joints arm", 2, ""},
    {"67-replay-drift/khz.pcap", 10'000, "joints arm", 10'000, ""},
    {"71-clock-1970/native.pcap", 10, "joints arm", 10, ""},
};

class FieldTables : public testing::TestWithParam<TableCase> {};

TEST_P(FieldTables, AreUsedOrNamed) {
  const TableCase& expected = GetParam();
  const std::string below = std::string("../field/") + expected.file;
  ROCINANTE_NEEDS_SHARED_DATA(below);
  const TemporaryFolder cache;
  ::setenv("XDG_CACHE_HOME", cache.path().c_str(), 1);
  RecordingRequest request;
  request.recording = sharedData(below);
  const auto cell = request.recording.parent_path() / "arm.urdf";
  if (std::filesystem::exists(cell)) request.cell = cell;
  const auto opened = openedRecording(request);
  ::unsetenv("XDG_CACHE_HOME");
  ASSERT_TRUE(opened.ok()) << opened.error().text();
  Result<LogReader> log = LogReader::open(opened->log);
  ASSERT_TRUE(log.ok()) << log.error().text();
  std::uint64_t packets = 0, with_it = 0;
  while (true) {
    const auto next = log->next();
    ASSERT_TRUE(next.ok()) << next.error().text();
    if (!*next) break;
    const LogChannel& channel = *(*next)->channel;
    if (channel.encoding != "rk1" && channel.encoding != "octets") continue;
    ++packets;
    if (textOf((*next)->payload).find(expected.word) != std::string_view::npos) ++with_it;
  }
  EXPECT_EQ(packets, expected.packets);
  EXPECT_EQ(with_it, expected.packets_with_it);
  std::string told = accountSentence(accountOfLines(importLeftOutOf(log->metadata())));
  for (const std::string& warning : opened->warnings) told += "; " + warning;
  if (expected.named == nullptr) return;
  if (std::string_view(expected.named).empty()) {
    EXPECT_EQ(told, "");
  } else {
    EXPECT_THAT(told, testing::HasSubstr(expected.named));
  }
}

INSTANTIATE_TEST_SUITE_P(Field, FieldTables, testing::ValuesIn(kTableCases),
                         [](const testing::TestParamInfo<TableCase>& tested) {
                           std::string name;
                           for (const char each : std::string_view(tested.param.file)) {
                             name +=
                                 std::isalnum(static_cast<unsigned char>(each)) != 0 ? each : '_';
                           }
                           return name;
                         });

}  // namespace
}  // namespace rocinante::test
