#include "golden/frame_judge.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
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

/// With what the case's masks hide, now or when the golden was accepted, left out.
Comparison compareUnmasked(const GoldenFolder& folder, const CaseAreas* areas,
                           const AcceptedPicture& golden, const Picture& accepted,
                           JudgedFrame& judged, std::optional<Picture>& unmasked) {
  if (areas == nullptr) return compare(*judged.drawn, accepted, judged.tolerance);
  std::optional<Picture> accepted_areas;
  if (!golden.areas.empty()) {
    auto read = folder.readAreas(golden);
    if (read.ok()) accepted_areas = std::move(*read);
  }
  const PictureMask mask =
      maskOf(*judged.frame.suite_case, *areas, accepted_areas ? &*accepted_areas : nullptr);
  judged.masks = mask.parts();
  if (accepted.width == mask.width() && accepted.height == mask.height()) {
    unmasked = mask.applied(*judged.drawn, accepted);
  }
  return compare(*judged.drawn, accepted, judged.tolerance, &mask);
}

void judgeAgainst(const std::vector<const AcceptedPicture*>& goldens, const GoldenFolder& folder,
                  const CaseAreas* areas, JudgedFrame& judged) {
  bool judged_one = false;
  for (const AcceptedPicture* golden : goldens) {
    auto accepted = folder.read(*golden);
    if (!accepted.ok()) {
      // A golden that nobody accepted must judge nothing.
      if (!judged_one && !judged.golden) {
        judged.golden = *golden;
        judged.rule = accepted.error().text();
      }
      continue;
    }
    std::optional<Picture> unmasked;
    Comparison found = compareUnmasked(folder, areas, *golden, *accepted, judged, unmasked);
    const FrameVerdict verdict = frameVerdict(found.verdict);
    // Of several accepted pictures the nearest one is told.
    const bool nearer =
        !judged_one || verdict == FrameVerdict::same ||
        (verdict == FrameVerdict::different && (judged.verdict == FrameVerdict::incomparable ||
                                                found.differing < judged.comparison.differing));
    judged_one = true;
    if (!nearer) continue;
    judged.verdict = verdict;
    judged.rule = found.rule;
    if (found.differing > 0) judged.rule += fmt::format(", limit from {}", judged.limit_from);
    judged.comparison = std::move(found);
    judged.golden = *golden;
    judged.accepted = std::move(*accepted);
    judged.unmasked = std::move(unmasked);
    if (verdict == FrameVerdict::same) return;
  }
}

/// What there is instead of a golden of the key that is wanted, and what to do.
std::string otherKeysRule(const std::vector<AcceptedPicture>& goldens, const std::string& wanted) {
  const auto rendererOf = [](std::string_view key) { return key.substr(0, key.find(' ')); };
  std::set<std::string> renderers;
  std::set<std::string> shapes;
  for (const AcceptedPicture& golden : goldens) {
    const std::string_view renderer = rendererOf(golden.key);
    renderers.emplace(renderer);
    if (renderer == rendererOf(wanted))
      shapes.insert(golden.key.substr(std::min(golden.key.size(), renderer.size() + 1)));
  }
  if (!shapes.empty()) {
    return fmt::format("no golden of this size and samples; wanted: {}, there is {}: approve it",
                       wanted, fmt::join(shapes, ", "));
  }
  return fmt::format(
      "no golden of this renderer; wanted: {}, there is {}: run where that one draws, approve here "
      "too (both are kept), or name a tolerance",
      wanted, fmt::join(renderers, ", "));
}

}  // namespace

void judgeDrawn(const Manifest& manifest, const GoldenFolder& folder, const CaseAreas* areas,
                JudgedFrame& judged) {
  const SuiteCase& made = *judged.frame.suite_case;
  judged.own_masks = made.mask.size();
  if (areas != nullptr) judged.masks = maskOf(made, *areas, nullptr).parts();
  std::vector<const AcceptedPicture*> goldens = manifest.find(judged.frame.name, judged.key);
  for (const AcceptedPicture* golden : goldens) {
    if (golden->pixels != judged.pixels) continue;
    judged.verdict = FrameVerdict::same;
    judged.rule = "equal pixel hash";
    judged.golden = *golden;
    judged.comparison.verdict = Verdict::same;
    judged.comparison.rule = judged.rule;
    return;
  }
  const auto pictures = manifest.cases.find(judged.frame.name);
  if (pictures == manifest.cases.end() || pictures->second.empty()) {
    judged.verdict = FrameVerdict::missing;
    judged.rule = "no golden was ever approved for this case";
    return;
  }
  if (goldens.empty() && !judged.tolerance.exact) {
    const auto* near = manifest.findAnyOfShape(judged.frame.name,
                                               shapeText(made.width, made.height, made.samples));
    if (near != nullptr) goldens.push_back(near);
  }
  if (goldens.empty()) {
    judged.rule = otherKeysRule(pictures->second, judged.key);
    return;
  }
  judgeAgainst(goldens, folder, areas, judged);
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
