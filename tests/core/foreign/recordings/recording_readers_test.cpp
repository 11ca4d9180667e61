#include <gmock/gmock.h>

#include <functional>

#include "core/foreign/recordings/json_lines.h"
#include "core/foreign/recordings/lcm_log.h"
#include "core/foreign/recordings/recording_bytes.h"
#include "core/foreign/recordings/recording_kind.h"
#include "core/foreign/recordings/table_recording.h"
#include "core/foreign/recordings/text_refusal.h"
#include "core/foreign/ros/bag_import.h"
#include "core/foreign/table/csv_line.h"
#include "core/foreign/table/table_header.h"
#include "tests/core/log/log_support.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"

namespace rocinante::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

using Opened = Result<std::unique_ptr<ros::BagReader>>;

struct ImportedText {
  ros::ImportReport report;
  Bytes log;
  std::vector<std::string> packets;
};

Result<ImportedText> importedFrom(Opened recording, const std::string& device = {}) {
  if (!recording) return recording.error();
  ImportedText made;
  ros::ImportOptions options;
  options.device = device;
  std::vector<std::unique_ptr<ros::BagReader>> all;
  all.push_back(std::move(*recording));
  auto report = ros::importBags(std::move(all), makeMemorySink(made.log), "session", options);
  if (!report) return report.error();
  made.report = std::move(*report);
  LogReader reader = openLog(made.log);
  for (const KeptMessage& message : readAll(reader)) {
    if (message.topic.starts_with("/rocinante/decoded/")) made.packets.push_back(message.payload);
  }
  return made;
}

Opened table(std::string_view text, const std::string& device = {}) {
  return openTableBytes(bytesOf(text), "t.csv", device);
}
Opened lines(std::string_view text, const std::string& device = {}) {
  return openJsonBytes(bytesOf(text), "l.jsonl", device);
}

TEST(TableRecording, MakesAPacketOfEachRowOfManyDevices) {
  const auto made = importedFrom(
      table("t,arm.j1,arm.j2,tray:x,tray:y,tray:z,tray:qx,tray:qy,tray:qz,tray:qw,remark\r\n"
            "0.5,0.25,-0,1,2,3,0,0,0,1,begins\r\n"
            "\r\n"
            "1.000000001,,1e-3,,,,,,,,\"it, says\"\r\n"));
  ASSERT_TRUE(made.ok()) << made.error().text();
  EXPECT_TRUE(made->report.lostNothing());
  EXPECT_THAT(made->packets, ElementsAre("RK1 decoded:csv:table - 0.5\njoint arm j1=0.25 j2=0\n"
                                         "pose tray 1 2 3 0 0 0 1\nsignal - remark \"begins\"\n",
                                         "RK1 decoded:csv:table - 1.000000001\njoint arm j2=0.001\n"
                                         "signal - remark \"it, says\"\n"));
  LogReader reader = openLog(made->log);
  // Times stay those of the table.
  EXPECT_EQ(reader.summary().origin, LogTime{});
  const KeptMessage first = readAll(reader).front();
  EXPECT_EQ(first.topic, "/table");
  EXPECT_EQ(first.log_time_ns, 500'000'000);
  EXPECT_EQ(first.payload, "0.5,0.25,-0,1,2,3,0,0,0,1,begins");
}

TEST(TableRecording, ReadsTheLongForm) {
  const auto made = importedFrom(table("time_ns,device,joint,value\n"
                                       "1700000000123456789,arm,j1,0.5\n"
                                       "1700000000123456790,,j2,7\n"),
                                 "robot");
  ASSERT_TRUE(made.ok()) << made.error().text();
  EXPECT_THAT(made->packets,
              ElementsAre("RK1 decoded:csv:table - 1700000000.123456789\njoint arm j1=0.5\n",
                          "RK1 decoded:csv:table - 1700000000.12345679\njoint robot j2=7\n"));
}

