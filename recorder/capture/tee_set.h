#pragma once

#include <memory>
#include <vector>

#include "recorder/capture/tee.h"

namespace rocinante {

/// All tees of a recording; none is the rule. Each has its own queue and thread, so that a slow one
/// costs the others nothing.
class TeeSet {
 public:
  /// All or none; fails as Tee::open does.
  static Result<TeeSet> open(const std::vector<Endpoint>& endpoints);

  bool empty() const { return tees_.empty(); }
  /// What must not be heard again (InputOptions::own).
  std::vector<SocketAddress> localAddresses() const;
  /// Says why a recording that listens at `sources` would hear itself.
  Status check(const std::vector<DatagramSource*>& sources) const;

  void forward(std::span<const ReceivedDatagram> batch) {
    for (const auto& each : tees_) each->forward(batch);
  }
  /// Sends what still waits, for a moment. Not while something forwards.
  void close() {
    for (const auto& each : tees_) each->close();
  }
  /// Exact after close().
  std::vector<Tee::Account> accounts() const;

 private:
  std::vector<std::unique_ptr<Tee>> tees_;
};

}  // namespace rocinante
