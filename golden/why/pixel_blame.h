#pragma once

#include <set>
#include <utility>

#include "golden/why/link_change.h"
#include "viewer/picture/picture.h"
#include "viewer/render/identity_frame.h"

namespace rocinante {

/// A picture and what it shows where.
struct BlameSide {
  const Picture& picture;
  const IdentityFrame& identity;
};

/// Links that stand elsewhere in one session than in the other, as far as is known.
using MovedLinks = std::set<std::pair<std::string, std::string>>;

/// Lays each differing pixel to a link, both identities being known. Pixels that two links share,
/// as one uncovers the other, are laid to the one that moved: by `moved`, else to that whose
/// outline changed more. The same for a pixel beside the edge of one that moved, of which a sample
/// shows it. All four of one size.
Blame blameLinks(const BlameSide& golden, const BlameSide& frame, const MovedLinks& moved);

/// The same when only the frame's identity is known: each link is looked for in the golden by its
/// colours, at most `kGuessWindow` pixels away, and taken to have been there.
Blame guessBlame(const Picture& golden, const BlameSide& frame);
inline constexpr int kGuessWindow = 16;

}  // namespace rocinante
