#include "player/demo/demo_planner.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "player/demo/demo_script.h"

namespace rocinante {
namespace {

/// The planner sends a little after the gantry and the arm, so that its statements follow theirs.
constexpr Nanoseconds kPhase = std::chrono::milliseconds(6);
constexpr std::uint32_t kCarryColor = 0x00B7FFE0;
constexpr std::uint32_t kPathColor = 0xFFD400FF;
constexpr std::uint32_t kWaypointColor = 0xFFFFFFFF;
/// A point as text: three numbers of up to eight characters with a space each.
constexpr std::size_t kPointBytes = 27;
/// Room for the header line and the part of a line statement before its points.
constexpr std::size_t kLineHeadBytes = 240;

/// The coordinates of the points. A Statement only borrows them.
std::vector<double> numbersOf(const std::vector<Vec3>& points) {
  std::vector<double> numbers;
  for (const Vec3& point : points) {
    for (const double value : {point.x, point.y, point.z}) {
      // A tenth of a millimetre is finer than visible, and half as long to write.
      numbers.push_back(std::floor(value * 1e4 + 0.5) / 1e4 + 0.0);
    }
  }
  return numbers;
}

Statement drawing(StatementKind kind, std::string_view id, std::uint32_t rgba, double size_px,
                  std::span<const double> numbers) {
  Statement statement;
  statement.kind = kind;
  statement.name = id;
  statement.rgba = rgba;
  statement.size_px = size_px;
  statement.numbers = numbers;
  return statement;
}

Statement label(std::string_view id, std::span<const double> at, std::string_view text,
                PathView carrier = {}) {
  Statement statement;
  statement.kind = StatementKind::label;
  statement.name = id;
  statement.numbers = at;
  statement.text = text;
  statement.carrier = carrier;
  return statement;
}

Statement erase(std::string_view id) {
  Statement statement;
  statement.kind = StatementKind::erase;
  statement.name = id;
  return statement;
}

Statement event(std::string_view text) {
  Statement statement;
  statement.kind = StatementKind::event;
  statement.text = text;
  return statement;
}

class Planner {
 public:
  Planner(DemoSpeaker& speaker, Nanoseconds start, std::size_t mtu_bytes)
      : speaker_(speaker), start_(start) {
    const DemoPath carry = carryPath();
    carry_ = numbersOf(carry.points);
    carry_ends_ = numbersOf(carry.waypoints);
    const DemoPath path = armPath();
    path_ = numbersOf(path.points);
    waypoints_ = numbersOf(path.waypoints);
    path_label_ = numbersOf({kCanisterAtStation + Vec3{-0.32, 0, kCanisterHeight + 0.10}});
    points_a_part_ = std::max<std::size_t>(2, (mtu_bytes - kLineHeadBytes) / kPointBytes);
  }

  void showView(double at) {
    Statement view;
    view.kind = StatementKind::view;
    view.name = "lid";
    view.numbers = kLidView;
    say(at, {view});
  }

  void showCarry(double at) {
    const std::span<const double> ends(carry_ends_);
    say(at, {drawing(StatementKind::line, "carry", kCarryColor, 3, carry_),
             drawing(StatementKind::points, "stops", kWaypointColor, 9, carry_ends_),
             label("from", ends.first(3), "pick"), label("to", ends.last(3), "place")});
  }

  void tellPicked(double at) {
    say(at, {event("picked"), label("load", kLoadLabel, "32 kg", {"gantry", "gripper", false})});
  }

  void showPath(double at) {
    sayPath(at, kPathColor);
    say(at, {drawing(StatementKind::points, "waypoints", kWaypointColor, 8, waypoints_),
             label("task", path_label_, "inspect lid")});
  }

  void tellPlaced(double at) {
    say(at, {event("placed"), erase("load"), erase("carry"), erase("stops"), erase("from"),
             erase("to")});
  }

  /// `left` is the remaining opacity; 1 is the full colour.
  void fadePath(double at, double left) {
    const auto alpha = static_cast<std::uint32_t>(left * 255.0);
    sayPath(at, (kPathColor & 0xFFFFFF00U) | alpha);
  }

  void eraseAll(double at) { say(at, {erase("")}); }

  void sayAgain(Nanoseconds at) { speaker_.sayAgain(start_ + at); }

 private:
  static constexpr double kLidView[] = {-0.15, -2.35, 1.95, 1.45, -1.0, 0.95, 36, 0, 0, 1};
  static constexpr double kLoadLabel[] = {0, 0, -0.22};

  void say(double at, const std::vector<Statement>& statements) {
    const Nanoseconds offset(static_cast<std::int64_t>(at * 1e9 + 0.5));
    speaker_.say(start_ + kPhase + offset, statements);
  }

  /// The path is longer than a datagram: it is sent in parts that share their end points.
  void sayPath(double at, std::uint32_t rgba) {
    const std::size_t points = path_.size() / 3;
    const std::size_t steps = points_a_part_ - 1;
    const std::size_t parts = (points - 2) / steps + 1;
    for (std::size_t i = 0; i < parts; ++i) {
      const std::size_t first = i * steps;
      const std::size_t count = std::min(points_a_part_, points - first);
      Statement line = drawing(StatementKind::line, "path", rgba, 3,
                               std::span(path_).subspan(3 * first, 3 * count));
      line.part_index = static_cast<std::uint32_t>(i + 1);
      line.part_count = static_cast<std::uint32_t>(parts);
      say(at, {line});
    }
  }

  DemoSpeaker& speaker_;
  Nanoseconds start_;
  std::vector<double> carry_, carry_ends_, path_, waypoints_, path_label_;
  std::size_t points_a_part_ = 2;
};

}  // namespace

void sayPlanner(DemoSpeaker& speaker, Nanoseconds start, Nanoseconds restate_period,
                std::size_t mtu_bytes) {
  Planner planner(speaker, start, mtu_bytes);
  struct Act {
    double at;
    std::function<void(double)> say;
  };
  const std::vector<Act> acts{
      {0.0, [&](double at) { planner.showView(at); }},
      {DemoMoment::kCarryShown, [&](double at) { planner.showCarry(at); }},
      {DemoMoment::kPicked, [&](double at) { planner.tellPicked(at); }},
      {DemoMoment::kPathShown, [&](double at) { planner.showPath(at); }},
      {DemoMoment::kPlaced, [&](double at) { planner.tellPlaced(at); }},
      {DemoMoment::kPathEnds, [&](double at) { planner.fadePath(at, 0.7); }},
      {DemoMoment::kPathEnds + 0.5, [&](double at) { planner.fadePath(at, 0.4); }},
      {DemoMoment::kPathEnds + 1.0, [&](double at) { planner.fadePath(at, 0.2); }},
      {DemoMoment::kErased, [&](double at) { planner.eraseAll(at); }},
  };
  Nanoseconds next_restatement = restate_period;
  const auto restateUntil = [&](Nanoseconds until) {
    for (; next_restatement < until; next_restatement += restate_period) {
      planner.sayAgain(next_restatement + kPhase);
    }
  };
  for (const Act& act : acts) {
    restateUntil(Nanoseconds(static_cast<std::int64_t>(act.at * 1e9)));
    act.say(act.at);
  }
  restateUntil(kDemoLength);
}

}  // namespace rocinante
