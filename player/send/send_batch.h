#pragma once

#include <array>
#include <cstddef>

#include "player/send/paced_sender.h"

namespace rocinante {

/// Datagrams to send together. Holds copies, because a stream's bytes last only until its next
/// call.
class SendBatch {
 public:
  static constexpr std::size_t kMax = 64;

  bool full() const { return count_ == kMax; }
  bool empty() const { return count_ == 0; }

  void add(const Due& due, SteadyTime deadline, ByteView payload);

  /// Sends all in order, with one call for consecutive datagrams of one route, and notifies the
  /// journal. Empty afterwards, even on failure.
  Status send(SendPort& port, SendJournal& journal);

 private:
  struct Item {
    Due due;
    SteadyTime deadline;
    std::size_t begin;
    std::size_t byte_count;
  };
  std::array<Item, kMax> items_{};
  std::size_t count_ = 0;
  Bytes bytes_;
};

}  // namespace rocinante
