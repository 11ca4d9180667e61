#include "core/net/interface_wait.h"

#include <net/if.h>

#include <set>
#include <thread>

#include "core/base/duration_text.h"
#include "core/net/interfaces.h"

namespace rocinante {
namespace {

constexpr Nanoseconds kLook = std::chrono::milliseconds(20);

/// The missing ones, "eth7, eth8"; empty when all exist.
std::string missingInterfaces(std::span<const Endpoint> endpoints) {
  std::set<std::string> missing;
  for (const Endpoint& endpoint : endpoints) {
    const std::string& name = endpoint.interface;
    // "any" is libpcap's word for all interfaces.
    if (name.empty() || (endpoint.isPcap() && name == "any")) continue;
    if (::if_nametoindex(name.c_str()) == 0) missing.insert(name);
  }
  std::string names;
  for (const std::string& name : missing) names += (names.empty() ? "" : ", ") + name;
  return names;
}

}  // namespace

Status waitForInterfaces(std::span<const Endpoint> endpoints, Nanoseconds longest,
                         const std::function<void(const std::string&)>& told,
                         const std::function<bool()>& stop) {
  const auto give_up = std::chrono::steady_clock::now() + longest;
  for (bool is_told = false;; is_told = true) {
    const std::string missing = missingInterfaces(endpoints);
    if (missing.empty()) return {};
    if (!is_told) told("waiting for the network interface " + missing);
    if (stop()) {
      return Error{ErrorKind::refused, "interrupted while waiting for a network interface",
                   missing};
    }
    if (std::chrono::steady_clock::now() >= give_up) {
      return Error{ErrorKind::refused,
                   "the network interface did not appear within " + secondsText(longest) +
                       " s; there are " + interfaceNames(),
                   missing};
    }
    std::this_thread::sleep_for(kLook);
  }
}

}  // namespace rocinante
