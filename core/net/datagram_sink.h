#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/net/endpoint.h"

namespace rocinante {

/// Where datagrams go: a UDP socket, a subject of a server, a test's fake. One thread.
class DatagramSink {
 public:
  virtual ~DatagramSink() = default;

  /// Sends all of them, in order; waits where the system has no room for more.
  virtual Status send(std::span<const ByteView> payloads) = 0;
  /// Sends as many from the front as go without waiting, and returns how many. A failure concerns
  /// the first.
  virtual Result<std::size_t> sendWithoutWaiting(std::span<const ByteView> payloads) = 0;

  /// False while a server is waited for that has not answered yet; a failure when it never will.
  virtual Result<bool> isReady() const { return true; }
  /// What changed since the last call, as a sentence for the user. Any thread.
  virtual std::optional<std::string> news() { return std::nullopt; }

  /// To be called at the end: waits until what was sent has left, as far as that can be known.
  virtual Status flush() { return {}; }

  /// As DatagramSource::serverId().
  virtual std::string serverId() const { return {}; }

  /// For poll(): writable when there is room again; -1: there is none to wait for.
  virtual int fileDescriptor() const = 0;
  virtual const Endpoint& endpoint() const = 0;
};

}  // namespace rocinante