TEST(TableRecording, KeepsAndCountsRowsThatDoNotFit) {
  const auto made = importedFrom(table("t,arm.a,arm.b\n1,2,3\n2,2\nsoon,1,2\n3,0x1,2\n4,5,6\n"));
  ASSERT_TRUE(made.ok());
  EXPECT_EQ(made->report.messages, 4U);
  EXPECT_EQ(made->report.malformed, 2U);
  EXPECT_THAT(made->report.damage,
              ElementsAre("1 row without a time left out, the first here (t.csv, line 4)"));
  EXPECT_THAT(made->packets, SizeIs(2));
  EXPECT_THAT(
      ros::importWarnings(made->report),
      Contains("/table: 2 messages kept, but not the wide table that the recording says; the "
               "first is line 3: it has 2 columns, the header 3"));
}

/// Why the only malformed row or line is.
std::string faultOf(Opened recording) {
  const auto made = importedFrom(std::move(recording));
  if (!made) return made.error().text();
  EXPECT_EQ(made->report.malformed, 1U);
  return made->report.topics.front().fault;
}

TEST(TableRecording, SaysWhereAndWhyARowDoesNotFit) {
  EXPECT_EQ(faultOf(table("t,arm.a,arm.b\n1,2,3\n2,2,x1\n3,4,5\n")),
            "line 3: column `arm.b` has `x1`, which is no number");
  EXPECT_EQ(faultOf(table("t,arm.a\n\n1,2,3\n")), "line 3: it has 3 columns, the header 2");
  EXPECT_EQ(faultOf(table("t,arm.a\n1,2\n2,\"3\n")),
            "line 3: a quote is left open, or text follows one");
  EXPECT_EQ(faultOf(table("t,device,joint,value\n1,arm,a,2\n2,arm,a,b\n")),
            "line 3: column `value` has `b`, which is no number");
  EXPECT_EQ(faultOf(table("t,c:x,c:y,c:z,c:qx,c:qy,c:qz,c:qw\n1,0,0,0,0,0,0,1\n2,0,0,0,0,0,0,\n")),
            "line 3: it has a part of a pose alone");
}

TEST(JsonLines, SayWhereAndWhyALineDoesNotFit) {
  const auto fault = [](const std::string& line) {
    return faultOf(lines("{\"t\": 1, \"a\": 2}\n" + line + "\n"));
  };
  EXPECT_EQ(fault("{\"t\": 2, \"arm\": {\"sh"), "line 2: no JSON from column 21 on");
  EXPECT_EQ(fault("{\"t\": 2, \"a\": [[1]]}"), "line 2: an array has an array");
  EXPECT_EQ(fault("{\"t\": 2, \"a\": [{}]}"), "line 2: an array has an object");
  EXPECT_EQ(fault("{\"t\": 2, \"a\": 1e17}"), "line 2: a number is beyond 2^53");
  EXPECT_EQ(fault("{\"t\": 2, \"name\": [\"a\"], \"position\": []}"),
            "line 2: `name` and `position` have different lengths");
}

TEST(TableRecording, NamesTheColumnsThatSayTheSame) {
  const auto made =
      importedFrom(table("t,arm.a,arm.b,arm.a,c:x,c:y,c:z,c:qx,c:qy,c:qz,c:qw,c:y\n"
                         "1,2,3,4,0,5,0,0,0,0,1,6\n"));
  ASSERT_TRUE(made.ok());
  EXPECT_EQ(made->packets[0],
            "RK1 decoded:csv:table - 1\njoint arm a=2 b=3\npose c 0 5 0 0 0 0 1\n");
  EXPECT_EQ(accountSentence(made->report.account),
            "left out: 1 column `arm.a` (stated twice: the first of them counts), 1 column `c:y` "
            "(stated twice: the first of them counts)");
  EXPECT_TRUE(importedFrom(table("t,arm.a,leg.a\n1,2,3\n"))->report.account.empty());
}

std::string accountOfText(Opened text) {
  const auto made = importedFrom(std::move(text));
  return made ? accountSentence(made->report.account) : made.error().text();
}

