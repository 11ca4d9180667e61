#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "viewer/ui/program/live_saver.h"
#include "viewer/ui/program/view_content.h"

namespace rocinante {

/// Saves the window's live session, one file at a time, and reports what became of it. Main thread;
/// borrows the request.
class SaveFiles {
 public:
  explicit SaveFiles(const ContentRequest& shown) : shown_(shown) {}

  /// Begins; without a file into a new one of the working folder. bad_argument when the session is
  /// not live or not kept, refused while another save runs.
  Status ask(ViewModel& model, const std::filesystem::path& file = {});

  struct News {
    std::string text;  ///< one line: where it is, how much, and what is not in it
    bool is_fault = false;
  };
  /// The same as ask(), and waits for its end. What is not in the file becomes a doubt of the
  /// model, too.
  Result<News> make(ViewModel& model, const std::filesystem::path& file);
  /// To be called now and then: what became of the save, once.
  std::optional<News> look(ViewModel& model);

  bool active() const { return saver_.active(); }

 private:
  const ContentRequest& shown_;
  LiveSaver saver_;
};

}  // namespace rocinante
