#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "core/cell/cell.h"
#include "core/cell/posed_scene.h"
#include "viewer/ui/study/worker.h"

namespace rocinante {

/// Poses the cell at single moments of its log, in a thread of its own: without keyframes the way
/// to a moment is long. One moment at a time. For one calling thread.
class MomentStudy {
 public:
  /// `cell` is borrowed, and read by the thread. `on_ready` is called by the thread.
  MomentStudy(const Cell& cell, std::function<void()> on_ready);

  /// A moment is being posed: nothing else can be asked for.
  bool busy() const { return worker_.isBusy(); }
  /// Requires !busy(). Ends the validity of scene().
  void ask(std::filesystem::path log, LogTime moment) { worker_.ask({std::move(log), moment}); }
  /// The scene of the moment that was asked for, valid until the next ask(); null while busy, and
  /// when the log is unreadable or damaged there.
  const PosedScene* scene() const;
  void wait() const { worker_.wait(); }

 private:
  struct Question {
    std::filesystem::path log;
    LogTime moment;
  };
  class Poser;
  Worker<Question, std::optional<PosedScene>> worker_;
};

}  // namespace rocinante
