#include "player/send/paced_sender.h"

#include "player/send/pacing.h"
#include "player/send/send_batch.h"

namespace rocinante {
namespace {

/// False when stopped first.
bool waitFor(SteadyTime deadline, Pacing& pacing, SendPort& edge) {
  while (!edge.stopRequested()) {
    const Pacing::Step step = pacing.step(edge.now(), deadline);
    if (step.action == Pacing::Action::send) return true;
    if (step.action != Pacing::Action::sleep) continue;
    edge.sleepUntil(step.until);
    pacing.woke(step.until, edge.now());
  }
  return false;
}

}  // namespace

Result<SendEnd> sendOnSchedule(DatagramStream& stream, const PlaybackClock& clock, SendPort& edge,
                               SendJournal& journal) {
  Pacing pacing;
  SendBatch batch;
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

}  // namespace rocinante
