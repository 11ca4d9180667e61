#include "core/pcap/frame_reader.h"

#include <algorithm>

namespace rocinante {
namespace {

constexpr unsigned kUdpHeader = 17;
/// As many as an account lists: a hostile capture has any number.
constexpr std::size_t kMaxKinds = Account::kMaxListed - 8;

}  // namespace

void FrameReader::count(std::uint32_t kind) {
  // Kinds come in rows: 10,000 TCP frames, one ARP.
  if (latest_ == nullptr || latest_kind_ != kind) {
    const bool is_new = left_out_.size() >= kMaxKinds && !left_out_.contains(kind);
    latest_ = &left_out_[is_new ? std::uint32_t{kMoreKinds} : kind];
    latest_kind_ = kind;
  }
  if (latest_->count++ == 0) latest_->first = frames_;
}

void FrameReader::countBroken(bool cut) {
  ++counts_.malformed;
  count(cut ? kCutShort : kBroken);
}

void FrameReader::passOver(int link_type) {
  ++frames_;
  ++counts_.other;
  count(kLinkType + (static_cast<std::uint32_t>(link_type) & 0xFFFFU));
}

std::optional<SeenDatagram> FrameReader::read(LinkType link, ByteView frame, std::size_t wire_bytes,
                                              WallTime time) {
  ++frames_;
  const bool is_cut = frame.size() < wire_bytes;
  switch (readIpFrame(link, frame, ip_)) {
    case FrameKind::other:
      ++counts_.other;
      count(ip_.other);
      return std::nullopt;
    case FrameKind::malformed:
      countBroken(is_cut);
      return std::nullopt;
    case FrameKind::udp:
      break;
  }
  if (ip_.is_fragment) {
    const Fragment fragment{ip_.source, ip_.destination,     ip_.fragment_id,
                            ip_.link,   ip_.fragment_offset, ip_.more_fragments,
                            time,       ip_.payload};
    // The missing bytes of a cut fragment cannot be known.
    const auto outcome = ip_.cut ? FragmentTable::Outcome::malformed : fragments_.add(fragment);
    if (outcome == FragmentTable::Outcome::malformed) countBroken(ip_.cut);
    if (outcome != FragmentTable::Outcome::whole) return std::nullopt;
    ip_.payload = fragments_.whole();
    ip_.is_fragment = false;
    const FrameKind inner = ip_.next_header == kUdpHeader ? FrameKind::udp : skipExtensions(ip_);
    if (inner == FrameKind::other) {
      ++counts_.other;
      count(ip_.other);
      return std::nullopt;
    }
    if (inner == FrameKind::malformed || ip_.is_fragment) {
      countBroken(false);
      return std::nullopt;
    }
    ip_.is_fragment = true;
  }
  if (filter_ && !filterTakes(link, frame)) {
    count(kNotChosen);
    return std::nullopt;
  }
  const auto udp = readUdp(ip_.payload, ip_.source.is_ipv6, ip_.cut);
  if (!udp) {
    countBroken(ip_.cut);
    return std::nullopt;
  }
  if (udp->surplus > 0) count(kUdpOptions);
  SeenDatagram seen{ip_.source, ip_.destination, udp->bytes, udp->cut};
  seen.sender.port = udp->source_port;
  seen.destination.port = udp->destination_port;
  return seen;
}

bool FrameReader::filterTakes(LinkType link, ByteView frame) {
  const bool is_plain = !ip_.is_fragment && !ip_.extended && (ip_.tags == 0 || keep_tags_);
  if (is_plain) return filtered_ == Filtered::before || filter_(link, frame);
  return filter_(link, plainFrame(link, frame));
}

/// The frame as if the datagram had no fragments, no extension headers and, but for a filter that
/// is about them, no tags.
ByteView FrameReader::plainFrame(LinkType link, ByteView frame) {
  const bool is_ipv6 = ip_.source.is_ipv6;
  const std::size_t header = is_ipv6 ? 40 : 20;
  ByteView before = frame.first(ip_.header_at);
  const LinkHeader link_header = linkHeaderOf(link);
  const bool drops_tags = ip_.tags > 0 && !keep_tags_;
  if (drops_tags) before = before.first(link_header.bytes);
  rebuilt_.assign(before.begin(), before.end());
  const auto set = [&](std::size_t at, std::size_t value) {
    rebuilt_[at] = static_cast<std::byte>(value >> 8U & 0xFFU);
    rebuilt_[at + 1] = static_cast<std::byte>(value & 0xFFU);
  };
  if (drops_tags && link_header.type_at) set(*link_header.type_at, is_ipv6 ? 0x86DD : 0x0800);
  const std::size_t ip_at = rebuilt_.size();
  const ByteView ip_header = frame.subspan(ip_.header_at, header);
  rebuilt_.insert(rebuilt_.end(), ip_header.begin(), ip_header.end());
  rebuilt_.insert(rebuilt_.end(), ip_.payload.begin(), ip_.payload.end());
  const std::size_t length = ip_.payload.size() + (is_ipv6 ? 0 : header);
  set(ip_at + (is_ipv6 ? 4 : 2), std::min<std::size_t>(length, 65'535));
  if (is_ipv6) {
    rebuilt_[ip_at + 6] = static_cast<std::byte>(kUdpHeader);
  } else {
    rebuilt_[ip_at] = std::byte{0x45};  // without options
    set(ip_at + 6, 0);
  }
  return rebuilt_;
}

InputCounts FrameReader::counts() const {
  InputCounts counts = counts_;
  counts.incomplete = fragments_.incomplete();
  return counts;
}

Account FrameReader::leftOut(bool is_file) const {
  Account account;
  const auto leaveOut = [&](LeftOut left_out, const Tally& tally) {
    left_out.count = tally.count;
    if (is_file) left_out.first = "frame " + std::to_string(tally.first);
    account.leaveOut(std::move(left_out));
  };
  for (const auto& [kind, tally] : left_out_) {
    if (kind == kBroken) {
      leaveOut({.kind = "frame",
                .name = "malformed",
                .reason = "breaks the rules of IP or UDP",
                .severity = Severity::warning},
               tally);
    } else if (kind == kCutShort) {
      leaveOut({.kind = "frame",
                .name = "cut short",
                .reason = "the capture kept too few of its bytes (snaplen)",
                .severity = Severity::warning},
               tally);
    } else if (kind == kNotChosen) {
      leaveOut({.kind = "datagram", .reason = "not chosen by the filter"}, tally);
    } else if (kind == kUdpOptions) {
      leaveOut({.kind = "trailer",
                .name = "UDP options",
                .reason = "bytes behind the datagram are not recorded"},
               tally);
    } else if (kind == kMoreKinds) {
      leaveOut({.kind = "frame", .name = "other kinds", .reason = "not UDP"}, tally);
    } else if (kind >= kLinkType) {
      leaveOut({.kind = "frame",
                .name = "link type " + std::to_string(kind - kLinkType),
                .reason = "not supported",
                .severity = Severity::warning},
               tally);
    } else {
      leaveOut({.kind = "frame", .name = nameOf(kind), .reason = "not UDP"}, tally);
    }
  }
  if (fragments_.incomplete() > 0) {
    account.leaveOut({.kind = "datagram",
                      .name = "fragmented",
                      .reason = "some of its fragments are missing or contradict each other",
                      .count = fragments_.incomplete(),
                      .severity = Severity::warning});
  }
  return account;
}

}  // namespace rocinante
