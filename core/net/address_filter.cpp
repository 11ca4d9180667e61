#include "core/net/address_filter.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <optional>

namespace rocinante {
namespace {

/// "8"; no sign, no leading zero.
std::optional<unsigned> prefixLength(std::string_view text, unsigned longest) {
  unsigned length = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), length);
  if (fault != std::errc() || end != text.data() + text.size()) return std::nullopt;
  if (length > longest || (text.size() > 1 && text[0] == '0')) return std::nullopt;
  return length;
}

SocketAddress masked(SocketAddress address, unsigned length) {
  for (unsigned bit = length; bit < 128; ++bit) {
    address.address[bit / 8] &= static_cast<std::uint8_t>(~(0x80U >> (bit % 8)));
  }
  return address;
}

}  // namespace

SocketAddress withoutMapping(const SocketAddress& address) {
  static constexpr std::array<std::uint8_t, 12> kMapped{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xFF, 0xFF};
  if (!address.is_ipv6 || !std::equal(kMapped.begin(), kMapped.end(), address.address.begin())) {
    return address;
  }
  SocketAddress plain;
  plain.port = address.port;
  std::copy(address.address.begin() + kMapped.size(), address.address.end(), plain.address.begin());
  return plain;
}

AddressFilter::Words AddressFilter::wordsOf(const SocketAddress& address) {
  Words words;
  std::memcpy(&words.high, address.address.data(), 8);
  std::memcpy(&words.low, address.address.data() + 8, 8);
  return words;
}

Status AddressFilter::add(std::string_view cidr) {
  const auto bad = [&](std::string reason) {
    return Error{ErrorKind::bad_argument, std::move(reason), std::string(cidr.substr(0, 100))};
  };
  const std::size_t slash = cidr.find('/');
  const auto address = SocketAddress::parse(cidr.substr(0, slash), 0);
  if (!address) return bad("a network is ADDRESS/BITS: " + address.error().what);
  if (address->scope_id != 0) return bad("a network has no zone after %");
  const unsigned longest = address->is_ipv6 ? 128 : 32;
  unsigned length = longest;
  if (slash != cidr.npos) {
    const auto given = prefixLength(cidr.substr(slash + 1), longest);
    if (!given) return bad(fmt::format("the prefix length must be a number from 0 to {}", longest));
    length = *given;
  }
  const SocketAddress network = masked(*address, length);
  if (network != *address) {
    return bad(fmt::format("this has bits beyond its prefix: is it {}/{} or {}/{}?",
                           network.hostText(), length, address->hostText(), longest));
  }
  SocketAddress ones;
  ones.address.fill(0xFF);
  networks_.push_back({address->is_ipv6, wordsOf(network), wordsOf(masked(ones, length))});
  return {};
}

Result<AddressFilter> AddressFilter::of(const std::vector<std::string>& networks) {
  AddressFilter filter;
  for (const std::string& each : networks) {
    if (Status added = filter.add(each); !added) return added.error();
  }
  return filter;
}

bool AddressFilter::allows(const SocketAddress& sender) const {
  if (networks_.empty()) return true;
  const SocketAddress plain = withoutMapping(sender);
  if (plain.is_ipv6 != sender.is_ipv6 && allows(plain)) return true;
  const Words words = wordsOf(sender);
  for (const Network& each : networks_) {
    if (each.is_ipv6 == sender.is_ipv6 && (words.high & each.mask.high) == each.bits.high &&
        (words.low & each.mask.low) == each.bits.low) {
      return true;
    }
  }
  return false;
}

}  // namespace rocinante