TEST(TableRecording, CountsRowsThatALaterOneOfTheirTimeOverwrites) {
  // Three objects in one column: the last of each time is left.
  EXPECT_EQ(accountOfText(table("t,arm.a,object\n0,1,0\n0,2,1\n0,3,2\n1,4,0\n1,5,1\n1,6,2\n")),
            "left out: 4 rows (overwritten by a later row of its time; the first at line 2)");
  // A row of which a part was overwritten counts once; out of order, too.
  EXPECT_EQ(accountOfText(table("t,arm.a,arm.b\n0,1,1\n0,2,\n1,3,4\n0,,2\n1,,\n")),
            "left out: 1 row (overwritten by a later row of its time; at line 2)");
  // Rows of one time with different values are what a long table is.
  EXPECT_EQ(accountOfText(table("t,joint,value\n0,a,1\n0,b,2\n1,a,1\n1,b,2\n")), "");
  EXPECT_EQ(accountOfText(table("t,arm.a,arm.b\n0,1,\n0,,2\n1,1,\n1,,2\n")), "");
  EXPECT_EQ(accountOfText(table("t,joint,value\n0,a,1\n0,b,2\n0,a,3\n")),
            "left out: 1 row (overwritten by a later row of its time; at line 2)");
  EXPECT_EQ(accountOfText(lines("{\"t\":0,\"arm\":{\"a\":1}}\n{\"t\":0,\"arm\":{\"b\":1}}\n"
                                "{\"t\":0,\"arm\":{\"b\":2}}\n")),
            "left out: 1 line (overwritten by a later line of its time; at line 2)");
}

TEST(TableRecording, RefusesATextWithoutAHeader) {
  for (const char* const text : {"", "\n\n", "a,b\n1,2\n", "t\n1\n", "t,\n1,2\n", "\"t,a\n"}) {
    SCOPED_TRACE(text);
    EXPECT_FALSE(table(text).ok());
    EXPECT_FALSE(looksLikeTable(text));
  }
  EXPECT_TRUE(looksLikeTable("\xEF\xBB\xBFt,arm.j1\r\n"));
}

/// The packets without their SOURCE, and what was left out.
std::vector<std::string> saidBy(Opened recording, const std::string& device = {}) {
  const auto made = importedFrom(std::move(recording), device);
  if (!made) return {made.error().text()};
  std::vector<std::string> said;
  for (const std::string& packet : made->packets)
    said.push_back(packet.substr(packet.find(" - ") + 3));
  if (!made->report.account.empty()) said.push_back(accountSentence(made->report.account, 9));
  for (const std::string& damage : made->report.damage) said.push_back(damage);
  if (made->report.malformed > 0) said.push_back("malformed");
  return said;
}

