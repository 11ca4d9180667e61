#include "golden/why/frame_why.h"

#include <fmt/format.h>

#include <algorithm>

namespace rocinante {
namespace {

void addLines(const std::vector<std::string>& from, std::size_t rows,
              std::vector<std::string>& lines) {
  for (std::size_t i = 0; i < std::min(rows, from.size()); ++i) lines.push_back(from[i]);
  if (from.size() > rows) lines.push_back(fmt::format("... and {} more", from.size() - rows));
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
  addLines(links, rows, lines);
  addLines(insets, rows, lines);
  std::vector<std::string> states;
  for (const StateChange& change : why.state) states.push_back(change.text);
  addLines(states, rows, lines);
  addLines(why.files, rows, lines);
  return lines;
}

}  // namespace rocinante
