#include "player/paced_sender.h"

#include <array>
#include <vector>

#include "player/pacing.h"

namespace rocinante {
namespace {

/// Datagrams that go in one call. Holds copies: a stream's bytes last only until its next step.
class Batch {
 public:
  static constexpr std::size_t kMost = 64;

  bool full() const { return count_ == kMost; }
  bool empty() const { return count_ == 0; }

  void add(const Due& due, SteadyTime deadline, ByteView payload) {
    items_[count_++] = {due, deadline, bytes_.size(), payload.size()};
    bytes_.insert(bytes_.end(), payload.begin(), payload.end());
  }

  Status send(SendEdge& edge, SendJournal& journal) {
    std::array<ByteView, kMost> payloads;
    std::array<SteadyTime, kMost> sent_at{};
    for (std::size_t i = 0; i < count_; ++i) {
      payloads[i] = ByteView(bytes_).subspan(items_[i].begin, items_[i].byte_count);
    }
    if (const Status sent = edge.send({payloads.data(), count_}, {sent_at.data(), count_}); !sent) {
      return sent.error();
    }
    for (std::size_t i = 0; i < count_; ++i) {
      journal.sent(items_[i].due, payloads[i], items_[i].deadline, sent_at[i]);
    }
    count_ = 0;
    bytes_.clear();
    return {};
  }

 private:
  struct Item {
    Due due;
    SteadyTime deadline;
    std::size_t begin;
    std::size_t byte_count;
  };
  std::array<Item, kMost> items_{};
  std::size_t count_ = 0;
  Bytes bytes_;
};

/// False when a stop was asked for first.
bool waitFor(SteadyTime deadline, const Pacing& pacing, SendEdge& edge) {
  while (!edge.stopRequested()) {
    const Pacing::Step step = pacing.step(edge.now(), deadline);
    if (step.action == Pacing::Action::send) return true;
    if (step.action == Pacing::Action::sleep) edge.sleepUntil(step.until);
  }
  return false;
}

}  // namespace

Result<SendEnd> sendOnSchedule(DatagramStream& stream, const PlaybackClock& clock, SendEdge& edge,
                               SendJournal& journal) {
  Pacing pacing;
  Batch batch;
  while (true) {
    Result<std::optional<Due>> due = stream.due();
    if (!due) return due.error();
    if (!*due) return SendEnd::finished;
    SteadyTime deadline = clock.deadline((*due)->time);
    if (!waitFor(deadline, pacing, edge)) return SendEnd::stopped;
    pacing.sent(deadline);

    const SteadyTime now = edge.now();
    while (*due && !batch.full() && deadline <= now) {
      batch.add(**due, deadline, stream.take());
      if (due = stream.due(); !due) return due.error();
      if (*due) deadline = clock.deadline((*due)->time);
    }
    if (const Status sent = batch.send(edge, journal); !sent) return sent.error();
  }
}

Result<SendEnd> sendAtOnce(DatagramStream& stream, SendEdge& edge, SendJournal& journal) {
  Batch batch;
  while (!edge.stopRequested()) {
    const SteadyTime now = edge.now();
    while (!batch.full()) {
      const Result<std::optional<Due>> due = stream.due();
      if (!due) return due.error();
      if (!*due) break;
      batch.add(**due, now, stream.take());
    }
    if (batch.empty()) return SendEnd::finished;
    if (const Status sent = batch.send(edge, journal); !sent) return sent.error();
  }
  return SendEnd::stopped;
}

}  // namespace rocinante
