// Small faults in a valid cell and session, one at a time: the intended rule finds each, and no
// other fires.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "core/check/rules/rule_list.h"
#include "tests/core/check/sound_session.h"

namespace rocinante {
namespace {

using test::SaidPacket;
using test::SoundSession;

std::set<std::string> rulesOf(const CheckReport& report) {
  std::set<std::string> rules;
  for (const Finding& finding : report.findings) rules.insert(finding.rule);
  return rules;
}

std::string texts(const CheckReport& report) {
  std::string all;
  for (const Finding& f : report.findings) {
    all += fmt::format("  [{}] {} (such as: {}; {} times)\n", f.rule, f.text, f.example, f.count);
  }
  return all;
}

/// `joints DEVICE ...` with each value changed.
void changeJoints(SaidPacket& packet, const std::function<double(double, std::size_t)>& change) {
  for (std::string& statement : packet.statements) {
    if (!statement.starts_with("joints ")) continue;
    const std::size_t name_end = statement.find(' ', 7);
    std::string changed = statement.substr(0, name_end);
    std::size_t joint = 0;
    for (std::size_t at = name_end; at != std::string::npos; at = statement.find(' ', at + 1)) {
      changed += fmt::format(" {:.6f}", change(std::stod(statement.substr(at)), joint++));
    }
    statement = changed;
  }
}

void changeTimes(SoundSession& session, std::string_view source, double from_s,
                 double (*change)(double since_start_s)) {
  for (SaidPacket& packet : session.packets) {
    if (packet.source != source || packet.arrives_s < from_s) continue;
    const double seconds = std::stod(packet.time.substr(4)) + 1'770'000'000 - 1'770'000'000;
    packet.time = fmt::format("{:.6f}", 1'770'000'000 + change(seconds));
  }
}

struct Mutation {
  const char* what;
  const char* rule;
  void (*apply)(SoundSession& s);
};

constexpr const char* kLeft = "left_control";
constexpr const char* kRight = "right_control";

const Mutation kMutations[] = {
    // The cell and its models.
    {"a device renamed in the cell", "packet.unknown-device",
     [](SoundSession& s) {
       // Optional, so that the new name does not fire device.undriven.
       s.replace(s.cell, "name = \"part\"\n", "name = \"piece\"\n");
       s.replace(s.cell, "[\"part\", ", "[\"piece\", ");
       for (SaidPacket* p : s.of("planner"))
         std::erase_if(p->statements, [](auto& l) { return l.starts_with("add"); });
       for (SaidPacket* p : s.of("planner", 0, 100, true))
         s.replace(p->statements[0], "add part part.urdf\n", "");
     }},
    {"a joint renamed in the model", "packet.unknown-joint",
     [](SoundSession& s) { s.replace(s.urdf, "\"wrist\"", "\"roll\""); }},
    {"a joint welded in the model", "packet.undrivable-joint",
     [](SoundSession& s) {
       s.replace(s.urdf, "\"wrist\" type=\"continuous\"", "\"wrist\" type=\"fixed\"");
     }},
    {"a link renamed in the model", "packet.unknown-link",
     [](SoundSession& s) { s.replace(s.urdf, "\"hand\"", "\"tool\""); }},
    {"a limit halved", "joint.limit",
     [](SoundSession& s) { s.replace(s.urdf, "upper=\"2\"", "upper=\"0.8\""); }},
    {"a velocity limit halved", "joint.velocity",
     [](SoundSession& s) {
       s.replace(s.urdf, "upper=\"2\" effort=\"1\" velocity=\"2\"",
                 "upper=\"2\" effort=\"1\" velocity=\"0.5\"");
     }},
    {"a device that its source does not know", "device.undriven",
     [](SoundSession& s) { s.cell += "[[device]]\nname = \"third\"\nmodel = \"arm.urdf\"\n"; }},
    {"an unknown key", "cell.unknown-key",
     [](SoundSession& s) { s.replace(s.cell, "eye = ", "colour = 1\neye = "); }},
    {"a misspelt rule", "cell.unknown-rule",
     [](SoundSession& s) { s.cell += "[rules]\n\"joint.limits\" = \"off\"\n"; }},
    {"a misspelt severity", "cell.unknown-word",
     [](SoundSession& s) { s.cell += "[rules]\n\"joint.limit\" = \"warn\"\n"; }},
    {"a threshold in another unit", "cell.rule-threshold",
     [](SoundSession& s) { s.cell += "[rules]\n\"source.jitter\" = { s = 1 }\n"; }},
    {"a threshold below zero", "cell.bad-number",
     [](SoundSession& s) { s.cell += "silence_s = -1\n"; }},
    {"a device twice", "cell.duplicate-name",
     [](SoundSession& s) {
       s.cell += "[[camera]]\nname = \"overview\"\neye = [1, 1, 1]\ntarget = [0, 0, 0]\n";
     }},
    {"a camera that looks nowhere", "cell.no-direction",
     [](SoundSession& s) { s.replace(s.cell, "target = [0, 0, 0.5]", "target = [4, -4, 3]"); }},
    {"a source that nobody is", "source.missing",
     [](SoundSession& s) {
       s.cell += "[[source]]\nname = \"gripper\"\ndevices = [\"part\"]\n";
       s.replace(s.cell, "devices = [\"part\", \"drone\"]", "devices = [\"drone\", \"part\"]");
     }},
    {"a mesh that is not there", "model.missing-file",
     [](SoundSession& s) { s.replace(s.urdf, "upper.obj", "uper.obj"); }},
    {"a face to a point that is not there", "obj.bad-index",
     [](SoundSession& s) { s.obj += "f 1 2 9\n"; }},
    {"a comma in a number of a mesh", "obj.bad-number",
     [](SoundSession& s) { s.obj += "v 1,5 0 0\n"; }},
    {"a limit the wrong way round", "urdf.limit-order",
     [](SoundSession& s) {
       s.replace(s.urdf, "lower=\"0\" upper=\"0.05\" effort=\"1\" velocity=\"0.2\"/> </joint>",
                 "lower=\"0.05\" upper=\"0\" effort=\"1\" velocity=\"0.2\"/> </joint>");
     }},
    {"an axis of no direction", "urdf.zero-axis",
     [](SoundSession& s) { s.replace(s.urdf, "xyz=\"0 0 1\"", "xyz=\"0 0 0\""); }},
    {"an attribute forgotten", "urdf.missing-limit-attribute",
     [](SoundSession& s) {
       s.replace(s.urdf, "lower=\"-1.5\" upper=\"1.5\" effort=\"1\"",
                 "lower=\"-1.5\" upper=\"1.5\"");
     }},

    // The contents of packets.
    {"a stale device name", "packet.unknown-device",
     [](SoundSession& s) { s.say("planner", 3, "pose old_part 0 0 0 0 0 0 1"); }},
    {"a stale link name", "packet.unknown-link",
     [](SoundSession& s) { s.say("planner", 3, "hide left/gripper"); }},
    {"a stale layer", "packet.unknown-layer",
     [](SoundSession& s) { s.say("planner", 3, "hide layer/robot"); }},
    {"a stale model name", "packet.unknown-model",
     [](SoundSession& s) { s.say("planner", 3, "add part part_v2"); }},
    {"another version of the model", "packet.other-kinematics",
     [](SoundSession& s) { s.say(kLeft, 3, "add left arm.urdf kin=0123456789abcdef"); }},
    {"a joint dropped from the values", "packet.joint-count",
     [](SoundSession& s) {
       std::string& j = s.of(kLeft, 3).at(0)->statements.at(0);
       j.resize(j.rfind(' '));
     }},
    {"a joint too many", "packet.joint-count",
     [](SoundSession& s) { s.of(kLeft, 3).at(0)->statements.at(0) += " 0"; }},
    {"a joint dropped from order and values", "joint.undriven",
     [](SoundSession& s) {
       s.replaceSaid(kLeft, " wrist grip", " wrist");
       for (SaidPacket& p : s.packets) {
         if (p.source != kLeft) continue;
         p.statements.back().resize(p.statements.back().rfind(' '));
       }
     }},
    {"two joints swapped for a while", "joint.jump",
     [](SoundSession& s) {
       s.replaceSaid(kLeft, "shoulder elbow wrist", "elbow shoulder wrist", 6, 8.5);
     }},
    {"a name twice in an order", "packet.repeated-joint",
     [](SoundSession& s) { s.say("planner", 3, "joint drone fly.x=1.5 fly.x=1.5"); }},
    {"a misspelt joint", "packet.unknown-joint",
     [](SoundSession& s) { s.say(kLeft, 3, "joint left ellbow=0"); }},
    {"a value for a joint that mimics", "packet.undrivable-joint",
     [](SoundSession& s) { s.say(kLeft, 3, "joint left other_grip=0.01"); }},
    {"degrees for radians", "joint.degrees",
     [](SoundSession& s) {
       for (SaidPacket& p : s.packets)
         if (p.source == kLeft)
           changeJoints(p, [](double v, std::size_t i) { return i < 3 ? v * 57.29578 : v; });
     }},
    {"millimetres for metres", "joint.limit",
     [](SoundSession& s) {
       for (SaidPacket& p : s.packets)
         if (p.source == kLeft)
           changeJoints(p, [](double v, std::size_t i) { return i == 3 ? v * 1000 : v; });
     }},
    {"one value beyond its limit", "joint.limit",
     [](SoundSession& s) { s.say(kLeft, 3, "joint left elbow=1.6"); }},
    {"a motion at twice the speed it may have", "joint.velocity",
     [](SoundSession& s) {
       for (SaidPacket* p : s.of(kLeft, 5, 6.5)) {
         const double out = 2.2 * std::min(p->arrives_s - 5, 0.45);
         const double back = std::max(p->arrives_s - 5.45, 0.0);
         changeJoints(*p, [&](double v, std::size_t i) {
           return i == 0 ? v - std::max(out - back, 0.0) : v;
         });
       }
     }},
    {"a value that leaps and comes back", "joint.jump",
     [](SoundSession& s) {
       for (SaidPacket* p : s.of(kLeft, 5, 5.05))
         changeJoints(*p, [](double v, std::size_t i) { return i == 1 ? v + 0.9 : v; });
     }},
    {"a robot that speeds up too much", "joint.acceleration",
     [](SoundSession& s) { s.cell += "[rules]\n\"joint.acceleration\" = { per_s2 = 0.4 }\n"; }},
    {"nan", "packet.not-finite", [](SoundSession& s) { s.say(kLeft, 3, "joint left elbow=nan"); }},
    {"infinity", "packet.not-finite",
     [](SoundSession& s) { s.say(kLeft, 3, "joints left 0 -inf 0 0"); }},
    {"a decimal comma", "packet.bad-number",
     [](SoundSession& s) { s.say(kLeft, 3, "joint left elbow=0,5"); }},
    {"a quaternion that is not normalised", "packet.unnormalised-quaternion",
     [](SoundSession& s) { s.say("planner", 3, "pose part 0 0 0 0 0 0 1.01"); }},
    {"a quaternion of zeros", "packet.zero-quaternion",
     [](SoundSession& s) { s.say("planner", 3, "pose part 0 0 0 0 0 0 0"); }},
    {"the quaternion of a floating joint not normalised", "joint.unnormalised",
     [](SoundSession& s) {
       changeJoints(*s.of("planner", 3).at(0),
                    [](double v, std::size_t i) { return i > 2 ? v * 1.1 : v; });
     }},
    {"a part moved before it is added", "packet.before-add",
     [](SoundSession& s) {
       SaidPacket& p = *s.of("planner").at(0);
       p.statements.insert(p.statements.begin(), "pose part 0 0 0 0 0 0 1");
     }},
    {"a part moved after it is removed", "packet.after-remove",
     [](SoundSession& s) {
       s.say("planner", 13, "remove part");
       s.say("planner", 13.3, "pose part 0 0 0 0 0 0 1");
       for (SaidPacket* p : s.of("planner", 13, 100, true)) p->statements.clear();
     }},
    {"a part that is never added", "device.unadded",
     [](SoundSession& s) { s.replaceSaid("planner", "add part part.urdf\n", ""); }},
    {"a line without its end", "packet.missing-field",
     [](SoundSession& s) { s.say(kLeft, 3, "pose left 0 0 0"); }},
    {"a line with more than its end", "packet.extra-field",
     [](SoundSession& s) { s.say("planner", 3, "remove old now"); }},
    {"a colour by name", "packet.bad-color",
     [](SoundSession& s) { s.say("planner", 3, "color part red"); }},
    {"a string that is not closed", "packet.bad-string",
     [](SoundSession& s) { s.say("planner", 3, "event \"done"); }},
    {"a statement of another version", "packet.unknown-statement",
     [](SoundSession& s) { s.say("planner", 3, "torque left 1 2 3"); }},
    {"a header without a number", "packet.bad-header",
     [](SoundSession& s) {
       SaidPacket p = *s.of(kLeft, 3).at(0);
       p.arrives_s += 0.001;
       p.sequence = "x";
       s.insert(p);
     }},
    {"packets of another protocol", "packet.unknown-protocol",
     [](SoundSession& s) {
       SaidPacket p = *s.of(kLeft, 3).at(0);
       p.encoding = "octets";
       p.arrives_s += 0.001;
       s.insert(p);
     }},

    // The senders and their timing.
    {"a second source that drives a robot", "source.unlisted-device",
     [](SoundSession& s) {
       for (SaidPacket* p : s.of(kRight, 4, 6))
         p->statements.push_back(s.of(kLeft, p->arrives_s - 0.02).at(0)->statements.back());
     }},
    {"two sources that may both write a robot", "packet.two-sources",
     [](SoundSession& s) {
       s.replace(s.cell, "devices = [\"right\"]", "devices = [\"right\", \"left\"]");
       s.say(kRight, 3, "joint left grip=0.0278");
     }},
    {"a source renamed", "source.missing",
     [](SoundSession& s) {
       for (SaidPacket& p : s.packets)
         if (p.source == kLeft) p.source = "left_ctl";
     }},
    {"a source that is dead", "device.undriven", [](SoundSession& s) { s.erase(kLeft, 0, 100); }},
    {"packets that are lost", "source.gap", [](SoundSession& s) { s.erase(kLeft, 5.01, 5.3); }},
    {"a packet that comes twice", "source.duplicate",
     [](SoundSession& s) {
       SaidPacket p = *s.of(kLeft, 5).at(0);
       p.arrives_s += 0.001;
       s.insert(p);
     }},
    {"packets in another order", "source.late",
     [](SoundSession& s) {
       s.of(kLeft, 5).at(0)->arrives_s += 0.05;
       s.sort();
     }},
    {"a program started again", "source.restart",
     [](SoundSession& s) {
       int n = 0;
       for (SaidPacket& p : s.packets)
         if (p.source == kLeft && p.arrives_s > 7) {
           p.run = "b";
           p.sequence = std::to_string(n++);
         }
     }},
    {"packets lost behind a relay", "source.relay-gap",
     [](SoundSession& s) {
       int n = 0;
       for (SaidPacket& p : s.packets)
         if (p.source == kLeft) {
           n += p.arrives_s > 5 && p.arrives_s < 5.05 ? 4 : 1;
           p.words += fmt::format(" via=hub:{}", n);
         }
     }},
    {"a source heard whole and filtered", "source.mixed",
     [](SoundSession& s) {
       int n = 0;
       for (SaidPacket& p : s.packets)
         if (p.source == kLeft && p.arrives_s > 5) p.words += fmt::format(" via=hub:slow:{}", n++);
     }},
    {"a clock an hour off", "source.clock-skew",
     [](SoundSession& s) { changeTimes(s, kLeft, 0, [](double t) { return t + 3600; }); }},
    {"a clock that is set while it runs", "source.clock-step",
     [](SoundSession& s) { changeTimes(s, kLeft, 6, [](double t) { return t + 30; }); }},
    {"a clock that goes back", "source.clock-step",
     [](SoundSession& s) { changeTimes(s, kLeft, 6, [](double t) { return t - 2; }); }},
    {"a clock that runs one percent fast", "source.clock-drift",
     [](SoundSession& s) { changeTimes(s, kLeft, 0, [](double t) { return t * 1.01; }); }},
    {"every other packet left out", "source.rate",
     [](SoundSession& s) {
       int n = 0, sequence = 0;
       std::erase_if(s.packets, [&](const SaidPacket& p) {
         return p.source == kLeft && p.words.empty() && ++n % 2 == 0;
       });
       for (SaidPacket& p : s.packets)
         if (p.source == kLeft) p.sequence = std::to_string(sequence++);
     }},
    {"twice the rate that the cell knows", "source.rate",
     [](SoundSession& s) {
       s.replace(s.cell, "rate_hz = [20, 30]\ndevices = [\"left\"]",
                 "rate_hz = [10, 12]\ndevices = [\"left\"]");
     }},
    {"packets that come in bunches", "source.jitter",
     [](SoundSession& s) {
       for (SaidPacket& p : s.packets)
         if (p.source == kLeft)
           p.arrives_s = 0.2 * static_cast<double>(static_cast<int>(p.arrives_s / 0.2) + 1) +
                         p.arrives_s * 1e-4;
       s.sort();
     }},
    {"a source that falls silent", "source.silence",
     [](SoundSession& s) {
       s.replace(s.cell, "devices = [\"left\"]", "devices = [\"left\"]\nsilence_s = 1");
       s.erase(kLeft, 12.02, 100);
     }},
    {"a source that dies while the others go on", "source.silence",
     [](SoundSession& s) { s.erase(kLeft, 12.02, 100); }},
    {"nothing said again", "source.unrestated",
     [](SoundSession& s) {
       std::erase_if(s.packets,
                     [](const SaidPacket& p) { return p.source == kLeft && !p.words.empty(); });
       int sequence = 0;
       for (SaidPacket& p : s.packets)
         if (p.source == kLeft) p.sequence = std::to_string(sequence++);
     }},
};

/// Everyday events in valid sessions that are not faults.
const Mutation kHarmless[] = {
    {"the recording begins in the middle", "",
     [](SoundSession& s) {
       std::erase_if(s.packets, [](const SaidPacket& p) { return p.arrives_s < 3.3; });
     }},
    {"no TIME", "",
     [](SoundSession& s) {
       for (SaidPacket& p : s.packets) p.time = "-";
     }},
    {"no SEQUENCE", "",
     [](SoundSession& s) {
       for (SaidPacket& p : s.packets) p.sequence = "-";
     }},
    {"a simulation's own TIME", "",
     [](SoundSession& s) {
       for (SaidPacket& p : s.packets) p.time = p.time.substr(4);
     }},
    {"packets delayed by up to a fifth of a second, without TIME", "",
     [](SoundSession& s) {
       s.replace(s.cell, "rate_hz = [20, 30]", "rate_hz = [20, 30]\njitter_ms = 250");
       double until_s = 0;
       for (SaidPacket& p : s.packets) {
         p.time = "-";
         // A queue that is stopped now and then, and then releases everything at once.
         const double phase_s = std::fmod(p.arrives_s, 1.7);
         if (phase_s < 0.2) p.arrives_s += 0.2 - phase_s;
         p.arrives_s = until_s = std::max(until_s, p.arrives_s);
       }
     }},
    {"a first packet that is late by a second", "",
     [](SoundSession& s) {
       for (const char* source : {kLeft, kRight}) {
         for (SaidPacket* p : s.of(source, 0, 0.8)) p->arrives_s = 0.8;
       }
       s.sort();
     }},
    {"a pause of half a second", "",
     [](SoundSession& s) {
       for (SaidPacket& p : s.packets) {
         if (p.arrives_s < 6.01) continue;
         p.arrives_s += 0.5;
         p.time = fmt::format("{:.6f}", std::stod(p.time) + 0.5);
       }
     }},
    {"a clock that is a third of a second behind", "",
     [](SoundSession& s) { changeTimes(s, kLeft, 0, [](double t) { return t - 0.3; }); }},
    {"a clock that drifts by a hundred parts in a million", "",
     [](SoundSession& s) { changeTimes(s, kLeft, 0, [](double t) { return t * 1.0001; }); }},
    {"a relay that says it all again for a late joiner", "",
     [](SoundSession& s) {
       std::vector<SaidPacket> again;
       for (const SaidPacket* p : s.of(kLeft, 4, 4.5)) again.push_back(*p);
       for (SaidPacket& p : again) {
         p.words += " by=hub";
         p.arrives_s += 0.001;
         s.packets.push_back(p);
       }
     }},
    {"limits and speeds used to the full", "",
     [](SoundSession& s) {
       s.replace(s.urdf, "upper=\"2\" effort=\"1\" velocity=\"2\"",
                 "upper=\"1\" effort=\"1\" velocity=\"0.7\"");
     }},
};

TEST(Mutations, WhatIsNoFaultFiresNothing) {
  for (const Mutation& harmless : kHarmless) {
    SCOPED_TRACE(harmless.what);
    SoundSession session;
    harmless.apply(session);
    session.sort();
    const CheckReport report = session.judge();
    EXPECT_TRUE(report.findings.empty()) << texts(report);
  }
}

TEST(Mutations, TheSoundSessionIsSound) {
  const SoundSession sound;
  const CheckReport report = sound.judge();
  EXPECT_TRUE(report.findings.empty()) << texts(report);
  EXPECT_EQ(report.verdict, CheckVerdict::compatible);
  EXPECT_GT(report.packets, 700U);
}

TEST(Mutations, EachIsFoundByTheRuleMeantForItAndNothingElseFires) {
  EXPECT_GE(std::size(kMutations), 60U);
  for (const Mutation& mutation : kMutations) {
    SCOPED_TRACE(mutation.what);
    SoundSession session;
    mutation.apply(session);
    const CheckReport report = session.judge();
    EXPECT_EQ(rulesOf(report), std::set<std::string>{mutation.rule}) << texts(report);
    for (const Finding& finding : report.findings) {
      EXPECT_EQ(finding.severity, findRule(finding.rule)->severity) << finding.rule;
    }
  }
}

TEST(Mutations, ARuleThatIsOffFindsNothingAndOneThatIsRaisedDecides) {
  for (const Mutation& mutation : kMutations) {
    if (std::string_view(mutation.rule).starts_with("cell.")) continue;
    SCOPED_TRACE(mutation.what);
    SoundSession session;
    mutation.apply(session);
    const bool has_rules = session.cell.find("[rules]") != std::string::npos;
    const std::string cell = session.cell;
    if (has_rules) continue;
    session.cell = cell + fmt::format("[rules]\n\"{}\" = \"off\"\n", mutation.rule);
    EXPECT_TRUE(rulesOf(session.judge()).empty());
    session.cell = cell + fmt::format("[rules]\n{} = \"error\"\n", mutation.rule);
    EXPECT_EQ(session.judge().verdict, CheckVerdict::incompatible);
    session.cell = cell + fmt::format("[rules]\n\"{}\" = \"note\"\n", mutation.rule);
    EXPECT_EQ(session.judge().verdict, CheckVerdict::compatible);
  }
}

}  // namespace
}  // namespace rocinante
