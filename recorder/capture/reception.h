#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "core/net/datagram_source.h"
#include "core/recording/hand_over.h"
#include "recorder/capture/receive_loop.h"
#include "recorder/capture/tee_set.h"
#include "recorder/pieces/note_box.h"

namespace rocinante {

/// The receiving half of a recording: a thread that moves datagrams into a HandOver during the
/// whole lifetime of this object.
class Reception {
 public:
  /// Everything must outlive this; `loop` reads `sources` and fills `queue`.
  Reception(const std::vector<DatagramSource*>& sources, InputLoop& loop);
  ~Reception() { (void)stop(); }
  Reception(const Reception&) = delete;
  Reception& operator=(const Reception&) = delete;

  /// The input has ended or failed: nothing more will be received.
  bool over() const { return over_.load(); }
  /// Stops receiving. Idempotent; returns the failure of a source.
  Status stop();

  /// The sources' endpoints with their bound ports.
  std::vector<std::string> names() const;
  const std::vector<DatagramSource*>& sources() const { return sources_; }
  InputLoop& loop() const { return loop_; }
  SteadyTime start() const { return start_; }  ///< of receiving

 private:
  Status receive();

  const std::vector<DatagramSource*>& sources_;
  InputLoop& loop_;
  SteadyTime start_;
  std::atomic<bool> stop_{false};
  std::atomic<bool> over_{false};
  Status received_;
  std::thread thread_;  ///< last: it uses the members above
};

/// The loop for sockets: everything received goes to `tees` too, sentences for the user to `notes`.
std::unique_ptr<InputLoop> socketLoop(const std::vector<DatagramSource*>& sources, HandOver& queue,
                                      TeeSet& tees, NoteBox& notes);

}  // namespace rocinante
