#pragma once

#include <memory>
#include <optional>
#include <string>

#include "viewer/backdrop/backdrop.h"
#include "viewer/ui/model/view_model.h"
#include "viewer/ui/study/worker.h"

namespace rocinante {

/// Reads the backdrop of the shown moment in a thread of its own: a window does not wait for a
/// decoder. Main thread; borrows the backdrop.
class BackdropLoader {
 public:
  /// Without a backdrop it does nothing. `tell` is called by the other thread when a picture came.
  BackdropLoader(Backdrop* backdrop, void (*tell)());

  /// Asks for the picture of the model's moment, and gives the model the last one that came; true
  /// when the model's changed. `waits`: until the asked one is there.
  bool update(ViewModel& model, bool waits);
  /// The last fault since the last call; empty: none.
  std::string takeFault();

 private:
  /// What came of the number of a picture.
  struct Read {
    std::shared_ptr<const BackdropPicture> picture;  ///< null: it could not be read
    std::string fault;                               ///< the last one so far
    std::size_t faults = 0;                          ///< how many there were so far
  };

  Backdrop* backdrop_;
  std::optional<std::size_t> asked_;  ///< number of a picture
  std::size_t faults_reported_ = 0;
  std::optional<Worker<std::size_t, Read>> worker_;
};

}  // namespace rocinante
