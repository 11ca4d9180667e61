#pragma once

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "viewer/backdrop/backdrop.h"
#include "viewer/ui/model/view_model.h"

namespace rocinante {

/// Reads the backdrop of the shown moment in a thread of its own: a window does not wait for a
/// decoder. Main thread; borrows the backdrop.
class BackdropDesk {
 public:
  /// Without a backdrop it does nothing. `tell` is called by the other thread when a picture came.
  BackdropDesk(Backdrop* backdrop, void (*tell)());
  ~BackdropDesk();
  BackdropDesk(const BackdropDesk&) = delete;
  BackdropDesk& operator=(const BackdropDesk&) = delete;

  /// Asks for the picture of the model's moment, and gives the model the last one that came; true
  /// when the model's changed. `waits`: until the asked one is there.
  bool update(ViewModel& model, bool waits);
  /// The first fault since the last call; empty: none.
  std::string takeFault();

 private:
  void work();

  Backdrop* backdrop_;
  void (*tell_)();
  std::mutex mutex_;
  std::condition_variable news_;
  std::optional<std::size_t> wanted_, made_;  ///< numbers of pictures
  std::shared_ptr<const BackdropPicture> picture_;
  std::string fault_;
  std::atomic<bool> ends_{false};
  std::thread thread_;  ///< last: it uses all of the above
};

}  // namespace rocinante
