#include "tests/core/behaviour/demo_regressions.h"

#include <algorithm>
#include <utility>

namespace rocinante::test {

using Kind = RunFinding::Kind;

std::function<double(double, double)> plus(double by) {
  return [by](double value, double) { return value + by; };
}

void delay(SaidSession& session, const std::string& device, std::size_t number, double by_s,
           double from, double until) {
  std::vector<std::pair<double, double>> before;
  SaidSession copy = session;
  copy.joint(device, number, 0, 1e9, [&](double value, double at) {
    before.emplace_back(at, value);
    return value;
  });
  session.joint(device, number, from, until, [&](double value, double at) {
    const auto after =
        std::ranges::upper_bound(before, at - by_s, {}, [](auto& one) { return one.first; });
    return after == before.begin() ? value : std::prev(after)->second;
  });
}

std::vector<Regression> demoRegressions() {
  std::vector<Regression> all;
  for (std::size_t joint = 0; joint < 6; ++joint) {
    static const char* const kNames[] = {"arm/joint1", "arm/joint2", "arm/joint3",
                                         "arm/joint4", "arm/joint5", "arm/joint6"};
    all.push_back({"a joint is 0.1 degrees off", Kind::joint, kNames[joint], 0, 0.1,
                   [joint](SaidSession& s) { s.joint("arm", joint, 0, 1e9, plus(0.1 * kDegree)); },
                   "offset by +0.10°"});
    all.push_back({"a joint is 0.5 degrees off from a moment on", Kind::joint, kNames[joint], 5.9,
                   6.1,
                   [joint](SaidSession& s) { s.joint("arm", joint, 6, 1e9, plus(-0.5 * kDegree)); },
                   "offset by -0.50°"});
    all.push_back({"a joint is frozen", Kind::joint, kNames[joint], 13, 15.5,
                   [joint](SaidSession& s) {
                     double held = NAN;
                     s.joint("arm", joint, 13, 17.5, [held](double value, double) mutable {
                       if (std::isnan(held)) held = value;
                       return held;
                     });
                   },
                   "frozen at"});
  }
  const auto add = [&](Regression regression) { all.push_back(std::move(regression)); };
  add({"a joint's sign is flipped", Kind::joint, "arm/joint1", 0.9, 2.2,
       [](SaidSession& s) {
         s.joint("arm", 0, 0, 1e9, [](double value, double) { return -value; });
       },
       "its sign is flipped"});
  add({"a joint's sign is flipped for two seconds", Kind::joint, "arm/joint4", 12.9, 13.9,
       [](SaidSession& s) {
         s.joint("arm", 3, 13, 15, [](double value, double) { return -value; });
       },
       "its sign is flipped"});
  add({"a joint is 50 ms late", Kind::joint, "arm/joint2", 1, 2.2,
       [](SaidSession& s) { delay(s, "arm", 1, 0.05); }, "ms late"});
  add({"another one is 50 ms late", Kind::joint, "arm/joint5", 1, 3,
       [](SaidSession& s) { delay(s, "arm", 4, 0.05); }, "ms late"});
  add({"a device is 50 ms late", Kind::joint, "gantry/x", 0, 2,
       [](SaidSession& s) { s.times("gantry", [](double at) { return at + 0.05; }); }, "ms late",
       RunAlign::origin});
  add({"a device is 50 ms late beside events in time", Kind::joint, "gantry/y", 0, 2,
       [](SaidSession& s) {
         s.times("gantry", [](double at) { return at < 0.01 ? at : at + 0.05; });
       },
       "ms late"});
  add({"the gantry stops 2 mm short", Kind::joint, "gantry/x", 1, 3,
       [](SaidSession& s) { s.joint("gantry", 0, 2, 6, plus(0.002)); }, "offset by +2.00 mm"});
  add({"the hoist is 1 mm off", Kind::joint, "gantry/z", 9.9, 11,
       [](SaidSession& s) { s.joint("gantry", 2, 10, 12, plus(-0.001)); }, ""});
  add({"the gripper does not close", Kind::joint, "gantry/grip", 4, 5,
       [](SaidSession& s) {
         s.joint("gantry", 3, 0, 1e9, [](double, double) { return 0.0; });
         s.replace("grip=0.06", "grip=0");
       },
       "frozen at"});
  add({"two joints are swapped", Kind::joint, "arm/joint2", 0, 0.1, [](SaidSession& s) {
         for (auto& said : s.packets) {
           std::vector<double> values;
           SaidSession::changedJoints(said.body, "arm", [&](double value, std::size_t) {
             values.push_back(value);
             return value;
           });
           said.body =
               SaidSession::changedJoints(said.body, "arm", [&](double value, std::size_t i) {
                 return i == 1 ? values[2] : i == 2 ? values[1] : value;
               });
         }
       }});
  add({"a value leaps for 40 ms", Kind::joint, "arm/joint3", 7.9, 8.1,
       [](SaidSession& s) { s.joint("arm", 2, 8, 8.04, plus(0.2)); }});
  add({"a value leaps for one packet", Kind::joint, "arm/joint3", 7.9, 8.1,
       [](SaidSession& s) { s.joint("arm", 2, 8.015, 8.025, plus(0.2)); }});
  add({"a motion overshoots", Kind::joint, "arm/joint1", 3.4, 4.6, [](SaidSession& s) {
         s.joint("arm", 0, 3.5, 5, [](double value, double at) {
           return value + 0.02 * std::sin((at - 3.5) / 1.5 * M_PI);
         });
       }});
  add({"a motion trembles", Kind::joint, "arm/joint6", 6.9, 7.2, [](SaidSession& s) {
         s.joint("arm", 5, 7, 9, [](double value, double at) {
           return value + 0.004 * std::sin(at * 2 * M_PI * 4);
         });
       }});
  add({"a joint drifts", Kind::joint, "arm/joint1", 4.5, 12, [](SaidSession& s) {
         s.joint("arm", 0, 4, 1e9, [](double value, double at) { return value + (at - 4) * 2e-4; });
       }});
  add({"a motion is 10 % too small", Kind::joint, "arm/joint2", 0, 3, [](SaidSession& s) {
         s.joint("arm", 1, 0, 1e9, [](double value, double) { return -0.8 + 0.9 * (value + 0.8); });
       }});
  add({"an event is missing", Kind::event, "event/placed", 11, 11.2,
       [](SaidSession& s) { s.replace("event \"placed\"\n", ""); }, "is missing"});
  add({"another event is missing", Kind::event, "event/picked", 4.5, 4.7,
       [](SaidSession& s) { s.replace("event \"picked\"\n", ""); }, "is missing"});
  add({"an event is renamed", Kind::event, "event/dropped", 11, 11.2,
       [](SaidSession& s) { s.replace("\"placed\"", "\"dropped\""); }, "was never accepted"});
  add({"an event too many", Kind::event, "event/collision", 7.9, 8.1,
       [](SaidSession& s) { s.say("arm", 8, "event \"collision\""); }, "was never accepted"});
  add({"two events are swapped", Kind::event, "event/p", 4.5, 11.2,
       [](SaidSession& s) {
         s.replace("\"picked\"", "\"x\"")
             .replace("\"placed\"", "\"picked\"")
             .replace("\"x\"", "\"placed\"");
       },
       "is out of order"});
  add({"an event is 50 ms late", Kind::event, "event/placed", 11, 11.2,
       [](SaidSession& s) {
         s.replace("event \"placed\"\n", "").say("planner", 11.154, "event \"placed\"");
         s.packets.back().source = "planner";
         s.packets.back().header = "RK1 planner@fccb779dc2 0 -";
       },
       "50 ms late"});
  add({"a pause is 300 ms longer", Kind::event, "event/placed", 11, 11.2,
       [](SaidSession& s) { s.times("", [](double at) { return at < 8 ? at : at + 0.3; }); },
       "300 ms late"});
  add({"everything after a moment is 100 ms late", Kind::event, "event/placed", 11, 11.2,
       [](SaidSession& s) { s.times("", [](double at) { return at < 6.5 ? at : at + 0.1; }); },
       "late", RunAlign::origin});
  add({"a rate is halved", Kind::rate, "arm", 0, 1.1,
       [](SaidSession& s) {
         std::size_t count = 0;
         std::erase_if(s.packets,
                       [&](const auto& said) { return said.source == "arm" && count++ % 2 == 1; });
       },
       "times a second"});
  add({"a rate is halved for five seconds", Kind::rate, "gantry", 8.5, 10.5, [](SaidSession& s) {
         std::size_t count = 0;
         std::erase_if(s.packets, [&](const auto& said) {
           return said.source == "gantry" && said.at_s > 9 && said.at_s < 14 && count++ % 2 == 1;
         });
       }});
  add({"a source falls silent for a second while it moves", Kind::joint, "gantry/x", 6.9, 7.6,
       [](SaidSession& s) { s.erase("gantry", 7, 8.5); }});
  add({"a session ends early", Kind::joint, "arm/joint2", 17.4, 19, [](SaidSession& s) {
         std::erase_if(s.packets, [](const auto& said) { return said.at_s > 17.5; });
       }});
  add({"a device never speaks", Kind::coverage, "arm", 0, 0.1,
       [](SaidSession& s) { s.erase("arm", 0, 1e9); }, "states nothing of it"});
  add({"a canister stands elsewhere", Kind::pose, "canister", 0, 0.1, [](SaidSession& s) {
         s.replace("pose canister -2.4 -1 0.25", "pose canister -2.4 -1.002 0.25");
       }});
  add({"a canister is not picked up", Kind::fact, "canister", 4.4, 5, [](SaidSession& s) {
         for (auto& said : s.packets) {
           if (said.body.find("in gantry/gripper") == std::string::npos) continue;
           const std::size_t at = said.body.find("pose canister ");
           if (at != std::string::npos) said.body.erase(at, said.body.find('\n', at) - at + 1);
         }
       }});
  add({"a drawing is missing", Kind::drawing, "drawing/planner/stops", 0.2, 0.5,
       [](SaidSession& s) { s.replace("points stops", "points other"); }});
  add({"a drawing has another colour", Kind::drawing, "drawing/planner/carry", 0.2, 0.5,
       [](SaidSession& s) { s.replace("line carry #00b7ffe0", "line carry #00b700e0"); }});
  add({"a drawing is 5 mm elsewhere", Kind::drawing, "drawing/planner/stops", 0.2, 0.5,
       [](SaidSession& s) { s.replace("1.25 -1 0.55\n", "1.255 -1 0.55\n"); }});
  add({"a label says something else", Kind::drawing, "drawing/planner/load", 4.4, 4.8,
       [](SaidSession& s) { s.replace("32 kg", "33 kg"); }});
  add({"a device is hidden", Kind::fact, "arm", 8.9, 9.2,
       [](SaidSession& s) { s.say("viewer", 9, "hide arm"); }});
  add({"a device that nobody knows is added", Kind::fact, "canister_9", 8.9, 9.2,
       [](SaidSession& s) { s.say("planner", 9, "add canister_9 canister"); }});
  return all;
}

}  // namespace rocinante::test