TEST(TableRecording, ReadsTheDialectsOfOtherPrograms) {
  const std::string first = "1700000000.5\njoint arm j1=0.25 j2=-1.5\n";
  const char* const texts[] = {
      "t;arm.j1;arm.j2\r\n1700000000,5;0,25;-1,5\r\n",  // a European spreadsheet
      "t;arm.j1;arm.j2\n1700000000.5;0.25;-1.5\n",
      "Timestamp\tarm.j1\tarm.j2\n1700000000.5\t0.25\t-1.5\n",
      "time_ms,arm.j1,arm.j2\n1700000000500,0.25,-1.5\n",
      "timestamp,arm.j1,arm.j2\n1700000000500,0.25,-1.5\n",  // told by its digits
      "stamp,arm.j1,arm.j2\n1700000000500000,0.25,-1.5\n",
      "__time,arm.j1,arm.j2\n1700000000500000000,0.25,-1.5\n",
      "%time,arm.j1,arm.j2\n1700000000500000000,0.25,-1.5\n",  // rostopic echo -p
      "timestamp [ns],arm.j1,arm.j2\n1700000000500000000,0.25,-1.5\n",
      "t (us),arm.j1,arm.j2\n1700000000500000,0.25,-1.5\n",
      "#timestamp,arm.j1,arm.j2\n1700000000.5,0.25,-1.5\n",
      "# made at noon\n# time in seconds\ntime arm.j1 arm.j2\n1700000000.5  0.25 -1.5\n",
      "time,arm.j1,arm.j2\n2023-11-14T22:13:20.5Z,0.25,-1.5\n",
      "time,arm.j1,arm.j2\n2023-11-14 22:13:20.500000,0.25,-1.5\n",
      "time,arm.j1,arm.j2\n2023-11-14 23:13:20.5+0100,0.25,-1.5\n",
      "\"t\",\"arm.j1\",\"arm.j2\"\n\"1700000000.5\",\"0.25\",\"-1.5\"\n",
  };
  for (const char* const text : texts) {
    SCOPED_TRACE(text);
    EXPECT_TRUE(looksLikeTable(text));
    EXPECT_THAT(saidBy(table(text)), ElementsAre(first));
  }
  // One unit for all rows: a later time that is longer changes nothing.
  EXPECT_THAT(saidBy(table("timestamp,arm.j1\n0,1\n250,2\n")),
              ElementsAre("0\njoint arm j1=1\n", "250\njoint arm j1=2\n"));
  // The first number with decimals tells what stands for the point.
  EXPECT_THAT(saidBy(table("t;arm.a;arm.b\n1;2;0,5\n2;1.5;3\n")),
              ElementsAre("1\njoint arm a=2 b=0.5\n", "malformed"));
}

TEST(TableRecording, NoValueYetIsNoText) {
  for (const char* const nothing :
       {"", "nan", "NaN", "n/a", "NA", "-", "--", "null", "None", "inf", "-nan(ind)"}) {
    SCOPED_TRACE(nothing);
    EXPECT_THAT(saidBy(table("t,arm.a,arm.b\n0,1," + std::string(nothing) + "\n1,2,3\n2," +
                             nothing + ",4\n")),
                ElementsAre("0\njoint arm a=1\n", "1\njoint arm a=2 b=3\n", "2\njoint arm b=4\n"));
  }
}

TEST(TableRecording, NamesEveryColumnThatIsLeftOut) {
  EXPECT_THAT(
      saidBy(table(",t,arm.j1,note,empty,clearance/a/b,/js/w/velocity,time_ns_text,other\n"
                   "0,1,0.5,begins,,3,4,x,7\n1,2,0.5,,nan,3,4,,7\n")),
      ElementsAre("1\njoint arm j1=0.5\njoint robot other=7\nsignal - note \"begins\"\n"
                  "signal - time_ns_text \"x\"\nsignals robot w.velocity=4\n",
                  "2\njoint arm j1=0.5\njoint robot other=7\nsignals robot w.velocity=4\n",
                  "left out: 1 column `clearance/a/b` (a distance), 1 column (row numbers), "
                  "1 column `empty` (no row has a value)"));
}

TEST(TableRecording, ColumnsOfSignalsAreSignals) {
  EXPECT_THAT(
      saidBy(table("t,signal arm load,signal arm/tip force,signal - estop,signal arm mode,arm.j1\n"
                   "1,1e-12,1e300,true,auto,0.5\n2,,,FALSE,7,\n3,0.1,-,nan,\"a \"\"b\"\"\",1\n")),
      ElementsAre("1\njoint arm j1=0.5\nsignals arm load=1e-12\nsignals arm/tip force=1e+300\n"
                  "signal arm mode \"auto\"\nsignals - estop=true\n",
                  "2\nsignals - estop=false\nsignals arm mode=7\n",
                  "3\njoint arm j1=1\nsignal arm mode \"a \\\"b\\\"\"\nsignals arm load=0.1\n"));
  // What nobody can state is named, as is what another column says already.
  EXPECT_THAT(saidBy(table("t,signal arm%20x load,signal arm l%zz,arm.on,signal arm on,signal arm\n"
                           "1,2,3,true,false,5\n")),
              ElementsAre("1\nsignals arm%20x load=2\nsignals arm on=false\n",
                          "left out: 1 column `signal arm l%zz` (packets have no such name), "
                          "1 column `signal arm` (packets have no such name), "
                          "1 column `arm.on` (stated twice: the first of them counts)"));
}

