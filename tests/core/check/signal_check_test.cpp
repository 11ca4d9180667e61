// What a check says of signals beyond the examples of docs/rules/signal.md: what it did not judge.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/packet/packet_limits.h"
#include "tests/core/check/session_check_test.h"

namespace rocinante {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class SignalCheckTest : public test::SessionCheckTest {
 protected:
  /// The cell expects these; then the arm stands.
  void expects(std::string_view signals) {
    std::ofstream(folder_ / "cell.toml") << test::kCheckedCell << signals;
    Result<Cell> cell = loadCell(folder_ / "cell.toml", {});
    ASSERT_TRUE(cell.ok()) << cell.error().text();
    cell_ = std::move(*cell);
    for (const Finding& fault : cell_.faults) ADD_FAILURE() << fault.print();
    session_.emplace(cell_);
    say("joints arm 0 0 0");
  }
};

constexpr std::string_view kLoad = R"([[signal]]
path = "arm"
name = "load"
unit = "kg"
range = [0, 10]
jump = 5
)";

TEST_F(SignalCheckTest, ANumberAmongValuesIsMeantAsItIsWritten) {
  expects(
      "[[signal]]\npath = \"-\"\nname = \"estop\"\nvalues = [\"false\"]\n"
      "[[signal]]\npath = \"arm\"\nname = \"tool\"\nvalues = [\"5\", \"7\"]\n"
      "transitions = [\"5 -> 7\"]\n");
  say("signal - estop 1\nsignal arm tool 5");
  say("signal arm tool 7");
  EXPECT_THAT(rules(report()), ElementsAre("signal.unknown-value"));
  say("signal arm tool 5");
  say("signal arm tool 99");
  const CheckReport found = report();
  EXPECT_THAT(rules(found), ElementsAre("signal.unknown-value", "signal.transition",
                                        "signal.transition", "signal.unknown-value"));
  EXPECT_THAT(found.findings[0].text, HasSubstr("estop is `1`"));
}

TEST_F(SignalCheckTest, ATextWhereANumberIsExpectedIsNamed) {
  expects(kLoad);
  say("signal arm load \"nan\"");
  const CheckReport found = report();
  ASSERT_THAT(rules(found), ElementsAre("signal.kind"));
  EXPECT_THAT(found.findings[0].text, HasSubstr("is `nan`, where the cell expects a number"));
}

TEST_F(SignalCheckTest, AUnitThatIsNoneIsNamedAsThatWithTheOneThatIsMeant) {
  say("joints arm 0 0 0");
  say("signal - temperature 25 \u00B0C");
  say("signal - torque 2 N\u00B7m");
  say("signal arm mode \"auto");
  const CheckReport found = report();
  ASSERT_THAT(rules(found), ElementsAre("packet.bad-string", "packet.bad-string"));
  EXPECT_THAT(found.findings[1].text, HasSubstr("malformed string"));
  EXPECT_THAT(found.findings[0].text, HasSubstr("malformed unit; the first at column 25"));
  EXPECT_EQ(found.findings[0].count, 2U);
  EXPECT_EQ(found.findings[0].hint, "did you mean `degC`?");
}

TEST_F(SignalCheckTest, AFieldThatIsNotFiniteIsNamedWithItsTime) {
  say("joints arm 0 0 0");
  const LogTime first = now_ + std::chrono::milliseconds(1);
  for (const char* const field : {"q1", "force", "force"}) {
    now_ += std::chrono::milliseconds(1);
    session_->addNotFinite(now_, {"decoded:drive", field});
    session_->addOctets(now_, "octets", true);
  }
  const CheckReport found = report();
  ASSERT_THAT(rules(found), ElementsAre("source.not-finite", "source.not-finite"));
  const Finding& force = found.findings[found.findings[0].count == 2 ? 0 : 1];
  EXPECT_EQ(force.subject, "decoded:drive");
  EXPECT_THAT(force.text, HasSubstr("field force of decoded:drive"));
  EXPECT_EQ(force.first, first + std::chrono::milliseconds(1));
  EXPECT_EQ(force.packet, 3U);
  session_->dropFindings();
  EXPECT_THAT(rules(report()), IsEmpty());
}

