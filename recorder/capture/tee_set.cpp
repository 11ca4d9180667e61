#include "recorder/capture/tee_set.h"

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

std::vector<SocketAddress> TeeSet::localAddresses() const {
  std::vector<SocketAddress> addresses;
  for (const auto& each : tees_) {
    if (each->localAddress()) addresses.push_back(*each->localAddress());
  }
  return addresses;
}

Status TeeSet::check(const std::vector<DatagramSource*>& sources) const {
  for (const auto& each : tees_) {
    if (Status checked = checkTee(each->account().to, sources); !checked) return checked;
  }
  return {};
}

std::vector<Tee::Account> TeeSet::accounts() const {
  std::vector<Tee::Account> accounts;
  for (const auto& each : tees_) accounts.push_back(each->account());
  return accounts;
}

}  // namespace rocinante
