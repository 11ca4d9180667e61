#include "viewer/ui/live/publisher.h"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace rocinante {
namespace {

constexpr double kPointerPx = 12;
constexpr double kLinePx = 3;
/// Each corner sends its whole line again, which should stay one datagram or two.
constexpr std::size_t kMostCorners = 100;

/// Told apart on light and dark ground, and by most people.
constexpr std::array<std::uint32_t, 6> kColors{0xE69F00FF, 0x56B4E9FF, 0x009E73FF,
                                               0xD55E00FF, 0xCC79A7FF, 0x0072B2FF};

/// Of a name: the same in every window, without any agreement (FNV-1a).
std::uint32_t colorOf(std::string_view name) {
  std::uint32_t hash = 2166136261U;
  for (const char byte : name) hash = (hash ^ static_cast<unsigned char>(byte)) * 16777619U;
  return kColors[hash % kColors.size()];
}

std::vector<double> numbersOf(std::span<const Vec3> points) {
  std::vector<double> numbers;
  for (const Vec3& point : points) numbers.insert(numbers.end(), {point.x, point.y, point.z});
  return numbers;
}

}  // namespace

Publisher::Publisher(SendingSource sending)
    : sending_(std::move(sending)), rgba_(colorOf(sending_.name())) {}

Result<Publisher> Publisher::open(const Endpoint& to, const SendingSettings& settings) {
  auto sending = SendingSource::open(to, settings);
  if (!sending) return sending.error();
  return Publisher(std::move(*sending));
}

Result<Publisher> Publisher::into(std::unique_ptr<DatagramSink> sink,
                                  const SendingSettings& settings) {
  auto sending = SendingSource::into(std::move(sink), settings);
  if (!sending) return sending.error();
  return Publisher(std::move(*sending));
}

void Publisher::look(const CameraView& view) {
  if (looks_ == view) return;
  looks_ = view;
  const Source::View answer{view.eye, view.target, view.fov_deg, view.up, view.ortho_height_m};
  sending_.noteAnswer(sending_.source().setView(name(), answer), "the viewpoint");
}

void Publisher::point(const std::optional<Vec3>& at) {
  if (points_ == at) return;
  points_ = at;
  Source& source = sending_.source();
  if (!at) {
    sending_.noteAnswer(source.erase(kPointer), "the pointer");
    sending_.noteAnswer(source.erase(kPointerName), "the pointer");
    return;
  }
  sending_.noteAnswer(source.drawPoints(kPointer, rgba_, std::array{*at}, kPointerPx),
                      "the pointer");
  sending_.noteAnswer(source.drawLabel(kPointerName, *at, name()), "the pointer");
}

void Publisher::addCorner(const Vec3& at, bool begins) {
  if (begins || corners_.empty() || corners_.size() == kMostCorners) {
    // One that was not finished begins the next.
    const bool goes_on = !begins && !corners_.empty();
    corners_ = goes_on ? std::vector<Vec3>{corners_.back()} : std::vector<Vec3>{};
    drawn_.push_back({fmt::format("line-{}", next_number_++), {}});
    drawn_.back().drawing.rgba = rgba_;
    drawn_.back().drawing.size_px = kLinePx;
  }
  corners_.push_back(at);
  Drawn* line = nullptr;
  for (Drawn& drawn : drawn_) {
    if (drawn.drawing.kind == StatementKind::line) line = &drawn;
  }
  line->drawing.parts = {numbersOf(corners_)};
  sending_.noteAnswer(sending_.source().drawLine(line->id, rgba_, corners_, kLinePx), "the line");
}

void Publisher::addLabel(const CarriedPoint& at, const std::string& text) {
  Drawn label{fmt::format("label-{}", next_number_++), {}};
  label.drawing.kind = StatementKind::label;
  label.drawing.text = text;
  label.drawing.parts = {numbersOf(std::array{at.at})};
  label.drawing.carrier = Path{false, at.device, at.link};
  const SourceResult answer =
      sending_.source().drawLabel(label.id, at.at, text, {at.device, at.link, false});
  sending_.noteAnswer(answer, "the label");
  if (answer == SourceResult::done) drawn_.push_back(std::move(label));
}

void Publisher::eraseDrawn() {
  for (const Drawn& drawn : drawn_)
    sending_.noteAnswer(sending_.source().erase(drawn.id), drawn.id);
  drawn_.clear();
  corners_.clear();
}

void Publisher::say(const std::string& text) {
  sending_.noteAnswer(sending_.source().event(text), "the event");
}

void Publisher::leave(SteadyTime now, WallTime wall) { sending_.withdraw(now, wall); }

}  // namespace rocinante
