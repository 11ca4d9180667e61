#pragma once

#include <string>
#include <string_view>

namespace rocinante {

/// The header word `through=A,B,...` of what newest-wins cannot judge (docs/programs/relay.md,
/// "Loops"): the names, percent-encoded, of the relays that a datagram has passed.
inline constexpr std::size_t kMaxRelays = 8;

/// The value of the word in packet text; empty when its header has none.
std::string_view throughOf(std::string_view packet);

/// True when the encoded `name` is one of `through`.
bool hasPassed(std::string_view through, std::string_view name);

/// True when `through` names more than kMaxRelays.
bool isTooLong(std::string_view through);

/// `through` with `name` after it.
std::string throughWith(std::string_view through, std::string_view name);

/// The packet text with `name` added to its word, which is made when it has none.
std::string withThrough(std::string_view packet, std::string_view name);

}  // namespace rocinante
