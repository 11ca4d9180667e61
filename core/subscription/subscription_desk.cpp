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
  Guests::value_type* const guest = guestFor(from, now);
  if (guest == nullptr && request.verb == SubscriptionVerb::subscribe) {
    return refuse(request, "too many subscribers came and left: try again in 5 s");
  }
  if (guest == nullptr || !mayAsk(guest->second, now)) {
    ++counts_.ignored;
    return {};
  }
  if (!options_.allow.allows(from)) return refuse(request, "this address is not allowed");
  switch (request.verb) {
    case SubscriptionVerb::subscribe:
      return subscribe(request, *guest, now);
    case SubscriptionVerb::keep:
      return keep(request, *guest, now);
    default:
      return leave(*guest, now);
  }
}

SubscriptionDesk::HostKey SubscriptionDesk::hostOf(const SocketAddress& address) {
  HostKey host{};
  const std::size_t bytes = address.is_ipv6 ? 8 : address.address.size();
  std::copy_n(address.address.begin(), bytes, host.begin());
  host.back() = address.is_ipv6 ? 6 : 4;
  return host;
}

SubscriptionDesk::Guests::value_type* SubscriptionDesk::guestFor(const SocketAddress& from,
                                                                 SteadyTime now) {
  if (const auto found = guests_.find(from); found != guests_.end()) return &*found;
  const auto has_room = [&] {
    const auto host = hosts_.find(hostOf(from));
    return guests_.size() < options_.subscribers + options_.departed &&
           (host == hosts_.end() ||
            host->second.others < std::max<std::size_t>(options_.departed / 2, 1));
  };
  if (!has_room()) forgetDeparted(now);
  if (!has_room()) return nullptr;
  Guest guest;
  guest.asked = now;
  guest.until = now + kGreetingGap;
  ++hosts_[hostOf(from)].others;
  return &*guests_.emplace(from, std::move(guest)).first;
}

void SubscriptionDesk::setSubscribed(Guests::value_type& guest, bool subscribed) {
  if (guest.second.subscribed == subscribed) return;
  guest.second.subscribed = subscribed;
  Host& host = hosts_[hostOf(guest.first)];
  if (subscribed) {
    --host.others;
    ++host.subscribers;
    ++subscribers_;
  } else {
    ++host.others;
    --host.subscribers;
    --subscribers_;
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
                                                      Guests::value_type& who, SteadyTime now) {
  Guest& guest = who.second;
  const bool is_new = !guest.subscribed;
  if (is_new && subscribers_ >= options_.subscribers) {
    return refuse(request, "this relay has as many subscribers as it takes");
  }
  if (is_new && hosts_[hostOf(who.first)].subscribers >= options_.of_host) {
    return refuse(request, "this host has as many subscriptions as one host gets");
  }
  Outcome outcome;
  outcome.wish = request.wish;
  if (is_new) {
    outcome.change = Change::begun;
  } else {
    outcome.change = guest.wish == outcome.wish ? Change::repeated : Change::replaced;
  }
  setSubscribed(who, true);
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

SubscriptionDesk::Outcome SubscriptionDesk::keep(const SubscriptionMessage& request,
                                                 Guests::value_type& who, SteadyTime now) {
  Guest& guest = who.second;
  if (!guest.subscribed || guest.until <= now) return refuse(request, "no subscription");
  guest.until = now + std::chrono::seconds(guest.lease_s);
  SubscriptionMessage answer = answerTo(request, SubscriptionVerb::kept);
  answer.lease_s = guest.lease_s;
  answer.cookie = mint_.cookieFor(who.first, now);
  Outcome outcome;
  outcome.answer = written(answer);
  return outcome;
}

SubscriptionDesk::Outcome SubscriptionDesk::leave(Guests::value_type& who, SteadyTime now) {
  if (!who.second.subscribed) return {};
  setSubscribed(who, false);
  who.second.until = now + kGreetingGap;
  Outcome outcome;
  outcome.change = Change::ended;
  return outcome;
}

std::vector<SocketAddress> SubscriptionDesk::expire(SteadyTime now) {
  std::vector<SocketAddress> ended;
  if (now - swept_ < std::chrono::milliseconds(100)) return ended;
  swept_ = now;
  for (auto& guest : guests_) {
    if (!guest.second.subscribed || guest.second.until > now) continue;
    leave(guest, now);
    ended.push_back(guest.first);
  }
  forgetDeparted(now);
  return ended;
}

void SubscriptionDesk::forgetDeparted(SteadyTime now) {
  std::erase_if(guests_, [&](const auto& each) {
    if (each.second.subscribed || each.second.until > now) return false;
    const auto host = hosts_.find(hostOf(each.first));
    if (--host->second.others == 0 && host->second.subscribers == 0) hosts_.erase(host);
    return true;
  });
}

}  // namespace rocinante