TEST(TableRecording, ReadsTheJointsThatPlotJugglerNames) {
  EXPECT_THAT(saidBy(table("__time,/joint_states/shoulder/position,/joint_states/elbow/position\n"
                           "1700000000.0,0.1,0.2\n")),
              ElementsAre("1700000000\njoint robot shoulder=0.1 elbow=0.2\n"));
  EXPECT_THAT(saidBy(table("__time,/left/joint_states/j1/position\n1,0.1\n")),
              ElementsAre("1\njoint left j1=0.1\n"));
}

TEST(TableRecording, ReadsThePosesThatTumWrites) {
  const char* const text =
      "# ground truth trajectory\n# timestamp tx ty tz qx qy qz qw\n1700000000.0 1 2 3 0 0 0 1\n";
  EXPECT_THAT(saidBy(table(text), "hand"), ElementsAre("1700000000\npose hand 1 2 3 0 0 0 1\n"));
}

TEST(TableRecording, ARefusalNamesWhatIsMissing) {
  EXPECT_THAT(
      table("a,b\n1,2\n").error().text(),
      HasSubstr("no column is the time (`t`, `time`, `timestamp`, `stamp` or `__time`, perhaps "
                "with a unit: `time_ms`): the columns are `a`, `b`"));
  EXPECT_THAT(table("1,2,3\n4,5,6\n").error().text(), HasSubstr("it has no header"));
  EXPECT_THAT(*tableRefusal("a;b\n1,5;2,5\n"), HasSubstr("the columns are `a`, `b`"));
  EXPECT_FALSE(tableRefusal("name = \"x\"\nsize = 3\n").has_value());
  EXPECT_FALSE(tableRefusal("x = [1, 2, 3]\ny = [4, 5, 6]\n").has_value());
  for (const char* const text :
       {"time = 5\nx = 3\n", "# the time of day\nx = 3\n", "time flies\n"}) {
    EXPECT_FALSE(looksLikeTable(text)) << text;
  }
  EXPECT_FALSE(tableRefusal("<robot name=\"a\"/>\n<!-- 1,2 -->\n").has_value());
  EXPECT_THAT(*jsonLinesRefusal("{\"x\": 1, \"y\": 2}\n"), HasSubstr("the keys are `x`, `y`"));
}

TEST(TextRefusal, SaysWhatTheTextLooksLikeAndWhatIsRead) {
  using namespace std::string_view_literals;
  EXPECT_THAT(*textRefusal("\xFF\xFEt\0,\0"sv), HasSubstr("UTF-16, and UTF-8 is read: `iconv"));
  EXPECT_THAT(*textRefusal("\xFE\xFF\0t\0,"sv), HasSubstr("UTF-16"));
  EXPECT_THAT(*textRefusal("\n[ {\"t\": 1}]"), HasSubstr("and JSON lines are read"));
  EXPECT_THAT(*textRefusal("t,arm.a\r1,2\r"), HasSubstr("CR alone"));
  EXPECT_THAT(*textRefusal("t|arm.a\n1|2\n"), HasSubstr("separated by `|`"));
  for (const char* const text : {"", "[", "[[device]]\nname = 1\n", "t,arm.a", "t,arm.a\r\n1,2\r\n",
                                 "a|b\n1|2\n", "{\"t\": 1}\n", "one\rtwo\r"}) {
    EXPECT_FALSE(textRefusal(text).has_value()) << text;
  }
}

