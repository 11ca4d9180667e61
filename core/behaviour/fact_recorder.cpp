#include "core/behaviour/fact_recorder.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "core/packet/item_text.h"

namespace rocinante {
namespace {

constexpr std::size_t kPointsKept = 16;

std::string pathText(const Path& path) {
  return path.first + (path.second.empty() ? "" : "/" + path.second);
}

}  // namespace

std::string drawingStyle(const Drawing& drawing, const std::vector<double>& part) {
  std::string text = fmt::format("{}{} of {} points, #{:08x}, size {}",
                                 drawing.parts.size() > 1 ? "part of a " : "", nameOf(drawing.kind),
                                 part.size() / 3, drawing.rgba, drawing.size_px);
  if (!drawing.carrier.first.empty()) {
    text += fmt::format(", in {}/{}", drawing.carrier.first, drawing.carrier.second);
  }
  if (!drawing.text.empty()) text += fmt::format(", \"{}\"", drawing.text);
  return text;
}

std::vector<double> drawingShape(const std::vector<double>& points) {
  const std::size_t count = points.size() / 3;
  if (count == 0) return {};
  std::array<double, 3> least, most, mean{};
  least.fill(std::numeric_limits<double>::infinity());
  most.fill(-std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < count * 3; ++i) {
    const std::size_t axis = i % 3;
    least[axis] = std::min(least[axis], points[i]);
    most[axis] = std::max(most[axis], points[i]);
    mean[axis] += points[i] / static_cast<double>(count);
  }
  std::vector<double> shape;
  shape.reserve(9 + kPointsKept * 3);
  for (const auto& numbers : {least, most, mean}) {
    shape.insert(shape.end(), numbers.begin(), numbers.end());
  }
  const std::size_t kept = std::min(count, kPointsKept);
  for (std::size_t i = 0; i < kept; ++i) {
    const std::size_t point = kept == 1 ? 0 : i * (count - 1) / (kept - 1);
    shape.insert(shape.end(), points.begin() + static_cast<std::ptrdiff_t>(point * 3),
                 points.begin() + static_cast<std::ptrdiff_t>(point * 3 + 3));
  }
  return shape;
}

void FactRecorder::set(const std::string& name, LogTime time, std::string text,
                       std::vector<double> shape) {
  auto& changes = facts_[name];
  seen_.push_back(&changes);
  if (!changes.empty() && changes.back().text == text && changes.back().shape == shape) return;
  changes.push_back({time, std::move(text), std::move(shape), is_restated_});
}

void FactRecorder::note(const SessionState& state, LogTime time, bool is_restated) {
  is_restated_ = is_restated;
  seen_.clear();
  const ByKind set_fact{
      [&](const PresenceItem& item) {
        set("presence of " + item.device, time, statementText(item));
      },
      [&](const PoseItem& item) {
        const Path& carrier = item.item.value.carrier;
        if (!carrier.first.empty())
          set("carrier of " + item.device, time, "in " + pathText(carrier));
      },
      [&](const VisibilityItem& item) {
        if (item.item.value.kind == Visibility::Kind::by_default) return;
        set("visibility of " + pathText(item.path), time, statementText(item));
      },
      [&](const ColorItem& item) {
        if (item.item.value.rgba) set("color of " + pathText(item.path), time, statementText(item));
      },
      [&](const DrawingItem& item) {
        const std::string name = "drawing/" + item.source + "/" + item.id;
        const std::vector<double>& part = *item.drawing.parts[item.part];
        set(item.part == 0 ? name : fmt::format("{}\t{}", name, item.part + 1), time,
            drawingStyle(item.drawing, part), drawingShape(part));
      },
      // Judged as series, or not at all.
      [](const PositionsItem&) {},
      [](const OrderItem&) {},
      [](const JointItem&) {},
      [](const ViewItem&) {},
      [&](const SignalItem& item) { setSignal(item, time); },
  };
  eachItem(state, [&](const auto& item) {
    ++looked_;
    set_fact(item);
  });
  std::ranges::sort(seen_);
  for (auto& [name, changes] : facts_) endUnseen(changes, time);
}

void FactRecorder::note(std::span<const ChangedSignal> signals, LogTime time, bool is_restated) {
  is_restated_ = is_restated;
  for (const ChangedSignal& signal : signals) {
    ++looked_;
    seen_.clear();
    if (signal.item != nullptr) setSignal({signal.device, signal.name, *signal.item}, time);
    const std::string name = signalNameText(signal.device, signal.name);
    for (const std::string& fact : {name, "unit of " + name}) {
      const auto found = facts_.find(fact);
      if (found != facts_.end()) endUnseen(found->second, time);
    }
  }
}

void FactRecorder::setSignal(const SignalItem& item, LogTime time) {
  const SignalValue& value = item.item.value;
  const std::string name = signalNameText(item.device, item.name);
  if (value.kind != SignalKind::number) {
    set(name, time, statementText(item).substr(name.size() + 1));
  } else if (!value.unit.empty()) {
    set("unit of " + name, time, value.unit);
  }
}

void FactRecorder::endUnseen(std::vector<FactChange>& changes, LogTime time) {
  ++looked_;
  if (changes.back().text.empty() || std::ranges::binary_search(seen_, &changes)) return;
  changes.push_back({time, "", {}, is_restated_});
}

}  // namespace rocinante
