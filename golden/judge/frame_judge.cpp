#include "golden/judge/frame_judge.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>
#include <string_view>
#include <utility>

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
/// comparable, then the one with the fewest differing pixels.
bool isNearer(const Comparison& found, const Comparison& best) {
  const auto rank = [](const Comparison& one) {
    return one.verdict == Verdict::same ? 0 : one.verdict == Verdict::different ? 1 : 2;
  };
  return std::pair(rank(found), found.differing) < std::pair(rank(best), best.differing);
}

/// Names the golden's key when it is not the frame's.
std::string foreignKeyText(const AcceptedPicture& golden, const std::string& key) {
  if (golden.key == key) return {};
  const bool is_shape = shapeOf(golden.key) == shapeOf(key);
  return fmt::format(", golden of {}", is_shape ? rendererOf(golden.key) : golden.key);
}

void judgeAgainst(const std::vector<const AcceptedPicture*>& goldens, const GoldenFolder& folder,
                  const CaseAreas* areas, JudgedFrame& judged) {
  std::optional<Comparison> best;
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
    if (best && !isNearer(held.found, *best)) continue;
    best = held.found;
    judged.verdict = frameVerdict(best->verdict);
    judged.rule = best->rule + foreignKeyText(*golden, judged.key);
    if (best->differing > 0) judged.rule += fmt::format(", limit from {}", judged.limit_from);
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

}  // namespace

void judgeDrawn(const Manifest& manifest, const GoldenFolder& folder, const CaseAreas* areas,
                JudgedFrame& judged) {
  const SuiteCase& made = *judged.frame.suite_case;
  judged.own_masks = made.mask.size();
  if (areas != nullptr) judged.masks = maskOf(made, *areas, nullptr).parts();
  const std::string& name = judged.frame.name;
  const auto equals = manifest.findPixels(name, judged.pixels, judged.key);
  if (!equals.empty()) {
    judged.verdict = FrameVerdict::same;
    judged.golden = *equals.front();
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
