#include "player/send/send_plan.h"

#include "player/send/paced_sender.h"
#include "player/send/playback_clock.h"
#include "player/send/send_progress.h"
#include "player/send/udp_send_port.h"

namespace rocinante {

Result<PlayReport> sendPlan(DatagramStream& stream, const SendPlan& plan,
                            const std::function<bool()>& stop) {
  Result<UdpSendPort> port =
      UdpSendPort::open({{plan.to, 0, false}}, plan.realtime, stop, -1, plan.notify);
  if (!port) return port.error();
  if (plan.began) plan.began();
  PlayJournal journal(plan.from, plan.until);
  Result<SendEnd> end = SendEnd::finished;
  {
    SendProgress progress(journal, plan.origin, plan.last, plan.progress);
    const PlaybackClock clock(plan.first, port->now() + std::chrono::milliseconds(1), plan.speed);
    end = sendOnSchedule(stream, clock, *port, progress);
  }
  if (!end) return end.error();
  if (Status flushed = port->flush(); !flushed) return flushed.error();
  PlayReport report;
  report.to = plan.to.text();
  report.speed = plan.speed;
  report.timing_source = port->timingSource();
  report.scheduling = port->scheduling();
  report.interrupted = *end == SendEnd::stopped;
  journal.writeTo(report);
  return report;
}

}  // namespace rocinante
