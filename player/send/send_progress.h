#pragma once

#include <atomic>
#include <cstdint>
#include <string>

#include "player/send/live_line.h"
#include "player/send/paced_sender.h"

namespace rocinante {

/// Counts how often this process continued after a stop (Ctrl-Z and fg, SIGSTOP and SIGCONT), from
/// watchResumes() on, which handles SIGCONT. Another handler of SIGCONT must call noteResume(),
/// which is safe in signal handlers.
void watchResumes();
void noteResume();
std::uint32_t resumeCount();

/// "12.5 of 60.0 s, 750 datagrams": `position` and `end` are counted from `origin`.
std::string progressText(LogTime position, LogTime origin, LogTime end, std::uint64_t sent);

/// Shows the position of sending in a live line. Forwards everything to the journal behind it.
class SendProgress final : public SendJournal {
 public:
  SendProgress(SendJournal& behind, LogTime origin, LogTime end, bool visible);

  void sent(const Due& due, ByteView payload, SteadyTime deadline, SteadyTime sent_at) override;
  void tooLong(const Due& due) override { behind_.tooLong(due); }

 private:
  SendJournal& behind_;
  std::atomic<std::int64_t> position_ns_;
  std::atomic<std::uint64_t> sent_{0};
  LiveLine line_;
};

}  // namespace rocinante
