#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/net/datagram_sink.h"
#include "core/source/source.h"

namespace rocinante {

/// How a window that drives devices names itself as a source.
struct DriveSettings {
  std::string source = "hand";  ///< SOURCE
  std::string run;              ///< RUN; empty: a random one
};

/// Sends joint values as an ordinary source: `joints DEVICE`, and everything again every two
/// seconds. Values may be set as often as a mouse moves; at most 30 datagrams a second leave for
/// each device. Never waits: what the system has no room for is lost, and restated. Main thread.
class HandDrive {
 public:
  /// At most this often is what changed sent.
  static constexpr Nanoseconds kPeriod{1'000'000'000 / 30};

  /// Fails as openSink() does; bad_argument for an invalid SOURCE.
  static Result<HandDrive> open(const Endpoint& to, const DriveSettings& settings);
  /// The same into a sink that is already open.
  static Result<HandDrive> into(std::unique_ptr<DatagramSink> sink, const DriveSettings& settings);

  /// Positional values of a device, to be sent when they are due; refused ones are told by
  /// trouble().
  void set(const std::string& device, std::span<const double> values);
  /// Sends what is due at `now`; `wall` becomes TIME. To be called at least ten times a second.
  void tick(SteadyTime now, WallTime wall);
  /// Sends what changed, due or not.
  void finish(SteadyTime now, WallTime wall);

  const Endpoint& endpoint() const { return sink_->endpoint(); }
  const std::string& source() const { return name_; }
  std::uint64_t sent() const { return source_.sent(); }
  bool drives(const std::string& device) const { return devices_.contains(device); }
  std::vector<std::string> devices() const;
  /// Why the last datagram was not sent, or values were refused; empty when all is well.
  const std::string& trouble() const { return *trouble_; }

 private:
  struct Driven {
    SourceDevice device;
    std::vector<double> values;
  };

  HandDrive(std::unique_ptr<DatagramSink> sink, std::unique_ptr<std::string> trouble, Source source,
            std::string name)
      : sink_(std::move(sink)),
        trouble_(std::move(trouble)),
        source_(std::move(source)),
        name_(std::move(name)) {}

  // Borrowed by the source's Send, so they do not move.
  std::unique_ptr<DatagramSink> sink_;
  std::unique_ptr<std::string> trouble_;
  Source source_;
  std::string name_;
  std::map<std::string, Driven, std::less<>> devices_;
  bool changed_ = false;
  std::optional<SteadyTime> flushed_at_;
};

}  // namespace rocinante
