#pragma once

#include <string>
#include <vector>

#include "player/demo/demo_motion.h"
#include "player/send/datagram_stream.h"

namespace rocinante {

/// The datagrams of the demo's motion, turn after turn without a gap.
class DemoStream final : public DatagramStream {
 public:
  struct Options {
    std::vector<DemoPart> parts;
    std::string run;
    std::int64_t epoch_ns = 0;  ///< TIME of the motion's zero
    std::size_t mtu_bytes = 1200;
    std::uint32_t turns = 0;  ///< 0: endless
  };
  explicit DemoStream(Options options) : options_(std::move(options)) { makeTurn(0); }

  Result<std::optional<Due>> due() override;
  ByteView take() override { return bytesOf(datagrams_[next_++].payload); }

 private:
  void makeTurn(std::uint32_t turn);

  Options options_;
  std::uint32_t turn_ = 0;
  std::vector<DemoDatagram> datagrams_;  ///< of the current turn
  std::size_t next_ = 0;
};

}  // namespace rocinante