TEST_F(SignalCheckTest, ATextMayStandInPlaceOfANumber) {
  expects(fmt::format("{}values = [\"none\"]\n", kLoad));
  say("signal arm load 5");
  say("signal arm load \"none\"");
  EXPECT_THAT(rules(report()), ElementsAre("signal.kind"));  // of both kinds, and no more
  say("signal arm load 11");
  EXPECT_THAT(rules(report()), ElementsAre("signal.range", "signal.kind"));
}

TEST_F(SignalCheckTest, NumbersInAnotherUnitAreNamedAndNotJudged) {
  expects(kLoad);
  say("signal arm load 1 N");
  say("signals arm load=99");  // still newtons
  CheckReport found = report();
  ASSERT_THAT(rules(found), ElementsAre("signal.unit"));
  EXPECT_THAT(found.findings[0].text,
              HasSubstr("signal arm load is stated in N, never in kg, which the cell expects; none "
                        "of its numbers is judged"));
  // What was in the unit stays known when the signal has no value any more.
  say("signal arm load 99 kg");
  say("signal arm load default");
  say("signal arm load 1 N");
  found = report();
  EXPECT_THAT(rules(found), ::testing::Contains("signal.range"));
  EXPECT_THAT(found.findings, ::testing::Contains(::testing::Field(
                                  &Finding::text, HasSubstr("is in kg, and in N; the numbers in "
                                                            "another unit are not judged"))));
}

TEST_F(SignalCheckTest, TwoSourcesOfOneSignalAreFound) {
  expects(kLoad);
  say("plc@a 0 -", "signal arm load 1");
  say("plc@a 1 -", "signal arm load 2");
  EXPECT_THAT(rules(report()), IsEmpty());
  say("other@a 0 -", "signal arm load 9");
  const CheckReport found = report();
  ASSERT_THAT(rules(found), ElementsAre("packet.two-sources"));
  EXPECT_EQ(found.findings[0].text,
            "signal arm load is written by plc and by other; the last to write wins");
  // Once it is said of the signal that it has no value, anybody may begin.
  session_->dropFindings();
  say("other@a 1 -", "signal arm load default");
  say("plc@a 2 -", "signal arm load 3");
  EXPECT_THAT(rules(report()), IsEmpty());
}

TEST_F(SignalCheckTest, ASignalThatAnEarlierEntryTakesIsSaid) {
  expects(
      "[[signal]]\npath = \"arm\"\nname = \"*.effort\"\n"
      "[[signal]]\npath = \"arm\"\nname = \"elbow.effort\"\nrange = [-1, 1]\n");
  say("signal arm elbow.effort 900");
  const CheckReport found = report();
  ASSERT_THAT(rules(found), ElementsAre("signal.missing"));
  EXPECT_THAT(found.findings[0].text, HasSubstr("an earlier [[signal]]"));
}

TEST_F(SignalCheckTest, SignalsBeyondTheStatesLimitAreSaid) {
  expects("[[signal]]\npath = \"-\"\nname = \"estop\"\nvalues = [\"false\"]\n");
  for (std::size_t i = 0; i < limits::kSignals; i += 1'024) {
    std::string names = "signals arm";
    for (std::size_t k = 0; k < 1'024; ++k) names += fmt::format(" n{}=0", i + k);
    say(names);
  }
  say("signal - estop true");
  const CheckReport found = report();
  ASSERT_THAT(rules(found), ElementsAre("packet.too-many"));
  EXPECT_THAT(found.findings[0].text, HasSubstr("65536"));
  // What a device had is forgotten with it.
  say("remove arm");
  session_->dropFindings();
  say("signal - estop true");
  EXPECT_THAT(rules(report()), ::testing::Contains("signal.unknown-value"));
}

}  // namespace
}  // namespace rocinante
