#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/foreign/session/message_sink.h"

namespace rocinante {

// Texts of the subprotocol foxglove.websocket.v1
// (https://github.com/foxglove/ws-protocol/blob/main/docs/spec.md).

/// What a client asks for.
struct FoxgloveRequest {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> subscribe;  ///< its number, the channel's
  std::vector<std::uint32_t> unsubscribe;                          ///< its numbers
};

/// bad_argument, with a sentence for the client, for what is malformed or not to be had here.
Result<FoxgloveRequest> parseFoxgloveRequest(std::string_view text);

enum class FoxgloveLevel { info, warning, error };

std::string foxgloveServerInfo(std::string_view session);
std::string foxgloveStatus(FoxgloveLevel level, std::string_view sentence);
/// A channel as `advertise` lists it.
std::string foxgloveChannel(std::uint32_t id, std::string_view topic, const MessageSchema& schema);
/// `advertise` of such texts.
std::string foxgloveAdvertise(const std::vector<std::string_view>& channels);
std::string foxgloveUnadvertise(const std::vector<std::uint32_t>& channels);

}  // namespace rocinante
