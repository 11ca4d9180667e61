#include "golden/judge/manifest_diff.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/base/plain_text.h"
#include "golden/judge/frame_coverage.h"
#include "golden/suite/suite_case.h"

namespace rocinante {
namespace {

using Pictures = std::vector<const AcceptedPicture*>;

std::set<std::pair<std::string, std::string>> casesAndKeys(const Manifest& a, const Manifest& b) {
  std::set<std::pair<std::string, std::string>> found;
  for (const Manifest* manifest : {&a, &b}) {
    for (const auto& [name, pictures] : manifest->cases) {
      for (const AcceptedPicture& accepted : pictures) found.emplace(name, accepted.key);
    }
  }
  return found;
}

std::multiset<std::string> pixelsOf(const Pictures& pictures) {
  std::multiset<std::string> pixels;
  for (const AcceptedPicture* accepted : pictures) pixels.insert(accepted->pixels);
  return pixels;
}

/// Devices and joints that some of the pictures cover.
std::set<std::string> coverageOf(const Pictures& pictures) {
  std::set<std::string> devices;
  for (const AcceptedPicture* accepted : pictures) {
    if (accepted->coverage) devices.insert(accepted->coverage->begin(), accepted->coverage->end());
  }
  return devices;
}

/// "arm and 2 more are no longer judged; ": what was covered; empty: all of it still is.
std::string lostText(const Pictures& then, const Pictures& now) {
  std::set<std::string> lost = coverageOf(then);
  const std::set<std::string> kept = coverageOf(now);
  std::erase_if(lost, [&](const std::string& item) {
    // All joints of a device are each of them.
    return kept.contains(item) || kept.contains(item.substr(0, item.find('/')) + "/*");
  });
  const std::set<std::string> all = lost;
  std::erase_if(lost, [&](const std::string& item) {
    const std::size_t slash = item.find('/');
    return slash != item.npos && all.contains(item.substr(0, slash));
  });
  if (lost.empty()) return {};
  if (lost.size() == 1) return coveredText(*lost.begin()) + " is no longer judged; ";
  return fmt::format("{} and {} more are no longer judged; ", coveredText(*lost.begin()),
                     lost.size() - 1);
}

/// The first picture not among `others`; the first one when all are.
const AcceptedPicture& unlike(const Pictures& pictures, const Pictures& others) {
  const auto pixels = pixelsOf(others);
  const auto found = std::ranges::find_if(
      pictures, [&](const AcceptedPicture* one) { return !pixels.contains(one->pixels); });
  return found == pictures.end() ? *pictures.front() : **found;
}

std::string acceptedText(const AcceptedPicture& accepted) {
  return fmt::format("accepted by {} on {}: {}", plainText(accepted.accepted_by),
                     plainText(accepted.accepted_at), plainText(accepted.reason));
}

/// Reads the picture; on an error sets the frame's rule and returns empty.
std::optional<Picture> readOrTell(const ReadAccepted& read, const AcceptedPicture& accepted,
                                  JudgedFrame& judged) {
  auto picture = read(accepted);
  if (picture.ok()) return std::move(*picture);
  judged.verdict = FrameVerdict::incomparable;
  judged.rule = picture.error().text();
  return std::nullopt;
}

}  // namespace

std::string safeName(const std::string& name) {
  std::string safe = name.substr(0, 200);
  for (char& c : safe) {
    if (!isFileText({&c, 1})) c = '_';
  }
  if (safe.empty() || safe.front() == '.') safe.insert(0, "_");
  return safe;
}

std::vector<JudgedFrame> manifestChanges(const Manifest& then, const ReadAccepted& read_then,
                                         const Manifest& now, const ReadAccepted& read_now,
                                         const std::string& since) {
  std::vector<JudgedFrame> frames;
  const auto cases = casesAndKeys(then, now);
  std::set<std::string> once, several;
  for (const auto& [name, key] : cases) {
    if (!once.insert(name).second) several.insert(name);
  }
  for (const auto& [name, key] : cases) {
    const Pictures old = then.find(name, key);
    const Pictures current = now.find(name, key);
    JudgedFrame& judged = frames.emplace_back();
    judged.frame.case_name = safeName(name);
    // Goldens of two renderers become two frames.
    judged.frame.name = judged.frame.case_name;
    if (several.contains(name)) judged.frame.name += "." + keyDigits(key);
    judged.key = key;
    judged.limit_from = "the comparison of revisions";
    if (!old.empty()) judged.golden = unlike(old, current);
    if (!current.empty()) {
      const AcceptedPicture& shown = old.empty() ? *current.front() : unlike(current, old);
      judged.pixels = shown.pixels;
      judged.inputs = shown.inputs;
      judged.session = shown.session;
      judged.decoded = shown.decoded;
    }
    const bool is_equal = pixelsOf(old) == pixelsOf(current);
    const std::string lost = current.empty() ? "" : lostText(old, current);
    if (is_equal && lost.empty()) {
      judged.verdict = FrameVerdict::same;
      judged.rule = "equal pixel hash";
    } else if (current.empty()) {
      judged.verdict = FrameVerdict::missing;
      judged.rule = "removed since " + since;
      judged.accepted = readOrTell(read_then, *judged.golden, judged);
    } else if (old.empty()) {
      judged.verdict = FrameVerdict::missing;
      judged.rule = fmt::format("new since {}, {}", since, acceptedText(*current.front()));
      judged.drawn = readOrTell(read_now, *current.front(), judged);
    } else {
      const AcceptedPicture& shown = unlike(current, old);
      judged.drawn = readOrTell(read_now, shown, judged);
      judged.accepted = readOrTell(read_then, *judged.golden, judged);
      if (!judged.drawn || !judged.accepted) continue;
      judged.comparison = compare(*judged.drawn, *judged.accepted, Tolerance::exactly());
      judged.verdict = FrameVerdict::different;
      const std::string_view pixels = is_equal ? "equal pixel hash"
                                      : judged.comparison.verdict == Verdict::same
                                          ? "a different number of accepted pictures"
                                          : std::string_view(judged.comparison.rule);
      judged.rule = fmt::format("{}{} since {}, {}", lost, pixels, since, acceptedText(shown));
    }
  }
  return frames;
}

}  // namespace rocinante
