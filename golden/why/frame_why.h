#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "golden/why/link_change.h"
#include "golden/why/state_change.h"

namespace rocinante {

/// Source of the golden's side of an explanation.
enum class GoldenBasis : std::uint8_t {
  redrawn,  ///< its cell and session reproduced the accepted pixels exactly
  inputs,   ///< its cell and session, drawn by a different renderer
  guessed   ///< not available: today's identity is used and movements are estimated
};

/// Why a frame differs from its golden (docs/golden-suites.md, "Why").
struct FrameWhy {
  GoldenBasis basis = GoldenBasis::guessed;
  Blame blame;
  std::vector<StateChange> state;  ///< empty when guessed: the golden's session is unknown
  std::vector<std::string> files;  ///< changes of the model, then its changed files: ModelChange
  /// What made the picture differ, the likeliest first: changes of the model that this frame can
  /// show, else of the session, else the links whose pixels differ. Set by findCauses().
  std::vector<std::string> causes{};
  /// causes[0] without figures that differ from frame to frame; empty: causes[0].
  std::string common_cause{};
};

struct ModelChange;

/// Sets `causes` and `common_cause`. `cameras`: those that the frame is seen by. `gone`: sentences
/// about devices that the golden shows and the frame does not, the first causes of all.
void findCauses(const std::vector<ModelChange>& model, const std::vector<std::string>& cameras,
                const std::vector<std::string>& gone, FrameWhy& why);

/// A sentence about the reliability of the explanation.
std::string_view sentenceOf(GoldenBasis basis);
/// The explanation as lines of text, causes before effects, at most `rows` of each kind.
std::vector<std::string> whyLines(const FrameWhy& why, std::size_t rows = 6);

}  // namespace rocinante
