#pragma once

#include <string>
#include <string_view>

#include "core/base/bytes.h"
#include "core/base/result.h"

namespace rocinante {

/// What a page consists of (docs/programs/page.md).
struct PageParts {
  std::string title;
  std::string viewer_script;      ///< rocinante-viewer.js: emscripten's, which starts the next
  Bytes viewer;                   ///< rocinante-viewer.wasm
  Bytes cell;                     ///< a baked cell (docs/baked-cell.md)
  std::string left_out;           ///< what the cell lacks to be small; empty: nothing
  std::string findings = "null";  ///< pageFindings(), or null: nobody has looked
  std::string events = "null";    ///< pageEvents(), or null: the viewer finds them in the log
  Bytes log;
};

/// One HTML file of them, which loads nothing else. The same parts give the same bytes. The log is
/// in it byte for byte; the viewer and the cell are compressed.
std::string pageOf(const PageParts& parts);

/// The same page for a server to give: without the log, which it reads at `/log` of its server, or,
/// when `is_live`, with a session that comes through the socket `/live` (docs/programs/serve.md).
std::string servedPageOf(const PageParts& parts, bool is_live);

/// The log that a page carries. unsupported when it is not one of ours; damaged when its log is cut
/// or changed. Allocates no more than the page's size.
Result<Bytes> logOfPage(std::string_view page, const std::string& name);

}  // namespace rocinante
