#pragma once

#include <functional>

#include "core/net/datagram_source.h"
#include "core/pcap/fragment_table.h"
#include "core/pcap/ip_frame.h"

namespace rocinante {

/// A UDP datagram seen on its way.
struct SeenDatagram {
  SocketAddress sender, destination;
  ByteView payload;  ///< valid until the next read()
  bool cut = false;  ///< the capture did not keep all of it
};

/// Finds the UDP datagrams in captured frames, fragments put together. Pure: for any bytes.
class FrameReader {
 public:
  /// What the user's filter says of a frame. Of a datagram in fragments it is asked once, about the
  /// frame that it would be without them: only one of them has ports.
  using Filter = std::function<bool(ByteView frame)>;
  enum class Filtered {
    before,  ///< frames come filtered, but for fragments: only these are asked about
    here     ///< every frame is asked about
  };

  explicit FrameReader(LinkType link) : FrameReader(link, nullptr, Filtered::before) {}
  FrameReader(LinkType link, Filter filter, Filtered filtered)
      : link_(link), filter_(std::move(filter)), filtered_(filtered) {}

  /// The datagram that this frame holds or completes.
  std::optional<SeenDatagram> read(ByteView frame, WallTime time);

  /// No more frames come: what is incomplete stays so.
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
