#pragma once

#include <functional>

#include "core/net/datagram_source.h"
#include "core/pcap/fragment_table.h"
#include "core/pcap/ip_frame.h"

namespace rocinante {

/// A UDP datagram captured on its way.
struct SeenDatagram {
  SocketAddress sender, destination;
  ByteView payload;  ///< valid until the next read()
  bool cut = false;  ///< the capture did not keep all of it
};

/// Finds the UDP datagrams in captured frames and reassembles fragments. Pure; takes any bytes.
class FrameReader {
 public:
  /// The user's filter, applied to a frame. For a fragmented datagram it is called once, with the
  /// frame rebuilt without fragments: only one fragment has the ports.
  using Filter = std::function<bool(ByteView frame)>;
  enum class Filtered {
    before,  ///< frames arrive filtered, except fragments: only these are checked
    here     ///< every frame is checked
  };

  explicit FrameReader(LinkType link) : FrameReader(link, nullptr, Filtered::before) {}
  FrameReader(LinkType link, Filter filter, Filtered filtered)
      : link_(link), filter_(std::move(filter)), filtered_(filtered) {}

  /// The datagram that this frame holds or completes.
  std::optional<SeenDatagram> read(ByteView frame, WallTime time);

  /// No more frames follow: incomplete datagrams stay incomplete.
  void finish() { fragments_.clear(); }

  InputCounts counts() const;

 private:
  bool wants(ByteView frame) const { return !filter_ || filter_(frame); }
  ByteView withoutFragments(ByteView frame);

  LinkType link_;
  Filter filter_;
  Filtered filtered_;
  FragmentTable fragments_;
  IpFrame ip_;
  Bytes rebuilt_;
  InputCounts counts_;
};

}  // namespace rocinante
