#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/packet/packet_text.h"
#include "core/packet/session_state.h"
#include "player/send/datagram_stream.h"
#include "player/source/csv_motion.h"

namespace rocinante {

/// A table of joint values as the packets of one source: first `order`, then one packet per row at
/// the row's time, and every `restate` a restatement of the source's state.
class CsvStream final : public DatagramStream {
 public:
  struct Options {
    std::string device;
    std::string source;
    std::string run;
    Nanoseconds restate{};  ///< between restatements, in the motion's time; 0: never
    std::size_t mtu_bytes = 1200;
    std::uint32_t turns = 1;  ///< 0: endless
    /// Gives TIME when sending; empty: TIME is the file's own time.
    std::function<WallTime()> wall_now;
  };

  /// bad_argument when a row does not fit the MTU or a name is invalid. `motion` must outlive this.
  static Result<CsvStream> open(const CsvMotion& motion, Options options);

  Result<std::optional<Due>> due() override;
  ByteView take() override;

  /// Length of one turn: the file's span plus one mean step, so that turns join evenly.
  Nanoseconds period() const { return period_; }

 private:
  CsvStream(const CsvMotion& motion, Options options);

  Nanoseconds rowTime() const;
  std::optional<std::int64_t> timeToSay(Nanoseconds time) const;
  void takeRow();
  void takeRestatement();
  void fold(Nanoseconds time);

  const CsvMotion* motion_;
  Options options_;
  std::string encoded_device_;
  Nanoseconds period_{};
  bool order_said_ = false;
  std::size_t row_ = 0;
  std::uint32_t turn_ = 0;
  std::uint64_t sequence_ = 0;
  std::uint64_t restatements_ = 0;
  Nanoseconds next_restatement_{};
  bool restating_ = false;
  std::vector<std::string> parts_;  ///< remaining parts of the restatement being sent
  std::size_t parts_taken_ = 0;
  std::string payload_;
  std::unique_ptr<PacketTextDecoder> decoder_;
  SessionState state_;  ///< everything sent so far, as a receiver has it
};

}  // namespace rocinante
