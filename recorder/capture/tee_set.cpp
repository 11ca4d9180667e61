#include "recorder/capture/tee_set.h"

#include <utility>

namespace rocinante {

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
