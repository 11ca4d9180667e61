#pragma once

#include <set>
#include <utility>

#include "golden/why/link_change.h"
#include "viewer/picture/picture.h"
#include "viewer/render/identity_frame.h"

namespace rocinante {

/// A picture and its identity frame.
struct BlameSide {
  const Picture& picture;
  const IdentityFrame& identity;
};

/// Links known to have different poses in the two sessions.
using MovedLinks = std::set<std::pair<std::string, std::string>>;

/// Attributes each differing pixel to a link, with both identities known. A pixel that two links
/// share, as one uncovers the other, goes to the link that moved according to `moved`, else to the
/// one whose outline changed more; so does a pixel beside the edge of a moved link. All four
/// pictures must have one size.
Blame blameLinks(const BlameSide& golden, const BlameSide& frame, const MovedLinks& moved);

/// The same with only the frame's identity known: each link is searched for in the golden by its
/// colours, at most `kGuessWindow` pixels away, and assumed to have been there.
Blame guessBlame(const Picture& golden, const BlameSide& frame);
inline constexpr int kGuessWindow = 16;

}  // namespace rocinante
