#include "player/send/paced_sender.h"

#include "player/send/pacing.h"
#include "player/send/send_batch.h"

namespace rocinante {
namespace {

/// False when stopped first.
bool waitFor(SteadyTime deadline, Pacing& pacing, SendPort& port) {
  while (!port.stopRequested()) {
    const Pacing::Step step = pacing.step(port.now(), deadline);
    if (step.action == Pacing::Action::send) return true;
    if (step.action != Pacing::Action::sleep) continue;
    port.sleepUntil(step.until);
    pacing.woke(step.until, port.now());
  }
  return false;
}

}  // namespace

Result<SendEnd> sendOnSchedule(DatagramStream& stream, const PlaybackClock& clock, SendPort& port,
                               SendJournal& journal) {
  Pacing pacing;
  SendBatch batch;
  while (true) {
    Result<std::optional<Due>> due = stream.due();
    if (!due) return due.error();
    if (!*due) return SendEnd::finished;
    SteadyTime deadline = clock.deadline((*due)->time);
    if (!waitFor(deadline, pacing, port)) return SendEnd::stopped;
    pacing.sent(deadline);

    const SteadyTime now = port.now();
    while (*due && !batch.full() && deadline <= now) {
      batch.add(**due, deadline, stream.take());
      if (due = stream.due(); !due) return due.error();
      if (*due) deadline = clock.deadline((*due)->time);
    }
    if (const Status sent = batch.send(port, journal); !sent) return sent.error();
  }
}

}  // namespace rocinante
