#include "core/subscription/subscription_desk.h"

#include <algorithm>
#include <cstring>
#include <string_view>
#include <utility>

namespace rocinante {
namespace {

using Change = SubscriptionDesk::Outcome::Change;

bool isRequest(SubscriptionVerb verb) {
  return verb == SubscriptionVerb::subscribe || verb == SubscriptionVerb::keep ||
         verb == SubscriptionVerb::leave;
}

SubscriptionMessage answerTo(const SubscriptionMessage& request, SubscriptionVerb verb) {
  SubscriptionMessage answer;
  answer.verb = verb;
  answer.id = request.id;
  return answer;
}

/// Takes one of the tokens, which grow by `per_second` up to one second's; false when there is
/// none.
bool take(double& tokens, SteadyTime& taken, double per_second, SteadyTime now) {
  tokens = std::min(per_second, tokens + secondsOf(now - taken) * per_second);
  taken = now;
  if (tokens < 1) return false;
  tokens -= 1;
  return true;
}

}  // namespace

SubscriptionDesk::SubscriptionDesk(Options options, CookieMint mint)
    : options_(std::move(options)), mint_(mint) {}

std::size_t SubscriptionDesk::AddressHash::operator()(const SocketAddress& address) const {
  std::string_view bytes(reinterpret_cast<const char*>(address.address.data()),
                         address.address.size());
  const std::size_t hash = std::hash<std::string_view>()(bytes);
  return hash ^ (std::size_t{address.port} * 0x9E3779B97F4A7C15U) ^ address.scope_id;
}

bool SubscriptionDesk::mayAsk(Guest& guest, SteadyTime now) {
  return take(guest.requests, guest.asked, kRequestsPerSecond, now);
}

bool SubscriptionDesk::maySignChallenge(SteadyTime now) {
  return options_.sign && take(signable_challenges_, challenged_, kSignedChallengesPerSecond, now);
}

std::string SubscriptionDesk::written(const SubscriptionMessage& answer) const {
  std::string text = subscriptionText(answer);
  if (options_.sign) text = textOf(options_.sign(bytesOf(text)));
  return text;
}

SubscriptionDesk::Outcome SubscriptionDesk::handle(ByteView datagram, const SocketAddress& from,
                                                   SteadyTime now) {
  counts_.bytes_in += datagram.size();
  Outcome outcome = judge(datagram, from, now);
  counts_.bytes_out += outcome.answer.size();
  return outcome;
}

SubscriptionDesk::Outcome SubscriptionDesk::judge(ByteView datagram, const SocketAddress& from,
                                                  SteadyTime now) {
  const Result<SubscriptionMessage> read = readSubscription(datagram);
  if (!read || !isRequest(read->verb)) {
    ++counts_.malformed;
    return {};
  }
  const SubscriptionMessage& request = *read;
  ++counts_.requests;
  if (request.verb == SubscriptionVerb::subscribe && datagram.size() < kSubscribeBytes) {
    ++counts_.ignored;
    return {};
  }
  if (!mint_.accepts(request.cookie, from, now)) {
    return challenge(request, datagram.size(), from, now);
  }
  const auto found = guests_.find(from);
  Guest* const guest = found == guests_.end() ? nullptr : &found->second;
  if (guest != nullptr && !mayAsk(*guest, now)) {
    ++counts_.ignored;
    return {};
  }
  if (!options_.allow.allows(from)) return refuse(request, "this address is not allowed");
  switch (request.verb) {
    case SubscriptionVerb::subscribe:
      return subscribe(request, from, now);
    case SubscriptionVerb::keep:
      return keep(request, guest, from, now);
    default:
      return leave(guest, now);
  }
}

/// Never longer than the request, and nothing is stored: the sender's address may be forged.
SubscriptionDesk::Outcome SubscriptionDesk::challenge(const SubscriptionMessage& request,
                                                      std::size_t request_bytes,
                                                      const SocketAddress& from, SteadyTime now) {
  SubscriptionMessage answer = answerTo(request, SubscriptionVerb::challenge);
  answer.cookie = mint_.cookieFor(from, now);
  Outcome outcome;
  if (maySignChallenge(now)) outcome.answer = written(answer);
  if (outcome.answer.empty() || outcome.answer.size() > request_bytes) {
    outcome.answer = subscriptionText(answer);
  }
  if (outcome.answer.size() > request_bytes) {
    outcome.answer.clear();
    ++counts_.ignored;
  } else {
    ++counts_.challenged;
  }
  return outcome;
}

SubscriptionDesk::Outcome SubscriptionDesk::refuse(const SubscriptionMessage& request,
                                                   std::string sentence) {
  ++counts_.refused;
  SubscriptionMessage answer = answerTo(request, SubscriptionVerb::refused);
  answer.sentence = std::move(sentence);
  Outcome outcome;
  outcome.answer = written(answer);
  return outcome;
}

SubscriptionDesk::Outcome SubscriptionDesk::subscribe(const SubscriptionMessage& request,
                                                      const SocketAddress& from, SteadyTime now) {
  auto found = guests_.find(from);
  const bool is_new = found == guests_.end() || !found->second.subscribed;
  if (is_new && subscribers_ >= options_.subscribers) {
    return refuse(request, "this relay has as many subscribers as it takes");
  }
  if (found == guests_.end()) {
    if (guests_.size() >= options_.subscribers + options_.departed) forgetDeparted(now);
    if (guests_.size() >= options_.subscribers + options_.departed) {
      return refuse(request, "too many subscribers came and left: try again in 5 s");
    }
    found = guests_.emplace(from, Guest()).first;
    found->second.asked = now;
    found->second.requests -= 1;
  }
  Guest& guest = found->second;
  Outcome outcome;
  outcome.wish = {request.source, request.device, request.rate_hz};
  if (is_new) {
    ++subscribers_;
    outcome.change = Change::begun;
  } else {
    outcome.change = guest.wish == outcome.wish ? Change::repeated : Change::replaced;
  }
  guest.subscribed = true;
  guest.wish = outcome.wish;
  guest.lease_s = request.lease_s;
  guest.until = now + std::chrono::seconds(guest.lease_s);
  outcome.greet = !guest.greeted || now - *guest.greeted >= kGreetingGap;
  if (outcome.greet) guest.greeted = now;

  SubscriptionMessage answer = answerTo(request, SubscriptionVerb::accepted);
  answer.lease_s = request.lease_s;
  answer.restate_s = options_.restate_s;
  answer.relay = options_.relay;
  answer.run = options_.run;
  outcome.answer = written(answer);
  return outcome;
}

SubscriptionDesk::Outcome SubscriptionDesk::keep(const SubscriptionMessage& request, Guest* guest,
                                                 const SocketAddress& from, SteadyTime now) {
  if (guest == nullptr || !guest->subscribed || guest->until <= now) {
    return refuse(request, "no subscription");
  }
  guest->until = now + std::chrono::seconds(guest->lease_s);
  SubscriptionMessage answer = answerTo(request, SubscriptionVerb::kept);
  answer.lease_s = guest->lease_s;
  answer.cookie = mint_.cookieFor(from, now);
  Outcome outcome;
  outcome.answer = written(answer);
  return outcome;
}

SubscriptionDesk::Outcome SubscriptionDesk::leave(Guest* guest, SteadyTime now) {
  if (guest == nullptr || !guest->subscribed) return {};
  guest->subscribed = false;
  guest->until = now + kGreetingGap;
  --subscribers_;
  Outcome outcome;
  outcome.change = Change::ended;
  return outcome;
}

std::vector<SocketAddress> SubscriptionDesk::expire(SteadyTime now) {
  std::vector<SocketAddress> ended;
  if (now - swept_ < std::chrono::milliseconds(100)) return ended;
  swept_ = now;
  for (auto& [address, guest] : guests_) {
    if (!guest.subscribed || guest.until > now) continue;
    leave(&guest, now);
    ended.push_back(address);
  }
  forgetDeparted(now);
  return ended;
}

void SubscriptionDesk::forgetDeparted(SteadyTime now) {
  std::erase_if(guests_, [&](const auto& each) {
    return !each.second.subscribed && each.second.until <= now;
  });
}

}  // namespace rocinante
