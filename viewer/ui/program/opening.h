#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/ui/panels/panels.h"
#include "viewer/ui/program/view_content.h"

namespace rocinante {

/// Opens files in a window that shows something already. Main thread; borrows all.
class Opening {
 public:
  Opening(ContentLoader& loader, ViewModel& model, const ContentRequest& shown)
      : loader_(loader), model_(model), shown_(shown) {}

  bool busy() const { return loader_.busy(); }
  /// Starts to load what was opened or dropped; refused with a sentence for the user.
  Status open(const std::vector<std::filesystem::path>& files);

  /// What came of it, once it has come.
  struct Loaded {
    std::unique_ptr<ViewContent> content;  ///< null: it cannot be read
    std::string fault;                     ///< why, for the user
  };
  /// Fails with what cannot be read when that is all that was asked for. `waits`: until it has
  /// come.
  Result<std::optional<Loaded>> take(bool waits);

  std::optional<LoadingStatus> status() const;

 private:
  ContentLoader& loader_;
  ViewModel& model_;
  const ContentRequest& shown_;
};

}  // namespace rocinante
