#pragma once

#include <cstdint>
#include <mutex>
#include <thread>

#include "core/recording/capture_writer.h"
#include "core/recording/hand_over.h"
#include "recorder/capture/input_loop.h"

namespace rocinante {

/// The writing half of a recording: a thread that writes what is handed over until that ends.
class Writing {
 public:
  /// What the caller asks for, as counts since the beginning.
  struct Requests {
    std::uint32_t seams = 0;     ///< new pieces
    std::uint32_t triggers = 0;  ///< of a ring
  };
  struct Progress {
    bool started = false;  ///< see CaptureWriter
    bool over = false;
    std::uint64_t packets = 0;
    std::uint64_t lost = 0;
    std::uint64_t log_bytes = 0;
    Nanoseconds held{};
  };

  /// Everything must outlive this; the writer belongs to the thread until join(). An `input` that
  /// keeps its place learns what is saved, and saving is done often.
  Writing(CaptureWriter& writer, HandOver& queue, InputLoop& input);
  ~Writing() { join(); }
  Writing(const Writing&) = delete;
  Writing& operator=(const Writing&) = delete;

  void ask(const Requests& requests);
  Progress progress() const;
  /// Waits until everything is written: the HandOver must be finished. Idempotent.
  void join();

 private:
  void write();
  void save(SteadyTime now);

  CaptureWriter& writer_;
  HandOver& queue_;
  InputLoop& input_;
  SteadyTime saved_at_{};  ///< for the thread
  mutable std::mutex mutex_;
  Requests requests_;  ///< guarded by mutex_, as is the next
  Progress progress_;
  std::thread thread_;  ///< last: it uses the members above
};

}  // namespace rocinante
