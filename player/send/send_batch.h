#pragma once

#include <array>
#include <cstddef>

#include "player/send/paced_sender.h"

namespace rocinante {

/// Datagrams that go together. Holds copies: a stream's bytes last only until its next step.
class SendBatch {
 public:
  static constexpr std::size_t kMax = 64;

  bool full() const { return count_ == kMax; }
  bool empty() const { return count_ == 0; }

  void add(const Due& due, SteadyTime deadline, ByteView payload);

  /// Sends all, in order, in one call for each run of one route, and tells the journal of what went
  /// out. Empty afterwards, also when it fails.
  Status send(SendPort& edge, SendJournal& journal);

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
