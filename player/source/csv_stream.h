#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/playback_speed.h"
#include "core/source/source.h"
#include "player/send/datagram_stream.h"
#include "player/source/csv_motion.h"

namespace rocinante {

/// Another stream up to, but not including, a moment.
class CutStream final : public DatagramStream {
 public:
  /// `stream` must outlive this.
  CutStream(DatagramStream& stream, LogTime until) : stream_(stream), until_(until) {}

  Result<std::optional<Due>> due() override {
    Result<std::optional<Due>> due = stream_.due();
    if (due && *due && (*due)->time >= until_) return std::optional<Due>();
    return due;
  }
  ByteView take() override { return stream_.take(); }

 private:
  DatagramStream& stream_;
  LogTime until_;
};

/// A table as the datagrams of a Source: first the orders, then what each row says at the row's
/// time, joints and poses changed or not, signals where they change, and every `restate` everything
/// again.
class CsvStream final : public DatagramStream {
 public:
  struct Options {
    std::string source;
    std::string run;
    Nanoseconds restate{};  ///< real time between restatements; 0: never
    PlaybackSpeed speed;    ///< of the motion, to spread restatements in real time
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

  Status openSource();
  Status setRow(std::size_t row);
  Status setSignals(std::size_t row);
  bool statesDevices(std::size_t row) const;
  bool findRow();
  Error refusal(SourceResult result, const std::string& where) const;
  Nanoseconds rowTime() const;
  std::optional<Nanoseconds> restatementTime() const;
  void makeNext();
  void flush(Nanoseconds time, Nanoseconds not_before);

  const CsvMotion* motion_;
  Options options_;
  Nanoseconds period_{};
  bool order_written_ = false;
  bool speaks_again_ = false;  ///< in turns that are not the first
  std::size_t row_ = 0;
  std::uint32_t turn_ = 0;
  /// Made but not taken; behind a pointer, as the source's send function keeps it.
  std::unique_ptr<std::deque<std::string>> made_ = std::make_unique<std::deque<std::string>>();
  Nanoseconds made_at_ = Nanoseconds::min();
  Nanoseconds real_time_{};
  std::string payload_;
  std::optional<Source> source_;
  std::vector<SourceDevice> devices_;
  std::vector<double> values_;  ///< of one device, gathered from a row
};

}  // namespace rocinante
