#include "recorder/capture/tee_set.h"

#include <cstring>
#include <utility>

#include "core/base/hash.h"

namespace rocinante {
namespace {

bool isPacketText(ByteView payload) { return textOf(payload).starts_with("RK1"); }

std::uint64_t hashOf(ByteView payload) {
  const auto digest = xxh3(payload);
  std::uint64_t hash = 0;
  std::memcpy(&hash, digest.data(), sizeof hash);
  return hash;
}

}  // namespace

bool TeeEchoes::isEcho(const ReceivedDatagram& datagram, SteadyTime now) {
  // A server does not tell who sends.
  if (!datagram.subject.empty() || !isPacketText(datagram.payload)) return false;
  const std::uint64_t hash = hashOf(datagram.payload);
  if (const auto known = forwarded_.find(hash);
      known != forwarded_.end() && known->second.sender != datagram.sender) {
    if (count_++ == 0) {
      news_ = "packets that --tee forwarded come back from " + datagram.sender.text() +
              ": recorders form a circle, or a source is heard by two ways; they are recorded and "
              "not forwarded again";
    }
    return true;
  }
  forwarded_.insert_or_assign(hash, Forwarded{now, datagram.sender});
  order_.emplace_back(now, hash);
  return false;
}

std::span<const ReceivedDatagram> TeeEchoes::firsts(std::span<const ReceivedDatagram> batch,
                                                    SteadyTime now) {
  while (!order_.empty() && (now - order_.front().first > kSpan || order_.size() > kPackets)) {
    const auto [time, hash] = order_.front();
    order_.pop_front();
    const auto found = forwarded_.find(hash);
    if (found != forwarded_.end() && found->second.time == time) forwarded_.erase(found);
  }
  const std::uint64_t before = count_;
  firsts_.clear();
  for (const ReceivedDatagram& each : batch) {
    if (!isEcho(each, now)) firsts_.push_back(each);
  }
  return count_ == before ? batch : std::span<const ReceivedDatagram>(firsts_);
}

std::optional<std::string> TeeEchoes::news() { return std::exchange(news_, std::nullopt); }

Result<TeeSet> TeeSet::open(const std::vector<Endpoint>& endpoints) {
  TeeSet set;
  for (const Endpoint& each : endpoints) {
    auto tee = Tee::open(each);
    if (!tee) return tee.error();
    set.tees_.push_back(std::move(*tee));
  }
  return set;
}

void TeeSet::forward(std::span<const ReceivedDatagram> batch) {
  if (tees_.empty()) return;
  const auto firsts = echoes_.firsts(batch, std::chrono::steady_clock::now());
  for (const auto& each : tees_) each->forward(firsts);
}

std::vector<SocketAddress> TeeSet::localAddresses() const {
  std::vector<SocketAddress> addresses;
  for (const auto& each : tees_) {
    if (each->localAddress()) addresses.push_back(*each->localAddress());
  }
  return addresses;
}

Status TeeSet::check(const std::vector<DatagramSource*>& sources) const {
  for (const auto& each : tees_) {
    if (Status checked = checkTee(each->account().to, sources, each->serverId()); !checked)
      return checked;
  }
  return {};
}

std::vector<std::string> TeeSet::news() {
  std::vector<std::string> all;
  for (const auto& each : tees_) {
    if (auto news = each->news()) all.push_back(std::move(*news));
  }
  return all;
}

std::vector<Tee::Account> TeeSet::accounts() const {
  std::vector<Tee::Account> accounts;
  for (const auto& each : tees_) {
    accounts.push_back(each->account());
    accounts.back().looped = echoes_.count();
  }
  return accounts;
}

}  // namespace rocinante
