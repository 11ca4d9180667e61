#include <gtest/gtest.h>
#include <signal.h>

#include <nlohmann/json.hpp>
#include <set>

#include "core/log/log_reader.h"
#include "tests/support/nats_server.h"

// The real programs, with Debian's nats-server between them.
namespace rocinante {
namespace {

using test::NatsServer;
using test::Program;
using test::runProgram;

class RecordNats : public testing::Test {
 protected:
  void SetUp() override { ROCINANTE_NEEDS_NATS_SERVER(); }

  /// A motion of `rows` rows, 1 ms apart.
  void writeMotion(int rows) {
    std::string text = "t,j1,j2\n";
    for (int i = 0; i < rows; ++i) {
      text += std::to_string(i / 1000) + "." + std::to_string(1000 + i % 1000).substr(1) + "," +
              std::to_string(i) + ",0.5\n";
    }
    std::ofstream(folder_ / "motion.csv") << text;
  }
  test::ProgramResult sendMotion(const std::string& to, const std::string& run = "r1") {
    return runProgram("rocinante-source",
                      {"--csv", "motion.csv", "--device", "arm", "--run", run, "--to", to},
                      folder_.path());
  }
  nlohmann::json info(const std::string& log) {
    const auto result = runProgram("rocinante-log", {"info", log, "--json"}, folder_.path());
    return nlohmann::json::parse(result.out, nullptr, false);
  }
  /// Waits until a recording has written `count` packets, as its log says.
  void waitForPackets(const std::string& log, std::uint64_t count) {
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (payloads(log).size() < count) {
      ASSERT_LT(std::chrono::steady_clock::now(), give_up) << payloads(log).size();
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }
  /// Every captured payload of a log, also of one that is being written or was left by a kill.
  std::vector<std::string> payloads(const std::string& log) {
    std::vector<std::string> all;
    auto reader = LogReader::open(folder_ / log);
    if (!reader) return all;
    while (true) {
      const auto message = reader->next();
      if (!message || !*message) return all;
      if ((*message)->channel->captured()) {
        all.emplace_back(textOf((*message)->payload));
      }
    }
  }

  test::TemporaryFolder folder_;
};

TEST_F(RecordNats, RecordsWhatASourcePublishesAndPlaysIt) {
  const NatsServer server;
  writeMotion(500);
  Program record =
      Program::start("rocinante-record", {server.at("cell1"), "-o", "a.mcap"}, folder_.path());
  record.waitForLine("recording " + server.at("cell1"));
  const auto sent = sendMotion(server.at("cell1"));
  ASSERT_EQ(sent.exit_code, 0) << sent.err;
  waitForPackets("a.mcap", 500);
  ASSERT_EQ(record.stop().exit_code, 0);
  const auto first = info("a.mcap");
  ASSERT_EQ(first["channels"].size(), 1U) << first.dump(1);
  EXPECT_EQ(first["channels"][0]["topic"], "/nats/cell1.arm");
  EXPECT_EQ(first["channels"][0]["encoding"], "rk1");

  // The replay goes to another subject, by the topic, and is recorded there with the same content.
  record =
      Program::start("rocinante-record", {server.at("copy.*"), "-o", "b.mcap"}, folder_.path());
  record.waitForLine("recording " + server.at("copy.*"));
  const auto played = runProgram(
      "rocinante-play", {"a.mcap", "--map", "/nats/cell1.*=" + server.at("copy"), "--asap"},
      folder_.path());
  ASSERT_EQ(played.exit_code, 0) << played.err;
  waitForPackets("b.mcap", payloads("a.mcap").size());
  ASSERT_EQ(record.stop().exit_code, 0);
  EXPECT_EQ(payloads("b.mcap"), payloads("a.mcap"));
  EXPECT_EQ(info("b.mcap")["channels"][0]["topic"], "/nats/copy.arm");
}

TEST_F(RecordNats, TeesToASubject) {
  const NatsServer server;
  writeMotion(300);
  Program far =
      Program::start("rocinante-record", {server.at("hall"), "-o", "far.mcap"}, folder_.path());
  far.waitForLine("recording");
  Program near = Program::start("rocinante-record",
                                {"127.0.0.1:0", "-o", "near.mcap", "--tee", server.at("hall")},
                                folder_.path());
  const std::string line = near.waitForLine("recording udp://127.0.0.1:");
  const std::string to = line.substr(line.find("udp://"), line.find(" to ") - line.find("udp://"));
  ASSERT_EQ(sendMotion(to).exit_code, 0);
  waitForPackets("near.mcap", 300);
  waitForPackets("far.mcap", payloads("near.mcap").size());
  EXPECT_EQ(near.stop().exit_code, 0);
  EXPECT_EQ(far.stop().exit_code, 0);
  EXPECT_EQ(payloads("far.mcap"), payloads("near.mcap"));

  const auto circle =
      runProgram("rocinante-record",
                 {server.at("hall"), "-o", "c.mcap", "--tee", server.at("hall")}, folder_.path());
  EXPECT_EQ(circle.exit_code, 2);
  EXPECT_NE(circle.err.find("it would receive itself endlessly"), circle.err.npos) << circle.err;
  // Also where the server goes by another name.
  const auto named = runProgram("rocinante-record",
                                {server.at("hall"), "-o", "c.mcap", "--tee",
                                 "nats://localhost:" + std::to_string(server.port()) + "/hall"},
                                folder_.path());
  EXPECT_EQ(named.exit_code, 2);
  EXPECT_NE(named.err.find("it would receive itself endlessly"), named.err.npos) << named.err;
}

// Before the server: all wait, and nothing is missing.
TEST_F(RecordNats, ProgramsStartInAnyOrder) {
  NatsServer server;
  server.kill();
  writeMotion(300);
  Program record =
      Program::start("rocinante-record", {server.at("cell1"), "-o", "a.mcap"}, folder_.path());
  record.waitForLine("yet; waiting for it");
  Program source = Program::start(
      "rocinante-source",
      {"--csv", "motion.csv", "--device", "arm", "--run", "r1", "--to", server.at("far")},
      folder_.path());
  source.waitForLine("yet; waiting for it");
  Program relay = Program::start(
      "rocinante-relay", {"--from", server.at("far"), "--to", server.at("cell1")}, folder_.path());
  relay.waitForLine("yet; waiting for it");
  const auto script = runProgram("rocinante-record",
                                 {server.at("cell1"), "-o", "b.mcap", "--no-wait"}, folder_.path());
  EXPECT_EQ(script.exit_code, 2);
  EXPECT_NE(script.err.find("no NATS server answers"), script.err.npos) << script.err;
  server.start();
  // The source that waited may speak before the others hear it.
  ASSERT_EQ(source.finish().exit_code, 0);
  record.waitForLine("connected to");
  relay.waitForLine("connected to " + server.at("far"));
  relay.waitForLine("connected to " + server.at("cell1"));
  ASSERT_EQ(sendMotion(server.at("far"), "r2").exit_code, 0);
  const auto ofSecondRun = [&] {
    const auto all = payloads("a.mcap");
    return std::count_if(all.begin(), all.end(),
                         [](const std::string& each) { return each.find("@r2 ") != each.npos; });
  };
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (ofSecondRun() < 300 && std::chrono::steady_clock::now() < give_up) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  EXPECT_GE(ofSecondRun(), 300);
  EXPECT_EQ(record.stop().exit_code, 0);
  EXPECT_EQ(relay.stop().exit_code, 0);
}

// A message that no datagram of UDP could be is kept whole; UDP does not carry it.
TEST_F(RecordNats, ALargeMessageIsRecordedWholeAndNotPlayedOverUdp) {
  const NatsServer server;
  Program record = Program::start(
      "rocinante-record", {server.at("cell1"), "-o", "a.mcap", "--max-loss", "0"}, folder_.path());
  record.waitForLine("recording " + server.at("cell1"));
  natsConnection* connection = nullptr;
  const std::string url = "nats://127.0.0.1:" + std::to_string(server.port());
  ASSERT_EQ(natsConnection_ConnectTo(&connection, url.c_str()), NATS_OK);
  const std::string large(600'000, 'x');
  for (const std::string& each : {std::string("a"), large, std::string("b")}) {
    ASSERT_EQ(
        natsConnection_Publish(connection, "cell1.x", each.data(), static_cast<int>(each.size())),
        NATS_OK);
  }
  ASSERT_EQ(natsConnection_FlushTimeout(connection, 5000), NATS_OK);
  natsConnection_Destroy(connection);
  waitForPackets("a.mcap", 3);
  EXPECT_EQ(record.stop().exit_code, 0);
  EXPECT_EQ(payloads("a.mcap"), (std::vector<std::string>{"a", large, "b"}));
  const auto played = runProgram(
      "rocinante-play", {"a.mcap", "--to", "127.0.0.1:9", "--asap", "--json"}, folder_.path());
  ASSERT_EQ(played.exit_code, 0) << played.err;
  const auto report = nlohmann::json::parse(played.out);
  EXPECT_EQ(report["sent"], 2);
  EXPECT_EQ(report["left_out"]["total"], 1) << report.dump(1);
}

TEST_F(RecordNats, AKilledRecordingOfAStreamIsContinuedAndNothingIsMissing) {
  const NatsServer server({"-js"});
  test::StreamAdministrator administrator(server);
  administrator.add("CELLS", "cell1.>");
  writeMotion(750);
  std::vector<std::string> logs;
  std::set<std::string> kept;
  for (int i = 0; i < 4; ++i) {
    // A motion for each recording: on a slow machine the one before may have kept all that there
    // was.
    Program source = Program::start("rocinante-source",
                                    {"--csv", "motion.csv", "--device", "arm", "--run",
                                     "r" + std::to_string(i), "--to", server.at("cell1")},
                                    folder_.path());
    source.waitForLine("sending");
    logs.push_back("part" + std::to_string(i) + ".mcap");
    Program record = Program::start("rocinante-record",
                                    {server.streamAt("CELLS"), "-o", logs.back()}, folder_.path());
    record.waitForLine("recording");
    waitForPackets(logs.back(), 200);
    if (HasFailure()) return;
    record.signal(SIGKILL);
    EXPECT_EQ(record.finish().exit_code, 128 + SIGKILL);
    const auto sent = source.finish();
    ASSERT_EQ(sent.exit_code, 0) << sent.err;
  }
  const std::uint64_t count = administrator.messages("CELLS");
  ASSERT_GE(count, 3'000U);
  std::uint64_t recorded = 0;
  for (const std::string& each : logs) {
    for (std::string& payload : payloads(each)) {
      kept.insert(std::move(payload));
      ++recorded;
    }
  }
  Program last = Program::start("rocinante-record", {server.streamAt("CELLS"), "-o", "end.mcap"},
                                folder_.path());
  last.waitForLine("resumes after message");
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (kept.size() < count && std::chrono::steady_clock::now() < give_up) {
    for (std::string& payload : payloads("end.mcap")) kept.insert(std::move(payload));
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  EXPECT_EQ(last.stop().exit_code, 0);
  // Every packet has its own RUN and SEQUENCE.
  EXPECT_EQ(kept.size(), count);
  recorded += payloads("end.mcap").size();
  EXPECT_GE(recorded, count);
  // Nothing is repeated beyond what one kill leaves unconfirmed.
  EXPECT_LT(recorded, 2 * count);
  EXPECT_EQ(info("end.mcap")["losses"]["kernel"], 0) << info("end.mcap")["losses"].dump();
}

TEST_F(RecordNats, AGapInAStreamIsALossInTheLog) {
  const NatsServer server({"-js"});
  test::StreamAdministrator administrator(server);
  administrator.add("CELLS", "cell1.>");
  for (int i = 1; i <= 20; ++i) {
    administrator.publish("cell1.arm", "RK1 arm@r " + std::to_string(i) + " -\n");
  }
  administrator.erase("CELLS", 7);
  administrator.erase("CELLS", 8);
  Program record =
      Program::start("rocinante-record",
                     {server.streamAt("CELLS"), "-o", "a.mcap", "--max-loss", "0"}, folder_.path());
  waitForPackets("a.mcap", 18);
  const auto result = record.stop();
  EXPECT_EQ(result.exit_code, 1) << result.err;
  EXPECT_EQ(info("a.mcap")["losses"]["kernel"], 2);
  EXPECT_NE(result.err.find("lost 2 packets, more than --max-loss 0"), result.err.npos)
      << result.err;
}

TEST_F(RecordNats, SaysWhatCannotBeCombined) {
  for (const auto& [arguments, said] :
       {std::pair<std::vector<std::string>, std::string>(
            {"jetstream://127.0.0.1:1/A", ":0", "-o", "x.mcap"},
            "a stream must be the only endpoint"),
        {{"nats://127.0.0.1:1/a", "--allow", "10.0.0.0/8", "-o", "x.mcap"},
         "--allow is about senders' addresses"}}) {
    const auto result = runProgram("rocinante-record", arguments, folder_.path());
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find(said), result.err.npos) << result.err;
  }
}

}  // namespace
}  // namespace rocinante
