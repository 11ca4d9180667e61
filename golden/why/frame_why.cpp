#include "golden/why/frame_why.h"

#include <fmt/format.h>

#include <algorithm>

#include "golden/why/model_change.h"

namespace rocinante {
namespace {

constexpr std::size_t kMaxCauses = 20;

void addLines(const std::vector<std::string>& from, std::size_t rows,
              std::vector<std::string>& lines) {
  for (std::size_t i = 0; i < std::min(rows, from.size()); ++i) lines.push_back(from[i]);
  if (from.size() > rows) lines.push_back(fmt::format("... and {} more", from.size() - rows));
}

/// whatText() without figures.
std::string_view wordOf(ChangeKind kind) {
  switch (kind) {
    case ChangeKind::moved:
      return "moved";
    case ChangeKind::appeared:
      return "appeared";
    case ChangeKind::vanished:
      return "vanished";
    case ChangeKind::shape:
      return "shape changed";
    case ChangeKind::drawing:
      return "text or drawing";
    case ChangeKind::camera:
    case ChangeKind::color:
      break;
  }
  return "colour changed";
}

}  // namespace

std::string_view sentenceOf(GoldenBasis basis) {
  switch (basis) {
    case GoldenBasis::redrawn:
      return "The golden was drawn again from its own cell and session, with the same pixels: both "
             "sides are known.";
    case GoldenBasis::inputs:
      return "The golden's own cell and session are at hand, but this renderer draws them "
             "differently.";
    case GoldenBasis::guessed:
      return "The golden's own cell or session is not at hand: its pixels are attributed by "
             "today's, and movements are estimated from the pictures.";
  }
  return "";
}

std::vector<std::string> whyLines(const FrameWhy& why, std::size_t rows) {
  std::vector<std::string> lines;
  std::vector<std::string> links, insets;
  for (const LinkChange& change : why.blame.changes) {
    const bool estimated = why.basis == GoldenBasis::guessed && change.kind != ChangeKind::camera;
    (change.inset.empty() ? links : insets)
        .push_back(changeText(change, why.blame.differing) + (estimated ? " (estimated)" : ""));
  }
  addLines(why.files, rows, lines);
  std::vector<std::string> states;
  for (const StateChange& change : why.state) states.push_back(change.text);
  addLines(states, rows, lines);
  addLines(links, rows, lines);
  addLines(insets, rows, lines);
  return lines;
}

void findCauses(const ModelChanges& model, const std::vector<std::string>& cameras,
                const std::vector<std::string>& gone, FrameWhy& why) {
  std::vector<LinkChange> pixels = why.blame.changes;
  std::stable_partition(pixels.begin(), pixels.end(),
                        [](const LinkChange& change) { return !change.name.device.empty(); });
  const auto isShown = [&](const ModelChange& change) {
    if (change.seen == ModelChange::Seen::camera) {
      // How it moved is known where both sides are.
      return std::ranges::find(cameras, change.subject) != cameras.end() &&
             std::ranges::find(why.state, "camera " + change.subject, &StateChange::item) ==
                 why.state.end();
    }
    return change.seen == ModelChange::Seen::drawn;
  };
  const auto isOfItsPixels = [&](const ModelChange& change) {
    return change.seen == ModelChange::Seen::camera ||
           std::ranges::any_of(pixels, [&](const LinkChange& link) {
             return !link.name.device.empty() && link.name.device == change.subject;
           });
  };
  std::vector<std::string> own, others, maybe;
  for (const ModelChange& change : model) {
    if (isShown(change)) {
      (change.subject.empty() || isOfItsPixels(change) ? own : others).push_back(change.text);
    } else if (change.seen == ModelChange::Seen::maybe) {
      maybe.push_back(change.text);
    }
  }
  // Of a device that none of the pixels belong to only where there is nothing else.
  why.causes = std::move(own.empty() ? others : own);
  why.common_cause.clear();
  const bool is_of_model = !why.causes.empty();
  for (const StateChange& change : why.state) why.causes.push_back(change.text);
  if (!is_of_model && !why.state.empty()) why.common_cause = why.state.front().common;
  if (why.causes.empty()) why.causes = std::move(maybe);
  if (!gone.empty()) {
    std::erase_if(why.causes, [&](const std::string& cause) {
      // "device arm is gone" from the cell is in the sentence.
      return std::ranges::any_of(gone, [&](const auto& its) { return its.starts_with(cause); });
    });
    why.causes.insert(why.causes.begin(), gone.begin(), gone.end());
    why.common_cause.clear();
  }
  why.causes.resize(std::min(why.causes.size(), kMaxCauses));
  if (!why.causes.empty()) return;
  for (const LinkChange& change : pixels) {
    if (why.causes.size() == kMaxCauses) break;
    why.causes.push_back(nameText(change) + ": " + whatText(change));
  }
  if (pixels.empty()) return;
  why.common_cause =
      pixels.front().kind == ChangeKind::camera
          ? ""
          : fmt::format("{}: {}", nameText(pixels.front()), wordOf(pixels.front().kind));
}

}  // namespace rocinante
