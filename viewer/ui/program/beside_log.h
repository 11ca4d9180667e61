#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/bundle/private_folder.h"
#include "core/session/timeline.h"

namespace rocinante {

struct ContentRequest;
struct ViewContent;

/// A log that was read to be shown beside another one.
struct BesideLog {
  Timeline session;
  std::vector<std::string> warnings;            ///< one sentence each
  std::shared_ptr<const PrivateFolder> folder;  ///< a temporary log lies in it; null: it is none
};

/// What came of a log that was to be shown beside another one.
struct BesideAdded {
  std::string refusal;                ///< why it is not, for the user; empty: it is
  std::vector<std::string> warnings;  ///< what has to be said of it and the cell, over the picture
};

/// Shows a log, `asked.beside`, beside that of the content, aligned as alignBeside() says of
/// `asked.align`; one that has no packets, or moves no device of the cell, is refused. bad_argument
/// where it cannot be aligned. In both cases the content stays as it is. Main thread once that is
/// shown.
Result<BesideAdded> addBeside(BesideLog beside, const ContentRequest& asked, ViewContent& content);

}  // namespace rocinante
