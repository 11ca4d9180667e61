#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "golden/why/link_change.h"
#include "golden/why/state_change.h"

namespace rocinante {

/// What the golden's side of an answer was made of.
enum class GoldenBasis : std::uint8_t {
  redrawn,  ///< its cell and session, drawn again, gave the accepted pixels, bit by bit
  inputs,   ///< cell and session are those that the manifest names; the renderer is another
  guessed   ///< neither is at hand: today's identity stands for it, and movements are estimated
};

/// Why a frame is not its golden (docs/golden-suites.md, "Why").
struct FrameWhy {
  GoldenBasis basis = GoldenBasis::guessed;
  Blame blame;
  std::vector<StateChange> state;  ///< empty when guessed: the golden's session is unknown
  std::vector<std::string> files;  ///< of the model that changed; as fileChanges() says it
};

/// A sentence about how far the answer can be trusted.
std::string_view sentenceOf(GoldenBasis basis);
/// The answer as lines for people, at most `rows` of each kind.
std::vector<std::string> whyLines(const FrameWhy& why, std::size_t rows = 6);

}  // namespace rocinante
