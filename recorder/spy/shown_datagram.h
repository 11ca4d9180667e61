#pragma once

#include <string>
#include <string_view>

#include "core/base/bytes.h"
#include "core/net/datagram_source.h"
#include "core/packet/state_items.h"
#include "recorder/spy/spy_report.h"

namespace rocinante {

/// A statement or an event, cut to fit a line, without control characters.
std::string shownText(std::string_view text);
/// The first bytes, so that the user can compare them with what should have been sent.
std::string firstBytes(ByteView payload);
/// A NATS server does not tell who sends: its subjects take the place of addresses.
std::string senderText(const ReceivedDatagram& datagram);
SpySignal shownSignal(const SignalItem& item);

}  // namespace rocinante
