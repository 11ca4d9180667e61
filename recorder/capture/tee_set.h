#pragma once

#include <memory>
#include <vector>

#include "recorder/capture/tee.h"
#include "recorder/capture/tee_echoes.h"

namespace rocinante {

/// All tees of a recording, usually none. Each has its own queue and thread, so a slow one does not
/// affect the others.
class TeeSet {
 public:
  /// Opens all or none; fails as Tee::open.
  static Result<TeeSet> open(const std::vector<Endpoint>& endpoints);

  bool empty() const { return tees_.empty(); }
  /// Addresses whose datagrams must not be recorded again (InputOptions::own).
  std::vector<SocketAddress> localAddresses() const;
  /// Fails if a recording that listens on `sources` would receive its own tee.
  Status check(const std::vector<DatagramSource*>& sources) const;

  /// Without what comes back to it.
  void forward(std::span<const ReceivedDatagram> batch);
  /// When something has come back: a sentence for the user, once. For the thread that forwards.
  std::optional<std::string> circleNews() { return echoes_.news(); }
  /// Sends waiting datagrams for a moment. Not while another thread forwards.
  void close() {
    for (const auto& each : tees_) each->close();
  }
  /// What changed at those that send to a server, as sentences for the user.
  std::vector<std::string> news();
  /// Exact after close().
  std::vector<Tee::Account> accounts() const;

 private:
  std::vector<std::unique_ptr<Tee>> tees_;
  TeeEchoes echoes_;
};

}  // namespace rocinante
