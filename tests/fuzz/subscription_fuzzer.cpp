// Datagrams at a relay's --serve endpoint, separated by an empty line: each is sent once as it came
// and once with a valid cookie. What is read is written and read again; an unproven request never
// gets more bytes than it has; memory keeps its limits.
#include <cstdlib>
#include <string_view>

#include "core/subscription/subscription_desk.h"

namespace {

using namespace rocinante;

void require(bool holds) {
  if (!holds) std::abort();
}

void writeAndReadAgain(const SubscriptionMessage& message) {
  const std::string text = subscriptionText(message, kSubscribeBytes);
  const auto again = readSubscription(bytesOf(text));
  require(again.ok() && subscriptionText(*again, kSubscribeBytes) == text);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view rest(reinterpret_cast<const char*>(data), size);
  const CookieMint mint(CookieMint::Key{});
  SubscriptionDesk::Options options;
  options.relay = "site";
  options.run = "r";
  options.subscribers = 2;
  options.departed = 2;
  SubscriptionDesk desk(options, mint);
  SteadyTime now{};
  SocketAddress from;
  while (!rest.empty()) {
    const std::size_t end = rest.find("\n\n");
    const ByteView datagram = bytesOf(rest.substr(0, end));
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 2);
    now += std::chrono::milliseconds(700);
    from.port = static_cast<std::uint16_t>(datagram.size() % 8);
    auto message = readSubscription(datagram);
    if (!message) {
      require(desk.handle(datagram, from, now).answer.empty());
      continue;
    }
    writeAndReadAgain(*message);
    const bool proven = mint.accepts(message->cookie, from, now);
    const auto outcome = desk.handle(datagram, from, now);
    require(proven || outcome.answer.size() <= datagram.size());
    message->cookie = mint.cookieFor(from, now);
    const std::string text = subscriptionText(*message, kSubscribeBytes);
    const std::string answer = desk.handle(bytesOf(text), from, now).answer;
    require(answer.empty() || readSubscription(bytesOf(answer)).ok());
    require(desk.subscribers() <= 2);
    desk.expire(now);
  }
  return 0;
}
