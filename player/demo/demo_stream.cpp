#include "player/demo/demo_stream.h"

namespace rocinante {

void DemoStream::makeTurn(std::uint32_t turn) {
  turn_ = turn;
  next_ = 0;
  DemoOptions how;
  how.epoch_ns = options_.epoch_ns;
  how.run = options_.run;
  how.turn = turn;
  how.mtu_bytes = options_.mtu_bytes;
  datagrams_ = demoDatagrams(options_.parts, how);
}

Result<std::optional<Due>> DemoStream::due() {
  if (next_ == datagrams_.size()) {
    if (turn_ + 1 == options_.turns || datagrams_.empty()) return std::optional<Due>();
    makeTurn(turn_ + 1);
  }
  return std::optional(Due{LogTime(datagrams_[next_].at), turn_, false});
}

}  // namespace rocinante
