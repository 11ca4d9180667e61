#pragma once

#include <cstddef>
#include <span>

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

  /// To be called at the end: waits until what was sent has left, as far as that can be known.
  virtual Status flush() { return {}; }

  /// For poll(): writable when there is room again; -1: there is none to wait for.
  virtual int fileDescriptor() const = 0;
  virtual const Endpoint& endpoint() const = 0;
};

}  // namespace rocinante
