// Whatever is inserted into a session, or taken out of it, changes its judgement or the account in
// it.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "core/behaviour/run_coverage.h"
#include "tests/core/behaviour/run_test.h"

namespace rocinante {
namespace {

using test::cellAt;
using test::kDemo;
using test::SaidSession;

/// All that a report can show of it.
std::string everythingOf(const RunJudgement& judged) {
  std::string text = test::textOfFindings(judged);
  for (const std::string& note : judged.notes) text += note + "\n";
  for (const std::string& item : judged.coverage.judged) text += item + " is judged\n";
  return text + accountSentence(judged.coverage.left_out, 100);
}

void forEachLine(const std::string& body, const std::function<void(const std::string&)>& take) {
  std::istringstream lines(body);
  for (std::string line; std::getline(lines, line);) take(line);
}

/// What belongs together: an event, or everything of one kind about one thing.
std::string kindOf(const std::string& line) {
  std::istringstream words(line);
  std::string verb, name;
  words >> verb >> name;
  return verb == "event" ? line : (verb == "joint" ? "joints" : verb) + " " + name;
}

/// With a load that sways, a mode and a switch.
SaidSession withSignals(SaidSession session) {
  bool is_first = true;
  for (auto& said : session.packets) {
    if (said.source != "arm") continue;
    const double load = 2 + std::sin(said.at_s);
    said.body += fmt::format("signals arm load={:.6f}\n", load);
    // What a whole restatement does not say is forgotten.
    const bool is_restated = said.header.find("restated") != std::string::npos;
    if (!std::exchange(is_first, false) && !is_restated) continue;
    said.body += fmt::format("signal arm load {:.6f} kg\n", load) +
                 "signal - mode \"auto\"\nsignals arm/link3 on=true\n";
  }
  EXPECT_FALSE(is_first);
  return session;
}

class RunMutations : public test::RunTest {
 protected:
  RunMutations() : accepted_(trackOf(cell_, session_)) { whole_ = judged(session_); }

  std::string judged(const SaidSession& session) {
    const auto run = trackOf(cell_, session);
    EXPECT_TRUE(run.ok() && accepted_.ok());
    return run.ok() ? everythingOf(judgeRun({}, {&*accepted_}, *run)) : run.error().text();
  }

  const Cell cell_ = cellAt(kDemo / "demo.cell.toml");
  const SaidSession session_ = withSignals(SaidSession::read(kDemo / "session.mcap"));
  const Result<SessionTrack> accepted_;
  std::string whole_;
};

TEST_F(RunMutations, AStatementTooManyIsFoundOrNamed) {
  std::mt19937 random(1996);
  for (const char* statement : {"joints nowhere 1 2",
                                "joint arm elbow=1",
                                "joint arm joint1=2",
                                "joints arm 1 2",
                                "joints arm nan",
                                "pose nowhere 0 0 1 0 0 0 1",
                                "pose arm 0 0 1 0 0 0 1",
                                "pose arm 0 0 1 0 0 0 0",
                                "add arm nothing",
                                "remove gantry",
                                "hide arm/link3",
                                "hide arm/elbow",
                                "color arm/link2 #00ff00",
                                "color arm/elbow #00ff00",
                                "colour arm/link2 #00ff00",
                                "line path #ff0000 0 0 0 1 1 1",
                                "points cloud #ff0000 0 0 0",
                                "label note 0 0 1 \"x\"",
                                "event \"inserted\"",
                                "wobble arm",
                                "signal arm load 90 kg",
                                "signals arm load=90",
                                "signals arm load=-90",
                                "signal arm load 2 N",
                                "signal arm load default",
                                "signal arm load \"none\"",
                                "signals arm load=nan",
                                "signal - mode \"fault\"",
                                "signal - mode default",
                                "signals arm/link3 on=false",
                                "signal arm fresh 1 V",
                                "signal nowhere speed 3",
                                "signals arm loed=1",
                                "order arm joint1 joint2\njoints arm 1 2"}) {
    for (int i = 0; i < 3; ++i) {
      SaidSession changed = session_;
      auto& said = changed.packets[random() % changed.packets.size()];
      said.body += std::string(statement) + "\n";
      EXPECT_NE(judged(changed), whole_) << statement << " at " << said.at_s << " s";
    }
  }
}

TEST_F(RunMutations, ADatagramThatIsNoPacketIsNamed) {
  SaidSession changed = session_;
  changed.packets.push_back({5, "arm", "RK9 arm 0 -", "joints arm 1 2 3 4 5 6\n"});
  EXPECT_NE(judged(changed), whole_);
}

TEST_F(RunMutations, WhatIsTakenOutIsFound) {
  std::map<std::string, int> kinds;
  for (const auto& said : session_.packets) {
    forEachLine(said.body, [&](const std::string& line) { ++kinds[kindOf(line)]; });
  }
  // Values without their order are the same ones here, and a view is none of the machine's.
  std::erase_if(kinds, [](const auto& kind) {
    return kind.first.starts_with("order ") || kind.first.starts_with("view ");
  });
  ASSERT_GE(kinds.size(), 6U);
  for (const auto& said_kind : kinds) {
    const std::string& kind = said_kind.first;
    SaidSession changed = session_;
    for (auto& said : changed.packets) {
      std::string body;
      forEachLine(said.body, [&](const std::string& line) {
        if (kindOf(line) != kind) body += line + "\n";
      });
      said.body = body;
    }
    EXPECT_NE(judged(changed), whole_) << kind << ", " << said_kind.second << " times";
  }
}

}  // namespace
}  // namespace rocinante
