#include "recorder/spy/shown_datagram.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "core/base/hash.h"
#include "core/base/plain_text.h"
#include "core/packet/item_text.h"

namespace rocinante {
namespace {

constexpr std::size_t kFirstBytes = 16;
constexpr std::size_t kShownBytes = 200;

}  // namespace

std::string shownText(std::string_view text) {
  const std::string plain = plainText(text.substr(0, kShownBytes));
  return text.size() > kShownBytes ? plain + "..." : plain;
}

std::string firstBytes(ByteView payload) {
  if (payload.empty()) return "an empty datagram";
  const ByteView first = payload.first(std::min(payload.size(), kFirstBytes));
  if (isUtf8(first)) return fmt::format("\"{}\"", plainText(textOf(first)));
  return hexOf(first);
}

std::string senderText(const ReceivedDatagram& datagram) {
  return datagram.subject.empty() ? datagram.sender.text() : plainText(datagram.subject);
}

SpySignal shownSignal(const SignalItem& item) {
  const SignalValue& value = item.item.value;
  SpySignal seen;
  seen.name = signalNameText(item.device, item.name);
  seen.value = shownText(statementText(item).substr(seen.name.size() + 1));
  seen.kind = value.kind;
  seen.number = value.number;
  seen.text = value.text;
  seen.unit = value.unit;
  seen.source = item.owner();
  return seen;
}

}  // namespace rocinante
