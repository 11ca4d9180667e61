#include "core/subscription/subscription_client.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/base/plain_text.h"

namespace rocinante {
namespace {

// An answer is late after a quarter of a second, then after half a second, then every second.
constexpr Nanoseconds kFirstRetry = std::chrono::milliseconds(250);
constexpr Nanoseconds kLastRetry = std::chrono::seconds(1);
// A relay may say anything; a subscription is kept at a sane pace all the same.
constexpr Nanoseconds kLeastRestate = std::chrono::milliseconds(500);
constexpr Nanoseconds kMaxRestate = std::chrono::seconds(kMaxLeaseSeconds);
constexpr std::size_t kSentenceBytes = 200;
constexpr std::string_view kNoSubscription = "no subscription";

Nanoseconds restateOf(double restate_s) {
  // Compared as a double: a huge one has no nanoseconds.
  if (restate_s >= secondsOf(kMaxRestate)) return kMaxRestate;
  const auto restate =
      std::chrono::duration_cast<Nanoseconds>(std::chrono::duration<double>(restate_s));
  return std::max(restate, kLeastRestate);
}

/// Completes "nothing is received until".
std::string_view remedyOf(Untrusted reason) {
  switch (reason) {
    case Untrusted::not_signed:
      return "the relay runs with --key";
    case Untrusted::unknown_key:
    case Untrusted::not_allowed:
      return "the trust file lists the relay's key with relay = true";
    case Untrusted::out_of_time:
      return "the clocks of both machines agree within 10 s";
    default:
      return "they are";
  }
}

std::string shown(std::string_view sentence) {
  return plainText(sentence.substr(0, kSentenceBytes));
}

}  // namespace

SubscriptionClient::SubscriptionClient(const Endpoint& relay, Random random, SteadyTime now,
                                       std::uint32_t lease_s)
    : relay_(relay),
      random_(std::move(random)),
      lease_s_(lease_s),
      due_(now),
      asking_since_(now),
      tokens_at_(now),
      opened_(now) {}

void SubscriptionClient::askAnew(SteadyTime now) {
  if (phase_ == Phase::subscribed) asking_since_ = now;
  phase_ = Phase::asking;
  has_pending_ = false;
  attempts_ = 0;
  due_ = now;
}

SubscriptionMessage SubscriptionClient::request(SubscriptionVerb verb) {
  SubscriptionMessage message;
  message.verb = verb;
  message.id = random_();
  message.cookie = cookie_;
  if (verb != SubscriptionVerb::subscribe) return message;
  message.lease_s = lease_s_;
  message.wish = relay_.selection;
  return message;
}

bool SubscriptionClient::spendToken(SteadyTime now) {
  tokens_ = std::min<double>(kBurst, tokens_ + secondsOf(now - tokens_at_) * kRequestsPerSecond);
  tokens_at_ = now;
  if (tokens_ < 1) return false;
  tokens_ -= 1;
  return true;
}

std::optional<std::string> SubscriptionClient::nextRequest(SteadyTime now) {
  watchLease(now);
  watchPatience(now);
  const bool is_subscribed = phase_ == Phase::subscribed;
  // A relay with nothing to say answers a `keep`: what it does not answer is not heard.
  const bool is_quiet = is_subscribed && !has_pending_ && now - heard_ >= restate_;
  if ((now < due_ && !is_quiet) || !spendToken(now)) return std::nullopt;
  if (!has_pending_ || now - first_sent_ >= kPatience) {
    pending_ = request(is_subscribed ? SubscriptionVerb::keep : SubscriptionVerb::subscribe);
    has_pending_ = true;
    first_sent_ = now;
  }
  const Nanoseconds longest = is_subscribed ? kLastRetry : kFirstRetry * (1 << attempts_);
  due_ = now + std::min(longest, kLastRetry);
  attempts_ = std::min(attempts_ + 1, 4);
  return subscriptionText(pending_, kSubscribeBytes);
}

void SubscriptionClient::watchLease(SteadyTime now) {
  if (phase_ != Phase::subscribed) return;
  if (now >= lease_until_ || now - heard_ >= 2 * restate_) askAnew(now);
}

void SubscriptionClient::watchPatience(SteadyTime now) {
  if (phase_ != Phase::asking || now - asking_since_ < kPatience) return;
  if (untrusted_) {
    tell(Report::untrusted,
         fmt::format("the answers of {} are not trusted ({}); nothing is received until {}",
                     relay_.text(), nameOf(*untrusted_), remedyOf(*untrusted_)));
    return;
  }
  tell(Report::unanswered,
       fmt::format("{} does not answer; nothing is received until it does", relay_.text()));
}

SubscriptionClient::Arrival SubscriptionClient::take(SteadyTime now, const SocketAddress& sender,
                                                     ByteView datagram) {
  if (sender != relay_.address) return Arrival::stranger;
  if (!isSubscriptionText(datagram)) {
    heard_ = now;
    return Arrival::traffic;
  }
  const Result<SubscriptionMessage> answer = readSubscription(datagram);
  if (!answer || !has_pending_ || answer->id != pending_.id) return Arrival::ignored;
  switch (answer->verb) {
    case SubscriptionVerb::subscribe:
    case SubscriptionVerb::keep:
    case SubscriptionVerb::leave:
      return Arrival::ignored;
    case SubscriptionVerb::accepted:
      if (pending_.verb != SubscriptionVerb::subscribe) return Arrival::ignored;
      break;
    case SubscriptionVerb::kept:
      if (pending_.verb != SubscriptionVerb::keep) return Arrival::ignored;
      break;
    case SubscriptionVerb::challenge:
    case SubscriptionVerb::refused:
      break;
  }
  heard_ = now;
  takeAnswer(now, *answer);
  return Arrival::answer;
}

void SubscriptionClient::noteUntrusted(ByteView datagram, Untrusted reason) {
  if (!isSubscriptionText(datagram)) return;
  const Result<SubscriptionMessage> answer = readSubscription(datagram);
  if (answer && has_pending_ && answer->id == pending_.id) untrusted_ = reason;
}

void SubscriptionClient::takeAnswer(SteadyTime now, const SubscriptionMessage& answer) {
  has_pending_ = false;
  attempts_ = 0;
  untrusted_.reset();
  switch (answer.verb) {
    case SubscriptionVerb::challenge:
      // The answer to a `keep` too: the relay restarted, or the cookie is too old.
      cookie_ = answer.cookie;
      askAnew(now);
      break;
    case SubscriptionVerb::accepted:
      accept(now, answer);
      break;
    case SubscriptionVerb::kept:
      cookie_ = answer.cookie;
      extendLease(answer.lease_s);
      break;
    default:
      refuse(now, answer.sentence);
      break;
  }
}

void SubscriptionClient::extendLease(std::uint32_t lease_s) {
  // The relay counts from its answer, which did not come before this.
  lease_until_ = first_sent_ + std::chrono::seconds(lease_s);
  due_ = first_sent_ + Nanoseconds(std::chrono::seconds(lease_s)) / 3;
}

void SubscriptionClient::accept(SteadyTime now, const SubscriptionMessage& answer) {
  if (!accepted_after_) accepted_after_ = now - opened_;
  phase_ = Phase::subscribed;
  restate_ = restateOf(answer.restate_s);
  extendLease(answer.lease_s);
  const std::string run = answer.relay + "@" + answer.run;
  const bool is_known = run == relay_run_;
  const bool is_first = relay_run_.empty();
  relay_run_ = run;
  if (is_known && reported_ == Report::subscribed) return;
  reported_ = Report::nothing;
  const std::string relay = shown(answer.relay);
  tell(Report::subscribed,
       is_first ? fmt::format("subscribed to relay {} at {}", relay, relay_.text())
       : is_known
           ? fmt::format("subscribed to relay {} at {} again", relay, relay_.text())
           : fmt::format("relay {} at {} was restarted; subscribed again", relay, relay_.text()));
}

void SubscriptionClient::refuse(SteadyTime now, const std::string& sentence) {
  const bool was_subscribed = phase_ == Phase::subscribed;
  askAnew(now);
  if (was_subscribed && sentence == kNoSubscription) return;
  due_ = now + kAfterRefusal;
  // A refusal is an answer.
  asking_since_ = due_;
  if (reported_ == Report::refused && last_refusal_ == sentence) return;
  last_refusal_ = sentence;
  reported_ = Report::nothing;
  tell(Report::refused, fmt::format("{} refused: {}; asking again every {} s", relay_.text(),
                                    sentence.empty() ? "no reason given" : shown(sentence),
                                    kAfterRefusal / std::chrono::seconds(1)));
}

void SubscriptionClient::tell(Report what, std::string sentence) {
  if (reported_ == what) return;
  reported_ = what;
  news_ = std::move(sentence);
}

std::optional<std::string> SubscriptionClient::takeNews() {
  return std::exchange(news_, std::nullopt);
}

SubscriptionOutcome SubscriptionClient::outcome() const {
  if (accepted_after_) return {accepted_after_, {}};
  if (untrusted_) {
    return {{},
            fmt::format("never accepted, its answers are not trusted ({})", nameOf(*untrusted_))};
  }
  if (!last_refusal_.empty()) return {{}, "never accepted, it refused: " + shown(last_refusal_)};
  return {{}, cookie_.empty() ? "never answered" : "never accepted"};
}

std::optional<std::string> SubscriptionClient::leave() {
  if (cookie_.empty()) return std::nullopt;
  return subscriptionText(request(SubscriptionVerb::leave), kSubscribeBytes);
}

}  // namespace rocinante
