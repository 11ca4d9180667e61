#include "golden/judge/frame_judge.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <compare>
#include <set>
#include <string_view>
#include <utility>

#include "golden/judge/frame_coverage.h"

namespace rocinante {
namespace {

FrameVerdict frameVerdict(Verdict verdict) {
  switch (verdict) {
    case Verdict::same:
      return FrameVerdict::same;
    case Verdict::different:
      return FrameVerdict::different;
    case Verdict::incomparable:
      return FrameVerdict::incomparable;
  }
  return FrameVerdict::incomparable;
}

/// The frame compared with one accepted picture.
struct Held {
  Comparison found;
  std::optional<Picture> unmasked;
  std::vector<PictureMask::Part> masks;
};

/// Compares without the pixels that the case's masks hide now or hid in the golden.
Held holdAgainst(const GoldenFolder& folder, const CaseAreas* areas, const AcceptedPicture& golden,
                 const Picture& accepted, const JudgedFrame& judged) {
  Held held;
  if (areas == nullptr) {
    held.found = compare(*judged.drawn, accepted, judged.tolerance);
    return held;
  }
  std::optional<Picture> accepted_areas;
  if (!golden.areas.empty()) {
    auto read = folder.readAreas(golden);
    if (read.ok()) accepted_areas = std::move(*read);
  }
  const PictureMask mask =
      maskOf(*judged.frame.suite_case, *areas, accepted_areas ? &*accepted_areas : nullptr);
  held.masks = mask.parts();
  if (accepted.width == mask.width() && accepted.height == mask.height()) {
    held.unmasked = mask.applied(*judged.drawn, accepted);
  }
  held.found = compare(*judged.drawn, accepted, judged.tolerance, &mask);
  return held;
}

/// The nearest of several accepted pictures is reported: first one that passes, then one that is
/// comparable, then one whose devices are all judged, then the one with the fewest differing
/// pixels.
struct Nearness {
  int rank = 0;
  bool loses_coverage = false;
  std::int64_t differing = 0;
  auto operator<=>(const Nearness&) const = default;
};

Nearness nearnessOf(const Comparison& found, bool loses_coverage) {
  const int rank = found.verdict == Verdict::same ? 0 : found.verdict == Verdict::different ? 1 : 2;
  return {rank, loses_coverage, found.differing};
}

bool losesCoverage(const AcceptedPicture& golden, const JudgedFrame& judged) {
  return judged.coverage && !lostSince(golden, *judged.coverage).empty();
}

/// Names the golden's key when it is not the frame's.
std::string foreignKeyText(const AcceptedPicture& golden, const std::string& key) {
  if (golden.key == key) return {};
  const bool is_shape = shapeOf(golden.key) == shapeOf(key);
  return fmt::format(", golden of {}", is_shape ? rendererOf(golden.key) : golden.key);
}

void judgeAgainst(const std::vector<const AcceptedPicture*>& goldens, const GoldenFolder& folder,
                  const CaseAreas* areas, JudgedFrame& judged) {
  std::optional<Nearness> best;
  for (const AcceptedPicture* golden : goldens) {
    auto accepted = folder.read(*golden);
    if (!accepted.ok()) {
      // An unreadable or altered golden must not judge.
      if (!judged.golden) {
        judged.golden = *golden;
        judged.rule = accepted.error().text();
      }
      continue;
    }
    Held held = holdAgainst(folder, areas, *golden, *accepted, judged);
    const Nearness nearness = nearnessOf(held.found, losesCoverage(*golden, judged));
    if (best && *best <= nearness) continue;
    best = nearness;
    judged.verdict = frameVerdict(held.found.verdict);
    judged.rule = held.found.rule + foreignKeyText(*golden, judged.key);
    if (held.found.differing > 0) judged.rule += fmt::format(", limit from {}", judged.limit_from);
    judged.comparison = std::move(held.found);
    judged.golden = *golden;
    judged.accepted = std::move(*accepted);
    judged.unmasked = std::move(held.unmasked);
    if (areas != nullptr) judged.masks = std::move(held.masks);
  }
}

/// Rule for a frame without a golden of its size and samples.
std::string otherShapesRule(const std::vector<const AcceptedPicture*>& goldens,
                            const std::string& wanted) {
  std::set<std::string_view> own_shapes, keys;
  for (const AcceptedPicture* golden : goldens) {
    keys.insert(golden->key);
    if (rendererOf(golden->key) == rendererOf(wanted)) own_shapes.insert(shapeOf(golden->key));
  }
  return fmt::format("no golden of this size and samples for {} (have {}); approve one", wanted,
                     fmt::join(own_shapes.empty() ? keys : own_shapes, ", "));
}

/// A golden of another key can show that a frame is the same, but a difference counts only if the
/// case sets limits: otherwise the renderer may have changed.
void doubtForeignGolden(JudgedFrame& judged) {
  if (judged.verdict == FrameVerdict::same) return;
  judged.verdict = FrameVerdict::incomparable;
  const Comparison& found = judged.comparison;
  std::string why = found.rule.empty() ? judged.rule : found.rule;
  if (found.differing > 0) why += fmt::format(", limit from {}", judged.limit_from);
  judged.rule = fmt::format(
      "no golden of this renderer ({}); against {}: {}; run on that renderer, approve here too "
      "(both are kept), or set a tolerance",
      judged.key, rendererOf(judged.golden->key), why);
}

/// What was judged when the golden was accepted and is no more makes a frame different, whatever
/// its pixels are.
void judgeCoverage(JudgedFrame& judged) {
  if (!judged.golden || !losesCoverage(*judged.golden, judged)) return;
  judged.coverage->lost = lostSince(*judged.golden, *judged.coverage);
  judged.verdict = FrameVerdict::different;
  judged.rule = fmt::format("{}; {}", lostSentence(*judged.coverage), judged.rule);
  // Of equal pixels the golden was not read.
  if (!judged.accepted && judged.comparison.verdict == Verdict::same) {
    judged.accepted = judged.drawn;
  }
}

void judgePixels(const Manifest& manifest, const GoldenFolder& folder, const CaseAreas* areas,
                 JudgedFrame& judged) {
  const SuiteCase& made = *judged.frame.suite_case;
  judged.own_masks = made.mask.size();
  if (areas != nullptr) judged.masks = maskOf(made, *areas, nullptr).parts();
  const std::string& name = judged.frame.name;
  const auto equals = manifest.findPixels(name, judged.pixels, judged.key);
  if (!equals.empty()) {
    judged.verdict = FrameVerdict::same;
    const auto whole = std::ranges::find_if(
        equals, [&](const AcceptedPicture* one) { return !losesCoverage(*one, judged); });
    judged.golden = whole == equals.end() ? *equals.front() : **whole;
    judged.rule = "equal pixel hash" + foreignKeyText(*judged.golden, judged.key);
    judged.comparison.verdict = Verdict::same;
    judged.comparison.rule = judged.rule;
    return;
  }
  const auto all = manifest.findAll(name);
  if (all.empty()) {
    judged.verdict = FrameVerdict::missing;
    judged.rule = "no golden was approved for this case yet";
    return;
  }
  auto goldens = manifest.find(name, judged.key);
  const bool is_foreign = goldens.empty();
  if (is_foreign) {
    goldens = all;
    std::erase_if(goldens, [&](const AcceptedPicture* one) {
      return shapeOf(one->key) != shapeOf(judged.key);
    });
  }
  if (goldens.empty()) {
    judged.rule = otherShapesRule(all, judged.key);
    return;
  }
  if (is_foreign) judged.tolerance = made.across_keys;
  judgeAgainst(goldens, folder, areas, judged);
  if (is_foreign && made.tolerance.exact) doubtForeignGolden(judged);
}

}  // namespace

void judgeDrawn(const Manifest& manifest, const GoldenFolder& folder, const CaseAreas* areas,
                JudgedFrame& judged) {
  judgePixels(manifest, folder, areas, judged);
  judgeCoverage(judged);
}

void applyExpectation(JudgedFrame& judged) {
  const SuiteCase& made = *judged.frame.suite_case;
  if (!made.expect_different) return;
  judged.expectation = made.reason;
  if (judged.verdict == FrameVerdict::different) {
    judged.verdict = FrameVerdict::expected;
    judged.rule += fmt::format("; expected: {}", made.reason);
  } else if (judged.verdict == FrameVerdict::same) {
    judged.verdict = FrameVerdict::unexpected;
    judged.rule += fmt::format(", though line {} expects a difference: {}", made.line, made.reason);
  }
}

}  // namespace rocinante
