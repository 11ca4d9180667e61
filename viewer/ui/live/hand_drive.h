#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "viewer/ui/live/sending_source.h"

namespace rocinante {

/// How a window that drives devices names itself as a source.
struct DriveSettings {
  std::string source = "hand";  ///< SOURCE
  std::string run;              ///< RUN; empty: a random one
};

/// Sends joint values as an ordinary source: `joints DEVICE`. Values may be set as often as a mouse
/// moves; at most 30 datagrams a second leave for each device. Main thread.
class HandDrive {
 public:
  /// As SendingSource::open().
  static Result<HandDrive> open(const Endpoint& to, const DriveSettings& settings);
  /// The same into a sink that is already open.
  static Result<HandDrive> into(std::unique_ptr<DatagramSink> sink, const DriveSettings& settings);

  /// Positional values of a device, to be sent when they are due; refused ones are told by
  /// trouble().
  void set(const std::string& device, std::span<const double> values);
  /// Sends what is due at `now`; `wall` becomes TIME. To be called at least ten times a second.
  void tick(SteadyTime now, WallTime wall) { sending_.tick(now, wall); }
  /// Sends what changed, due or not.
  void finish(SteadyTime now, WallTime wall) { sending_.finish(now, wall); }

  const Endpoint& endpoint() const { return sending_.endpoint(); }
  const std::string& source() const { return sending_.name(); }
  std::uint64_t sent() const { return sending_.sent(); }
  bool drives(const std::string& device) const { return devices_.contains(device); }
  std::vector<std::string> devices() const;
  /// Why the last datagram was not sent, or values were refused; empty when all is well.
  const std::string& trouble() const { return sending_.trouble(); }

 private:
  struct Driven {
    SourceDevice device;
    std::vector<double> values;
  };

  explicit HandDrive(SendingSource sending) : sending_(std::move(sending)) {}

  SendingSource sending_;
  std::map<std::string, Driven, std::less<>> devices_;
};

}  // namespace rocinante