// Whatever is inserted or removed, the packets change, or the account does.
TEST(TableRecording, WhatIsInsertedIsUsedOrNamed) {
  const auto all = [](const std::string& text) { return saidBy(table(text)); };
  const std::string whole = "t,arm.a,arm.b\n1,0.5,0.25\n2,0.75,0.125\n";
  const auto before = all(whole);
  for (const char* const name : {"x", "arm.c", "note", "time_ms", "clearance/a/b", "arm:x",
                                 "/js/w/effort", "odd \"\"name"}) {
    for (const char* const value : {"1", "text", "", "nan"}) {
      for (std::size_t place = 1; place <= 3; ++place) {
        std::string mutant;
        std::size_t row = 0;
        for (std::string_view rest = whole; const auto line = takeLine(rest); ++row) {
          std::vector<CsvField> fields;
          ASSERT_TRUE(splitCsvLine(*line, fields));
          std::string made;
          for (std::size_t i = 0; i <= fields.size(); ++i) {
            if (i == place) {
              made +=
                  (made.empty() ? "" : ",") + std::string("\"") + (row == 0 ? name : value) + "\"";
            }
            if (i < fields.size()) made += (made.empty() ? "" : ",") + std::string(fields[i].text);
          }
          mutant += made + "\n";
        }
        EXPECT_NE(all(mutant), before) << mutant;
      }
    }
  }
  EXPECT_NE(all("t,arm.a\n1,0.5\n2,0.75\n"), before);
  EXPECT_NE(all("t,arm.a,arm.b\n1,0.5,0.25\n"), before);
}

TEST(TableRecording, SkipsALineThatIsTooLong) {
  const std::string text =
      "t,arm.a\n1,2\n" + std::string(RecordingLines::kMaxBytes * 2, '7') + "\n2,3\n";
  const auto made = importedFrom(table(text));
  ASSERT_TRUE(made.ok());
  EXPECT_EQ(made->report.messages, 2U);
  EXPECT_THAT(made->report.damage, ElementsAre(HasSubstr("of more than 1 MiB left out")));
}

