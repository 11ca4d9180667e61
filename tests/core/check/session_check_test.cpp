#include "tests/core/check/session_check_test.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/check/check.h"
#include "core/check/reports/baseline.h"
#include "core/check/reports/report_formats.h"
#include "core/kinematics/kinematics.h"
#include "core/log/log_writer.h"
#include "core/packet/decoder.h"
#include "core/recording/session_writer.h"

namespace rocinante {
namespace {

using test::kCheckedArm;
using test::kCheckedCell;
using test::SessionCheckTest;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST_F(SessionCheckTest, FindsNothingWrongWithASessionThatFits) {
  say("me@a 0 1", "order arm slide shoulder\njoints arm 0.1 1");
  say("me@a 1 2", "joints arm 0.2 0.5\npose arm 0 0 0 0 0 0 1\njoint arm elbow=99");
  say("me@a 2 3", "show arm/hand\nhide layer/robots\ncolor arm #ff0000\nevent \"done\"");
  say("me@a 3 4", "line path #ffffff in arm/tip 0 0 0 1 1 1\nview top 0 0 1 0 0 0 45 in arm/base");
  const CheckReport found = report();
  EXPECT_THAT(rules(found), IsEmpty());
  EXPECT_EQ(found.verdict, CheckVerdict::compatible);
  EXPECT_EQ(found.packets, 4U);
  EXPECT_THAT(found.sources, ElementsAre("me"));
}

TEST_F(SessionCheckTest, JudgesNothingWithoutADecodablePacket) {
  EXPECT_EQ(report().verdict, CheckVerdict::nothing_judged);
  session_->add(now_, "octets", true, bytesOf("whatever"));
  const CheckReport octets = report();
  EXPECT_EQ(octets.verdict, CheckVerdict::nothing_judged);
  EXPECT_THAT(rules(octets), ElementsAre("device.undriven", "packet.unknown-protocol"));
  say("joints arm 0 0 0");
  EXPECT_EQ(report().verdict, CheckVerdict::compatible);
}

TEST_F(SessionCheckTest, CountsUnknownDevicesWithTheirFirstExample) {
  say("joints arm 0 0 0");
  say("joints rama 1 2 3");
  say("hide rama");
  const CheckReport found = report();
  ASSERT_THAT(rules(found), ElementsAre("packet.unknown-device"));
  const Finding& finding = found.findings[0];
  EXPECT_EQ(finding.severity, Severity::error);
  EXPECT_EQ(finding.count, 2U);
  EXPECT_EQ(finding.packet, 2U);
  EXPECT_EQ(finding.example, "joints rama 1 2 3");
  EXPECT_EQ(*finding.last - *finding.first, std::chrono::milliseconds(1));
  EXPECT_EQ(found.verdict, CheckVerdict::incompatible);
}

TEST_F(SessionCheckTest, KnowsDevicesThatAnAddBringsLater) {
  say("joints arm 0 0 0\njoints second 0 0");
  say("add second arm.urdf");
  say("joints second 0 0 0");
  const CheckReport found = report();
  // Values sent before the device appeared count once it does.
  ASSERT_THAT(rules(found), ElementsAre("packet.joint-count", "packet.before-add"));
  EXPECT_EQ(found.findings[0].count, 1U);
  EXPECT_EQ(found.findings[0].text, "device second gets 2 values, and its model arm takes 3");
}

TEST_F(SessionCheckTest, NamesUnknownModelsAndOtherKinematics) {
  const std::uint64_t hash = kinematicsHash(*cell_.models.at("arm.urdf"));
  say("joints arm 0 0 0");
  say("add a gantry");
  say(fmt::format("add b arm.urdf kin={:016x}", hash));
  say(fmt::format("add c arm.urdf kin={:016x}", hash ^ 1U));
  const CheckReport found = report();
  ASSERT_THAT(rules(found), ElementsAre("packet.unknown-model", "packet.other-kinematics"));
  EXPECT_THAT(found.findings[0].text, HasSubstr("gantry"));
  EXPECT_EQ(found.findings[1].subject, "c");
}

TEST_F(SessionCheckTest, NamesWrongJointCountsPositionalAndUnderAnOrder) {
  say("joints arm 0 0");
  say("joints arm 0 0 0 0");
  say("other - -", "add spare arm.urdf\norder spare shoulder slide\njoints spare 0 0 0");
  const CheckReport found = report();
  ASSERT_THAT(rules(found), ElementsAre("packet.joint-count", "packet.joint-count"));
  EXPECT_EQ(found.findings[0].text, "device arm gets 2 values, and its model arm takes 3");
  EXPECT_EQ(found.findings[0].count, 2U);
  EXPECT_EQ(found.findings[0].hint, "`joints` takes them in this order: shoulder, elbow, slide");
  EXPECT_EQ(found.findings[1].text, "device spare gets 3 values under an order of 2 names");
  EXPECT_EQ(found.findings[1].hint, "its order is: shoulder, slide");
}

TEST_F(SessionCheckTest, NamesJointsThatTheModelLacksOrNobodyCanDrive) {
  say("joints arm 0 0 0\norder arm shoulder wrist");
  say("joint arm weld=1 finger=2");
  EXPECT_THAT(rules(report()), ElementsAre("packet.unknown-joint", "packet.unknown-joint",
                                           "packet.undrivable-joint"));
}

TEST_F(SessionCheckTest, SaysThatTwoPacketsHaveNearlyOneTime) {
  for (int i = 0; i < 8; ++i) {
    say(fmt::format("me@a {} {:.4f}", i, 100 + i * 0.1),
        fmt::format("joints arm {:.2f} 0 0", i * 0.08));
  }
  say("me@a 8 100.7005", "joints arm 0.64 0 0");
  const CheckReport found = report();
  ASSERT_THAT(rules(found), ElementsAre("joint.jump"));
  EXPECT_FALSE(found.findings[0].worst) << "it states a time";
  EXPECT_EQ(found.findings[0].text,
            "SEQUENCE 7 and 8 have nearly the same TIME, 0.5 ms apart; arm/shoulder moved between "
            "them, and its limit is 57.2958°/s");
}

TEST_F(SessionCheckTest, HintsAtTheNameThatWasMeant) {
  say("joints arm 0 0 0\njoint arm sholder=1\nshow arm/tpi\njoints amr 0 0 0");
  const CheckReport found = report();
  const auto hintOf = [&](std::string_view rule) {
    for (const Finding& finding : found.findings) {
      if (finding.rule == rule) return finding.hint;
    }
    return std::string("none");
  };
  EXPECT_EQ(hintOf("packet.unknown-joint"), "did you mean `shoulder`?");
  EXPECT_THAT(hintOf("packet.unknown-device"), testing::StartsWith("did you mean `arm`? "));
}

TEST_F(SessionCheckTest, NamesTheWorstValueOutsideLimits) {
  say("joints arm 1.5000005 9 0.2");  // as a sender rounds
  say("joints arm 1.6 -9 0.1");
  say("joints arm -1.75 0 0.1");
  say("joints arm 1.51 0 -0.1");
  const CheckReport found = report();
  // The elbow turns by almost a turn in a millisecond, but it has no limit that forbids it.
  ASSERT_THAT(rules(found), ElementsAre("joint.limit", "joint.limit"));
  EXPECT_EQ(found.findings[0].text,
            "arm/shoulder is outside its limits [-57.2958°, 85.9437°]; the worst is -100.268°");
  EXPECT_EQ(found.findings[0].count, 3U);
  EXPECT_EQ(found.findings[0].packet, 2U);
  EXPECT_EQ(found.findings[1].text,
            "arm/slide is outside its limits [0, 0.2] m; the worst is -0.1");
}

TEST_F(SessionCheckTest, ABaselineHasTheWorstValuesThatSentencesState) {
  std::ofstream(folder_ / "cell.toml")
      << kCheckedCell << "[rules]\n\"joint.acceleration\".per_s2 = 5\n";
  Result<Cell> cell = loadCell(folder_ / "cell.toml", {});
  ASSERT_TRUE(cell.ok()) << cell.error().text();
  cell_ = std::move(*cell);
  session_.emplace(cell_);
  int number = 0;
  const auto drive = [&](double shoulder, double slide) {
    now_ += std::chrono::milliseconds(100);
    say(fmt::format("me@a {} {:.1f}", number, 1000 + 0.1 * number),
        fmt::format("joints arm {} 0 {}", shoulder, slide));
    ++number;
  };
  drive(0, 0.1);
  drive(0.05, 0.1);
  drive(1.4, 0.1);  // in a tenth of a second, at 1 rad/s
  drive(1.4, 0.1);
  drive(1.7654321, -0.1234567);
  drive(1.4, 0.1);
  for (int i = 0; i < 20; ++i) drive(1.4 - 0.13 * (i < 10 ? i : 20 - i), 0.1);
  EXPECT_EQ(Baseline::of(report()).text(),
            R"({
  "format": 1,
  "accepted": [
    {"rule":"joint.acceleration","subject":"arm","text":"arm/shoulder speeds up or slows down by #/s^#, above #/s^#","worst":1489.69},
    {"rule":"joint.jump","subject":"arm","text":"arm/shoulder jumps by # within # s; its limit is #/s","worst":77.3493},
    {"rule":"joint.limit","subject":"arm","text":"arm/shoulder is outside its limits [#, #]; the worst is #","worst":15.208299999999994},
    {"rule":"joint.limit","subject":"arm","text":"arm/slide is outside its limits [#, #] m; the worst is #","worst":0.123457},
    {"rule":"joint.velocity","subject":"arm","text":"arm/shoulder moves at #/s for # s; its limit is #/s","worst":74.4845}
  ]
}
)");
}

TEST_F(SessionCheckTest, TheDegreesOfABaselineAreThoseSent) {
  say("joints arm 40 20 0.1");
  say("joints arm -50.1234567 20 0.1");
  const CheckReport found = report();
  ASSERT_THAT(rules(found), ElementsAre("joint.degrees"));
  EXPECT_EQ(found.findings[0].worst, 50.1235);
}

TEST_F(SessionCheckTest, APoseAThousandTimesTheCellsIsInMillimetres) {
  const auto judged = [&](std::string_view xyz, std::initializer_list<const char*> poses) {
    std::ofstream(folder_ / "cell.toml") << kCheckedCell
                                         << fmt::format(
                                                "[[device]]\nname = \"box\"\nmodel = \"arm.urdf\"\n"
                                                "optional = true\npose.xyz = {}\n",
                                                xyz);
    Result<Cell> cell = loadCell(folder_ / "cell.toml", {});
    EXPECT_TRUE(cell.ok()) << cell.error().text();
    cell_ = std::move(*cell);
    session_.emplace(cell_);
    say("add box arm.urdf\njoints arm 0 0 0");
    for (const char* pose : poses) say(fmt::format("pose box {}", pose));
    return report();
  };
  const CheckReport found = judged("[0.62, -0.45, 0.05]",
                                   {"620 -451 50 0 0 0 1", "900 -800 50 0 0 0 1", "1 1 0 0 0 0 1"});
  ASSERT_THAT(rules(found), ElementsAre("device.millimetres"));
  EXPECT_EQ(found.findings[0].severity, Severity::warning);
  EXPECT_EQ(found.findings[0].count, 2U) << "the last is in metres";
  EXPECT_EQ(
      found.findings[0].text,
      "packets put device box at (620, -451, 50) m, a thousand times (0.62, -0.45, 0.05), where "
      "the cell has it");
  EXPECT_EQ(found.findings[0].hint, "did you mean metres? these look like millimetres");
  for (const char* far : {"634 -450 50 0 0 0 1", "-620 450 -50 0 0 0 1", "62 -45 5 0 0 0 1",
                          "620 -450 50 0 0 0 1 in arm/base"}) {
    EXPECT_THAT(rules(judged("[0.62, -0.45, 0.05]", {far})), IsEmpty()) << far;
  }
  EXPECT_THAT(rules(judged("[0.62, -0.45, 0.05]", {"1 0 0 0 0 0 1", "620 -450 50 0 0 0 1"})),
              IsEmpty())
      << "a vehicle on a map came past";
  EXPECT_THAT(rules(judged("[0.09, 0, 0]", {"90 0 0 0 0 0 1"})), IsEmpty());
}

TEST_F(SessionCheckTest, NamesUnknownLinksAndLayers) {
  say("joints arm 0 0 0\nshow arm/elbow\nhide layer/cables\nhide arm/hand");
  say("label a in arm/gripper 0 0 0 \"x\"");
  const CheckReport found = report();
  EXPECT_THAT(rules(found),
              ElementsAre("packet.unknown-link", "packet.unknown-link", "packet.unknown-layer"));
  EXPECT_EQ(found.findings[0].text, "device arm has no link elbow");
}

TEST_F(SessionCheckTest, ALayerThatIsNearlyOneIsNamed) {
  std::ofstream(folder_ / "cell.toml")
      << "format = 1\n[[device]]\nname = \"arm\"\nmodel = \"arm.urdf\"\nlayer = \"tanks\"\n";
  Result<Cell> cell = loadCell(folder_ / "cell.toml", {});
  ASSERT_TRUE(cell.ok()) << cell.error().text();
  cell_ = std::move(*cell);
  session_.emplace(cell_);
  say("joints arm 0 0 0\nhide layer/tnks");
  const CheckReport found = report();
  ASSERT_THAT(rules(found), ElementsAre("packet.unknown-layer"));
  EXPECT_EQ(found.findings[0].severity, Severity::warning);
  EXPECT_EQ(found.findings[0].hint, "did you mean `tanks`?");
}

TEST_F(SessionCheckTest, DevicesThatCarryOneAnotherInALoopAreNamedWhenItArises) {
  std::ofstream(folder_ / "cell.toml") << [] {
    std::string text = "format = 1\n";
    for (const char* name : {"arm", "b", "c"}) {
      text += fmt::format("[[device]]\nname = \"{}\"\nmodel = \"arm.urdf\"\n", name);
    }
    return text + "on = \"b/hand\"\n";
  }();
  Result<Cell> cell = loadCell(folder_ / "cell.toml", {});
  ASSERT_TRUE(cell.ok()) << cell.error().text();
  cell_ = std::move(*cell);
  session_.emplace(cell_);
  say("joints arm 0 0 0\njoints b 0 0 0\njoints c 0 0 0");
  say("pose arm 0 0 0 0 0 0 1 in c/hand");
  EXPECT_THAT(rules(report()), IsEmpty()) << "arm on c on b";
  say("pose b 0 0 0 0 0 0 1 in arm/hand");
  CheckReport found = report();
  ASSERT_THAT(rules(found), ElementsAre("packet.carrier-loop"));
  EXPECT_EQ(found.findings[0].text, "devices carry one another in a loop: arm on c on b on arm");
  EXPECT_EQ(found.findings[0].subject, "arm");
  EXPECT_EQ(found.findings[0].count, 1U);
  EXPECT_EQ(found.verdict, CheckVerdict::incompatible);
  // As a standing watch does between its reports.
  session_->dropFindings();
  EXPECT_THAT(rules(report()), IsEmpty());
  say("pose b 0 0 0 0 0 0 1 in arm/hand");
  EXPECT_THAT(rules(report()), ElementsAre("packet.carrier-loop")) << "it is stated again";
  session_->dropFindings();
  say("pose b 0 0 0 0 0 0 1\npose arm 0 0 1 0 0 0 1 in c/hand");
  EXPECT_THAT(rules(report()), IsEmpty()) << "it is over";
  say("pose b 0 0 0 0 0 0 1 in b/hand");
  found = report();
  ASSERT_THAT(rules(found), ElementsAre("packet.carrier-loop"));
  EXPECT_EQ(found.findings[0].text, "devices carry one another in a loop: b on b");
  session_->dropFindings();
  say("pose arm 0 0 1 0 0 0 1 in b/hand");
  EXPECT_THAT(rules(report()), IsEmpty()) << "it only stands on what is in a loop";
}

TEST_F(SessionCheckTest, NamesADeviceThatNobodyDrives) {
  say("pose arm 0 0 0 0 0 0 1");
  const CheckReport found = report();
  ASSERT_THAT(rules(found), ElementsAre("device.undriven")) << "an optional one may stand still";
  EXPECT_EQ(found.findings[0].text, "device arm has 3 joint values, and no source drives it");
  EXPECT_EQ(found.verdict, CheckVerdict::incompatible);
}

TEST_F(SessionCheckTest, NamesTwoSourcesOnTheSameJointsOnly) {
  say("left - -", "joint arm shoulder=1 elbow=0");
  say("right - -", "joint arm slide=0.1");
  say("right - -", "pose arm 0 0 0 0 0 0 1");
  EXPECT_THAT(rules(report()), IsEmpty()) << "they share the work";
  say("right - -", "joint arm shoulder=0.5");
  const CheckReport found = report();
  ASSERT_THAT(rules(found), ElementsAre("packet.two-sources"));
  EXPECT_EQ(found.findings[0].text,
            "the joints of device arm are written by left and by right; the last to write wins");
  EXPECT_EQ(found.findings[0].hint,
            "to take one of a log: rocinante log filter LOG --source left -o OUT");
  EXPECT_EQ(found.verdict, CheckVerdict::compatible);
}

TEST_F(SessionCheckTest, NamesTheTopicOfABagThatOneTakes) {
  say("decoded:ros:joint_states - -", "joint arm shoulder=1 elbow=0 slide=0");
  say("decoded:ros:joint_states_desired - -", "joint arm shoulder=0.9");
  say("decoded:ros:joint_states - -", "joint arm shoulder=1");
  const CheckReport found = report();
  ASSERT_THAT(rules(found), ElementsAre("packet.two-sources"));
  EXPECT_EQ(found.findings[0].hint,
            "to take one of a log: rocinante log filter LOG --source decoded:ros:joint_states -o "
            "OUT; of a bag or table, LOG is made by: rocinante log import FILE --cell CELL -o LOG");
}

TEST_F(SessionCheckTest, NoiseAtALimitIsAllowedByTheCell) {
  say("joints arm 0 0 -0.0002");
  const CheckReport found = report();
  ASSERT_THAT(rules(found), ElementsAre("joint.limit"));
  EXPECT_EQ(
      found.findings[0].hint,
      "if it is the noise of a sensor: [rules] \"joint.limit\" = { \"arm/slide\" = { rad_or_m = "
      "0.0004 } } in a cell");
  std::ofstream(folder_ / "cell.toml")
      << kCheckedCell << "[rules]\n\"joint.limit\" = { \"arm/slide\" = { rad_or_m = 0.0004 } }\n";
  Result<Cell> tolerant = loadCell(folder_ / "cell.toml", {});
  ASSERT_TRUE(tolerant.ok()) << tolerant.error().text();
  ASSERT_THAT(tolerant->faults, IsEmpty());
  cell_ = std::move(*tolerant);
  session_.emplace(cell_);
  say("joints arm 0 0 -0.0002");
  EXPECT_THAT(rules(report()), IsEmpty());
  say("joints arm 0 0 -0.0005");
  EXPECT_THAT(rules(report()), ElementsAre("joint.limit"));
}

TEST_F(SessionCheckTest, AJointMayHaveAThresholdOfItsOwn) {
  const auto judgedWith = [&](std::string_view limit) {
    std::ofstream(folder_ / "cell.toml")
        << kCheckedCell << "[rules]\n\"joint.limit\" = " << limit << "\n";
    Result<Cell> cell = loadCell(folder_ / "cell.toml", {});
    EXPECT_TRUE(cell.ok()) << cell.error().text();
    cell_ = std::move(*cell);
    for (const Finding& fault : cell_.faults) ADD_FAILURE() << fault.print();
    session_.emplace(cell_);
    say("joints arm 1.52 0 0.21");
    std::vector<std::string> texts;
    for (const Finding& finding : report().findings) {
      EXPECT_EQ(finding.rule, "joint.limit") << finding.text;
      texts.push_back(finding.text.substr(0, finding.text.find(' ')));
    }
    return texts;
  };
  EXPECT_THAT(judgedWith("{}"), ElementsAre("arm/shoulder", "arm/slide"));
  EXPECT_THAT(judgedWith("{ \"arm/slide\" = { rad_or_m = 0.02 } }"), ElementsAre("arm/shoulder"));
  EXPECT_THAT(judgedWith("{ \"arm\" = { rad_or_m = 0.03 } }"), IsEmpty());
  EXPECT_THAT(judgedWith("{ \"spare\" = { rad_or_m = 0.03 } }"),
              ElementsAre("arm/shoulder", "arm/slide"));
  EXPECT_THAT(
      judgedWith("{ rad_or_m = 9, \"arm\" = { rad_or_m = 0.03 }, \"arm/slide\" = { rad_or_m = "
                 "0.001 } }"),
      ElementsAre("arm/slide"))
      << "the joint's own outranks its device's, which outranks the rule's";
}

TEST_F(SessionCheckTest, EncodersRestALittleBeyondTheirStops) {
  say("joint arm shoulder=1.50002 slide=-0.00005");
  EXPECT_EQ(std::ranges::count(rules(report()), "joint.limit"), 0);
  say("joint arm shoulder=1.5002");
  EXPECT_EQ(std::ranges::count(rules(report()), "joint.limit"), 1);
}

TEST_F(SessionCheckTest, ASlidingJointInMillimetresIsHinted) {
  say("joint arm slide=150");
  const CheckReport found = report();
  const auto limit = std::ranges::find(found.findings, "joint.limit", &Finding::rule);
  ASSERT_NE(limit, found.findings.end());
  EXPECT_EQ(limit->hint, "are these millimetres? packets give metres");
}

TEST_F(SessionCheckTest, ReportsLossesAndDamageOfTheLog) {
  say("joints arm 0 0 0");
  LossSpan loss;
  loss.endpoint = "udp://127.0.0.1:19960";
  loss.from = now_;
  loss.until = now_ + std::chrono::seconds(1);
  loss.counts.kernel = 3;
  loss.counts.disk = 2;
  session_->addLoss(loss);
  session_->addDamage({100, 200, "chunk 3 fails its checksum", 7});
  const CheckReport found = report();
  ASSERT_THAT(rules(found), ElementsAre("log.damage", "log.loss"));
  EXPECT_EQ(found.findings[1].count, 5U);
  EXPECT_THAT(found.findings[0].text, HasSubstr("(7 messages lost)"));
}

TEST_F(SessionCheckTest, StaysBoundedWhenEveryNameIsNew) {
  say("joints arm 0 0 0");
  for (int i = 0; i < 20000; ++i)
    say(fmt::format("joints d{} 0\nshow arm/l{}\nshow layer/y{}", i, i, i));
  EXPECT_LE(report().findings.size(), 11000U);
  EXPECT_EQ(report().verdict, CheckVerdict::incompatible);
}

TEST_F(SessionCheckTest, ReadsAWholeLogAndTellsTimesFromItsOrigin) {
  const std::filesystem::path path = folder_ / "session.mcap";
  Result<LogWriter> writer = LogWriter::create(path, {}, "0123");
  ASSERT_TRUE(writer.ok()) << writer.error().text();
  const auto channel = writer->addChannel("/udp/1/me", "rk1", {{"source", "me"}});
  for (std::uint32_t i = 0; i < 10; ++i) {
    const std::string text =
        fmt::format("RK1 me@a {} -\njoints arm 0 0 {}\n", i, i == 4 ? "0.5" : "0.1");
    ASSERT_TRUE(
        writer->write(*channel, i, LogTime(std::chrono::seconds(1000 + i)), 0, bytesOf(text)).ok());
  }
  ASSERT_TRUE(writer->close("done").ok());
  Result<LogReader> log = LogReader::open(path);
  ASSERT_TRUE(log.ok()) << log.error().text();
  Result<CheckReport> found = checkLog(cell_, *log);
  ASSERT_TRUE(found.ok()) << found.error().text();
  found->cell = "cell.toml";
  found->session = "session.mcap";
  EXPECT_EQ(checkText(*found),
            "cell.toml and session.mcap: 10 packets of 1 source, over 9.000 s\n"
            "\n"
            "1 error\n"
            "  arm/slide is outside its limits [0, 0.2] m; the worst is 0.5 [joint.limit]\n"
            "    1 time at 4.000 s (packet 5)\n"
            "    such as: joints arm 0 0 0.5\n"
            "\n"
            "incompatible\n");
  const std::string json = checkJson(*found);
  EXPECT_TRUE(json.starts_with("{\n  \"format\": 1,\n  \"verdict\": \"incompatible\",")) << json;
  EXPECT_THAT(json, HasSubstr("\"first_s\": 4.0,"));
}

TEST_F(SessionCheckTest, APieceIsJudgedWithWhatPrecededItAndKeyframesAreNotCounted) {
  SessionState preceding;
  const std::string before = "RK1 me@a 0 -\norder arm slide shoulder\n";
  preceding.apply(now_, *makeDecoder("rk1")->decode(bytesOf(before)));
  const std::filesystem::path path = folder_ / "piece.mcap";
  Result<LogWriter> writer = LogWriter::create(path, {}, "0123");
  ASSERT_TRUE(writer.ok()) << writer.error().text();
  KeyframeOptions keyframes;
  keyframes.packets = 20;
  SessionWriter piece(std::move(*writer), keyframes);
  ASSERT_TRUE(piece.beginWith(preceding, now_).ok());
  const auto channel = piece.addChannel("/udp/1/me", "rk1", {});
  for (std::uint32_t i = 0; i < 50; ++i) {
    // Two of three joints: only the earlier order makes that correct.
    const std::string text = fmt::format("RK1 me@a {} -\njoints arm 0.1 1\n", i + 1);
    ASSERT_TRUE(piece.write(*channel, i, now_, 0, bytesOf(text)).ok());
  }
  EXPECT_GE(piece.keyframes(), 2U);
  ASSERT_TRUE(piece.log().close("done").ok());
  Result<LogReader> log = LogReader::open(path);
  ASSERT_TRUE(log.ok()) << log.error().text();
  const Result<CheckReport> found = checkLog(cell_, *log);
  ASSERT_TRUE(found.ok()) << found.error().text();
  EXPECT_THAT(rules(*found), ElementsAre("joint.undriven")) << "the elbow, which no order names";
  EXPECT_EQ(found->packets, 50U);
  EXPECT_EQ(found->verdict, CheckVerdict::compatible);
}

TEST_F(SessionCheckTest, JudgesTheCellAlone) {
  EXPECT_EQ(checkCell(cell_).verdict, CheckVerdict::compatible);
  std::ofstream(folder_ / "bad.cell.toml")
      << "format = 1\n[[device]]\nname = \"arm\"\nmodel = \"gone.urdf\"\n";
  const Result<Cell> bad = loadCell(folder_ / "bad.cell.toml", {});
  ASSERT_TRUE(bad.ok()) << bad.error().text();
  const CheckReport found = checkCell(*bad);
  EXPECT_EQ(found.verdict, CheckVerdict::incompatible);
  EXPECT_GT(found.findings[0].line, 0);
}

}  // namespace
}  // namespace rocinante
