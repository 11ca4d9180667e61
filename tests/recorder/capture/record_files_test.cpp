#include <gmock/gmock.h>
#include <unistd.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "core/log/log_reader.h"
#include "core/net/udp_socket.h"
#include "recorder/capture/record.h"
#include "tests/support/programs.h"

// Other programs change the file of a recording, and a cell loads slowly.
namespace rocinante {
namespace {

using PlainJson = nlohmann::json;
using test::Program;
using test::ProgramResult;
using test::TemporaryFolder;
using ::testing::HasSubstr;

UdpSender senderTo(const std::string& endpoint) {
  return std::move(UdpSender::open(Endpoint::parse(endpoint).value()).value());
}

struct OneRecording {
  explicit OneRecording(std::vector<std::string> options = {}) {
    options.insert(options.begin(), {"127.0.0.1:0", "-o", log.string(), "--json"});
    program.emplace(Program::start("rocinante-record", options));
    std::istringstream words(program->waitForLine("recording "));
    words >> endpoint >> endpoint;
  }
  void send(int count) {
    UdpSender sender = senderTo(endpoint);
    for (int i = 0; i < count; ++i) ASSERT_TRUE(sender.send(bytesOf("x")).ok());
  }
  /// Waits until the file holds some of the session.
  void waitUntilWritten() const {
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (capturedIn(log) == 0) {
      ASSERT_LT(std::chrono::steady_clock::now(), give_up);
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }
  static std::size_t capturedIn(const std::filesystem::path& path) {
    auto reader = LogReader::open(path);
    if (!reader) return 0;
    std::size_t count = 0;
    for (auto message = reader->next(); message && *message; message = reader->next()) {
      if ((*message)->channel->captured()) ++count;
    }
    return count;
  }

  TemporaryFolder folder;
  std::filesystem::path log = folder / "log.mcap";
  std::optional<Program> program;
  std::string endpoint;
};

TEST(RecordedFile, ASecondRecorderIsRefusedForcedOrNot) {
  OneRecording first;
  first.send(20);
  first.waitUntilWritten();
  for (const bool forced : {false, true}) {
    std::vector<std::string> arguments{"127.0.0.1:0", "-o", first.log.string()};
    if (forced) arguments.emplace_back("--force");
    const ProgramResult second = test::runProgram("rocinante-record", arguments);
    EXPECT_EQ(second.exit_code, 2);
    if (!forced) continue;
    EXPECT_THAT(second.err, HasSubstr("is writing this file"));
    EXPECT_THAT(second.err, HasSubstr(first.log.string()));
  }
  first.send(10);
  EXPECT_EQ(first.program->stop().exit_code, 0);
  EXPECT_EQ(OneRecording::capturedIn(first.log), 30U);
  // The recording is over, so --force may replace the file.
  EXPECT_EQ(test::runProgram("rocinante-record", {"127.0.0.1:0", "-o", first.log.string(),
                                                  "--force", "--duration", "1ms"})
                .exit_code,
            0);
}

TEST(RecordedFile, NoToolReplacesItWhileItIsWritten) {
  OneRecording whole;
  whole.send(5);
  ASSERT_EQ(whole.program->stop().exit_code, 0);
  OneRecording live;
  live.send(5);
  live.waitUntilWritten();
  const std::vector<std::string> cut{"cut", whole.log.string(), "--from", "0s",
                                     "-o",  live.log.string(),  "--force"};
  std::vector<std::vector<std::string>> tools{cut};
  for (const char* tool : {"recover", "merge"}) {
    tools.push_back({tool, whole.log.string(), "-o", live.log.string(), "--force"});
  }
  for (const std::vector<std::string>& tool : tools) {
    const ProgramResult result = test::runProgram("rocinante-log", tool);
    EXPECT_EQ(result.exit_code, 2) << tool[0];
    EXPECT_THAT(result.err, HasSubstr("is writing this file")) << tool[0];
  }
  ASSERT_EQ(live.program->stop().exit_code, 0);
  EXPECT_EQ(OneRecording::capturedIn(live.log), 5U);
  EXPECT_EQ(test::runProgram("rocinante-log", cut).exit_code, 0);
}

TEST(RecordedFile, ADeletedOneIsToldWhileItIsRecordedAndIsNotComplete) {
  OneRecording recording;
  recording.send(5);
  recording.waitUntilWritten();
  std::filesystem::remove(recording.log);
  recording.program->waitForLine("deleted or replaced");
  const ProgramResult result = recording.program->stop();
  EXPECT_EQ(result.exit_code, 1);
  const PlainJson summary = PlainJson::parse(result.out, nullptr, false);
  EXPECT_EQ(summary["complete"], false);
  EXPECT_EQ(summary["reason"], "interrupted");
  ASSERT_EQ(summary["pieces"].size(), 1U);
  EXPECT_THAT(summary["pieces"][0]["trouble"].get<std::string>(), HasSubstr("deleted or replaced"));
  EXPECT_EQ(summary["warnings"].size(), 1U) << "told once";
}

TEST(RecordedFile, OneThatIsCutOrReplacedJustBeforeTheEndIsNotComplete) {
  for (const bool cut : {false, true}) {
    OneRecording recording;
    recording.send(5);
    recording.waitUntilWritten();
    if (cut) {
      ASSERT_EQ(::truncate(recording.log.c_str(), 0), 0);
    } else {
      std::filesystem::copy_file("/proc/self/exe", recording.folder / "other");
      std::filesystem::rename(recording.folder / "other", recording.log);
    }
    const ProgramResult result = recording.program->stop();
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_EQ(PlainJson::parse(result.out, nullptr, false)["complete"], false);
    EXPECT_THAT(result.err, HasSubstr(cut ? "changed this log" : "deleted or replaced"));
  }
}

TEST(RecordedFile, OneThatIsMovedIsComplete) {
  OneRecording recording;
  recording.send(5);
  recording.waitUntilWritten();
  std::filesystem::rename(recording.log, recording.folder / "moved.mcap");
  const ProgramResult result = recording.program->stop();
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(PlainJson::parse(result.out, nullptr, false)["complete"], true);
  EXPECT_EQ(OneRecording::capturedIn(recording.folder / "moved.mcap"), 5U);
}

struct SlowCell {
  explicit SlowCell(const std::filesystem::path& log) {
    options.endpoints = {Endpoint::parse("127.0.0.1:0").value()};
    options.log = log;
    events.listening = [this](const std::vector<std::string>& names) { endpoint = names.at(0); };
  }
  /// Datagrams received while the cell is being read.
  void hear() {
    UdpSender sender = senderTo(endpoint);
    for (int i = 0; i < 10; ++i) ASSERT_TRUE(sender.send(bytesOf("x")).ok());
  }
  std::string endpoint;
  RecordOptions options;
  RecordEvents events;
};

TEST(RecordWithACell, WhatComesWhileItIsReadIsRecorded) {
  const TemporaryFolder folder;
  SlowCell slow(folder / "log.mcap");
  slow.options.load_cell = [&]() -> Result<LoadedCell> {
    slow.hear();
    return LoadedCell();
  };
  slow.options.max_packets = 10;
  const Result<RecordSummary> summary = record(slow.options, slow.events);
  ASSERT_TRUE(summary.ok()) << summary.error().text();
  EXPECT_EQ(summary->packets, 10U);
  EXPECT_EQ(OneRecording::capturedIn(folder / "log.mcap"), 10U);
}

TEST(RecordWithACell, OneThatDoesNotLoadLeavesNoLog) {
  const TemporaryFolder folder;
  SlowCell slow(folder / "log.mcap");
  slow.options.load_cell = [&]() -> Result<LoadedCell> {
    slow.hear();
    return Error{ErrorKind::damaged, "no cell", "cell.toml"};
  };
  const Result<RecordSummary> summary = record(slow.options, slow.events);
  ASSERT_FALSE(summary.ok());
  EXPECT_EQ(
      summary.error().text(),
      "nothing is recorded: no cell; without --cell it records, and `rocinante log attach` adds "
      "the cell later (cell.toml)");
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace rocinante