TEST(TableRecording, AHeaderThatIsTooLongIsRefusedAsThat) {
  const std::string column(200'000, 'x');
  std::string header = "t";
  for (int i = 0; i < 6; ++i) header += "," + column + std::to_string(i);
  const std::string row = "\n0,1,2,3,4,5,6\n";
  for (const std::string& text :
       {header + row, "# a remark\n" + header + row, header.substr(2) + ",t" + row}) {
    const Opened opened = table(text);
    ASSERT_FALSE(opened.ok());
    EXPECT_THAT(opened.error().what, HasSubstr("its header does not end within its first 1 MiB"));
  }
  EXPECT_TRUE(table(header.substr(0, 1'000'000) + "\n0,1,2,3,4,5\n").ok());
}

TEST(RecordingKind, ReadsTheWholeFirstLineOfAText) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "t.csv";
  std::string header = std::string(100'000, 'x') + ",t\n";
  writeFile(file, header + "1,0\n");
  EXPECT_EQ(recordingKindOf(file), RecordingKind::table);
  writeFile(file, std::string(2'000'000, 'x') + ",t\n1,0\n");
  EXPECT_EQ(recordingKindOf(file), RecordingKind::none);
  EXPECT_THAT(refusalOf(file).value_or(""), HasSubstr("first line is longer than 1 MiB"));
}

TEST(JsonLines, ReadsNumbersAsTextAndWhatHasNoValueYet) {
  EXPECT_THAT(
      saidBy(lines(
          "{\"t\":0,\"arm\":{\"a\":0.1,\"b\":null,\"c\":\"NaN\",\"on\":true}}\n"
          "{\"t\":\"0.5\",\"arm\":{\"a\":\"0.2\",\"b\":NaN,\"c\":-Infinity},\"note\":\"NaN is\"}\n"
          "{\"t\":1,\"device\":\"arm\",\"name\":[\"a\",\"b\"],\"position\":[null,3],"
          "\"effort\":[1]}\n")),
      ElementsAre("0\njoint arm a=0.1\nsignals arm on=true\n",
                  "0.5\njoint arm a=0.2\nsignal - note \"NaN is\"\n", "1\njoint arm b=3\n",
                  "left out: 1 key `effort` (an array)"));
  EXPECT_THAT(saidBy(lines("{\"timestamp\":1700000000500,\"arm\":{\"a\":1}}\n")),
              ElementsAre("1700000000.5\njoint arm a=1\n"));
}

TEST(JsonLines, NamesNumbersByTheKeysThatLeadToThem) {
  const auto made = importedFrom(
      lines("{\"t\": 1.000000001, \"arm\": {\"j1\": 0.5, \"on\": true}, \"arm.j2\": -2}\n"
            "{\"t_ns\": 1700000000123456789, \"device\": \"arm\", \"name\": [\"a\", \"b\"], "
            "\"position\": [1, 2.5]}\n"
            "{\"t\": 3, \"device\": \"arm\", \"joint\": \"c\", \"value\": 4}\n"));
  ASSERT_TRUE(made.ok()) << made.error().text();
  EXPECT_THAT(made->packets,
              ElementsAre("RK1 decoded:json:json - 1.000000001\njoint arm j1=0.5 j2=-2\n"
                          "signals arm on=true\n",
                          "RK1 decoded:json:json - 3\njoint arm c=4\n",
                          "RK1 decoded:json:json - 1700000000.123456789\njoint arm a=1 b=2.5\n"));
}

TEST(JsonLines, KeepsAndCountsWhatDoesNotFit) {
  const auto made =
      importedFrom(lines("{\"t\": 1, \"arm.a\": 2}\n"
                         "{\"t\": 2, \"arm.a\": [{}]}\n"
                         "{\"arm.a\": 2}\n"
                         "no JSON\n"
                         "{\"t\": 3, \"name\": [\"a\"], \"position\": [1, 2]}\n"));
  ASSERT_TRUE(made.ok());
  EXPECT_EQ(made->report.messages, 3U);
  EXPECT_EQ(made->report.malformed, 2U);
  EXPECT_THAT(made->report.damage,
              ElementsAre("2 lines without a time left out, the first here (l.jsonl, line 3)"));
}

TEST(JsonLines, AreNotTakenForOtherJson) {
  for (const char* const text :
       {"{}", "{\n\"t\": 1}", "[1]", "{\"asset\": {\"t\": 1}}", "{\"t\": 1"}) {
    EXPECT_FALSE(looksLikeJsonLines(text)) << text;
  }
  EXPECT_TRUE(looksLikeJsonLines("{\"t\": 1}\n"));
}

/// An event of LCM, byte by byte as its format has it; everything is big-endian.
void appendEvent(Bytes& out, std::uint64_t number, std::int64_t time_us, std::string_view channel,
                 std::string_view data) {
  const auto big = [&](std::uint64_t value, int bytes) {
    for (int i = bytes - 1; i >= 0; --i) out.push_back(static_cast<std::byte>(value >> (8 * i)));
  };
  big(0xEDA1DA01, 4);                           // sync word
  big(number, 8);                               // event number
  big(static_cast<std::uint64_t>(time_us), 8);  // microseconds since 1970
  big(channel.size(), 4);                       // length of the channel's name
  big(data.size(), 4);                          // length of the data
  for (const char byte : channel) out.push_back(static_cast<std::byte>(byte));
  for (const char byte : data) out.push_back(static_cast<std::byte>(byte));
}

Bytes lcmLog() {
  Bytes out;
  appendEvent(out, 0, 1'700'000'000'000'001, "POSE", std::string("\x01\x02\x00\xff", 4));
  appendEvent(out, 1, 1'700'000'000'000'002, "ARM", "RK1 arm 1 0\njoint arm a=0.5\n");
  appendEvent(out, 2, 1'700'000'000'000'003, "POSE", "");
  return out;
}

TEST(LcmLog, KeepsEveryEventWithItsMicroseconds) {
  const Bytes events = lcmLog();
  EXPECT_EQ(recordingKindOf(events), RecordingKind::lcm);
  const auto made = importedFrom(openLcmBytes(events, "x.lcm"));
  ASSERT_TRUE(made.ok()) << made.error().text();
  EXPECT_TRUE(made->report.lostNothing());
  LogReader reader = openLog(made->log);
  std::vector<std::string> kept;
  for (const KeptMessage& message : readAll(reader)) {
    if (!message.topic.starts_with("/rocinante/")) {
      kept.push_back(message.topic + " " + std::to_string(message.log_time_ns) + " " +
                     std::to_string(message.payload.size()));
    }
  }
  EXPECT_THAT(kept, ElementsAre("/POSE 1700000000000001000 4", "/ARM 1700000000000002000 28",
                                "/POSE 1700000000000003000 0"));
  for (const LogChannel& channel : reader.channels()) {
    if (channel.topic == "/ARM") {
      EXPECT_EQ(channel.encoding, "rk1");
    }
    if (channel.topic == "/POSE") {
      EXPECT_EQ(channel.encoding, "lcm");
    }
  }
}

TEST(LcmLog, FindsTheNextEventBehindDamage) {
  Bytes events = lcmLog();
  const std::size_t whole = events.size();
  // The length of the second event's data, to one that does not fit.
  events[28 + 4 + 4 + 24] = std::byte{0x7F};
  const auto made = importedFrom(openLcmBytes(events, "x.lcm"));
  ASSERT_TRUE(made.ok());
  EXPECT_EQ(made->report.messages, 2U);
  EXPECT_THAT(made->report.damage,
              ElementsAre(HasSubstr("no event begins here: 59 bytes skipped (x.lcm, byte 36)")));
  EXPECT_EQ(whole, events.size());
}

/// Cut at every length: whole messages, or a sentence; never a crash, and never more than there is.
void cutEverywhere(ByteView whole, const std::function<Opened(ByteView)>& open) {
  std::uint64_t last = 0;
  for (std::size_t bytes = 0; bytes <= whole.size(); ++bytes) {
    SCOPED_TRACE(bytes);
    // A buffer of its own, so that the sanitizer sees one byte too many.
    const Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(bytes));
    const auto made = importedFrom(open(cut));
    const std::uint64_t messages = made.ok() ? made->report.messages : 0;
    EXPECT_GE(messages + 1, last);
    last = std::max(last, messages);
  }
  EXPECT_EQ(last, 3U);
}

TEST(RecordingReaders, SurviveACutAtEveryLength) {
  cutEverywhere(lcmLog(), [](ByteView bytes) { return openLcmBytes(bytes, "x"); });
  const std::string_view rows = "t,arm.a,arm.b\n1,2,3\n2,\"3\",4\n3,4,5\n";
  cutEverywhere(bytesOf(rows), [](ByteView bytes) { return openTableBytes(bytes, "x", {}); });
  const std::string_view objects =
      "{\"t\":1,\"a\":{\"b\":2}}\n{\"t\":2,\"name\":[\"x\"],\"position\":[1]}\n{\"t\":3}\n";
  cutEverywhere(bytesOf(objects), [](ByteView bytes) { return openJsonBytes(bytes, "x", {}); });
}

TEST(RecordingLines, GiveTheSameLinesWhereverTheWindowEnds) {
  std::string text = "first\r\n";
  for (int i = 0; i < 40'000; ++i) text += "line " + std::to_string(i) + "\n";
  text += "last";
  RecordingLines lines{RecordingBytes(bytesOf(text))};
  EXPECT_EQ(lines.next(), "first");
  for (int i = 0; i < 40'000; ++i) ASSERT_EQ(lines.next(), "line " + std::to_string(i));
  EXPECT_EQ(lines.next(), "last");
  EXPECT_EQ(lines.number(), 40'002U);
  EXPECT_EQ(lines.next(), std::nullopt);
  EXPECT_DOUBLE_EQ(lines.part(), 1.0);
}

}  // namespace
}  // namespace rocinante::test
