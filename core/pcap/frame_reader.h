#pragma once

#include <functional>
#include <map>

#include "core/net/datagram_source.h"
#include "core/pcap/fragment_table.h"
#include "core/pcap/ip_frame.h"
#include "core/report/account.h"

namespace rocinante {

/// A UDP datagram captured on its way.
struct SeenDatagram {
  SocketAddress sender, destination;
  ByteView payload;  ///< valid until the next read()
  bool cut = false;  ///< the capture did not keep all of it
};

/// Finds the UDP datagrams in captured frames, reassembles fragments, and counts what it leaves
/// out. Pure; takes any bytes.
class FrameReader {
 public:
  /// The user's filter, applied to a frame with one header of IP and no tags: tcpdump's language
  /// has ports only there. So VLAN tags, extension headers and fragments hide no datagram from it.
  /// It is called once for each datagram.
  using Filter = std::function<bool(LinkType link, ByteView frame)>;
  enum class Filtered {
    before,  ///< frames arrive filtered, except those that the filter cannot see into
    here     ///< every frame is checked
  };

  FrameReader() : FrameReader(nullptr, Filtered::before, false) {}
  /// `keep_tags`: the filter is about VLAN tags, and gets them.
  FrameReader(Filter filter, Filtered filtered, bool keep_tags)
      : filter_(std::move(filter)), filtered_(filtered), keep_tags_(keep_tags) {}

  FrameReader(FrameReader&&) = default;
  FrameReader& operator=(FrameReader&&) = default;

  /// The datagram that this frame holds or completes. `wire_bytes`: its length before the capture
  /// cut it.
  std::optional<SeenDatagram> read(LinkType link, ByteView frame, std::size_t wire_bytes,
                                   WallTime time);
  std::optional<SeenDatagram> read(LinkType link, ByteView frame, WallTime time) {
    return read(link, frame, frame.size(), time);
  }
  /// A frame of a link type that is none of LinkType.
  void passOver(int link_type);

  /// No more frames follow: incomplete datagrams stay incomplete.
  void finish() { fragments_.clear(); }

  InputCounts counts() const;
  /// What became no datagram, by kind; the first frame's number, from 1, where they are counted
  /// from the beginning of a file.
  Account leftOut(bool is_file) const;

 private:
  struct Tally {
    std::uint64_t count = 0, first = 0;
  };
  /// What is left out and is no FrameProtocol.
  enum Reason : std::uint32_t {
    kBroken = 0x40000,   ///< breaks the rules of IP or UDP
    kCutShort,           ///< the capture kept too few bytes
    kNotChosen,          ///< by the filter
    kUdpOptions,         ///< bytes behind the datagram; the datagram is used
    kMoreKinds,          ///< beyond those that an account lists
    kLinkType = 0x80000  ///< and the number
  };

  void count(std::uint32_t kind);
  void countBroken(bool cut);
  bool filterTakes(LinkType link, ByteView frame);
  ByteView plainFrame(LinkType link, ByteView frame);

  Filter filter_;
  Filtered filtered_;
  bool keep_tags_;
  FragmentTable fragments_;
  IpFrame ip_;
  Bytes rebuilt_;
  InputCounts counts_;
  std::uint64_t frames_ = 0;
  std::map<std::uint32_t, Tally> left_out_;  ///< by FrameProtocol or Reason
  Tally* latest_ = nullptr;                  ///< of the kind that was counted last
  std::uint32_t latest_kind_ = 0;
};

}  // namespace rocinante
