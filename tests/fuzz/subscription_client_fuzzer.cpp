// What a relay, or who pretends to be one, may answer to a subscriber: datagrams, each behind one
// byte of the tens of milliseconds that pass before it and two of its length. Ids are small, so
// that answers can hit. Whatever they hold, no RKS1 line is passed on, every request can be read,
// and no more are sent than may be.
#include <algorithm>
#include <cstdlib>

#include "core/subscription/subscription_client.h"

namespace {

using namespace rocinante;

void require(bool holds) {
  if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  ByteView bytes(reinterpret_cast<const std::byte*>(data), size);
  const auto number = [&](std::size_t at) { return std::to_integer<std::size_t>(bytes[at]); };
  static const Endpoint endpoint =
      Endpoint::parse("subscribe://10.0.0.1:5?device=a*&rate=2").value();
  const SteadyTime start{std::chrono::seconds(1)};
  SteadyTime now = start;
  std::uint64_t id = 0;
  SubscriptionClient client(
      endpoint, [&] { return ++id; }, now);
  double requests = 0;
  while (bytes.size() >= 3) {
    now += std::chrono::milliseconds(10 * number(0));
    const std::size_t length = std::min(number(1) << 8U | number(2), bytes.size() - 3);
    // A buffer of its own: reading one byte beyond shows.
    const Bytes datagram(bytes.begin() + 3,
                         bytes.begin() + 3 + static_cast<std::ptrdiff_t>(length));
    bytes = bytes.subspan(3 + length);
    if (length % 4 == 3) client.noteUntrusted(datagram, Untrusted::forged);
    const auto arrival = client.take(now, endpoint.address, datagram);
    require(arrival != SubscriptionClient::Arrival::stranger);
    require((arrival == SubscriptionClient::Arrival::traffic) != isSubscriptionText(datagram));
    if (const auto request = client.nextRequest(now)) {
      ++requests;
      require(request->size() >= kSubscribeBytes);
      require(readSubscription(bytesOf(*request)).ok());
    }
    if (const auto news = client.takeNews()) require(news->size() < 2'000);
  }
  require(requests <= SubscriptionClient::kBurst +
                          SubscriptionClient::kRequestsPerSecond * secondsOf(now - start) + 1e-6);
  if (const auto leave = client.leave()) require(readSubscription(bytesOf(*leave)).ok());
  return 0;
}
