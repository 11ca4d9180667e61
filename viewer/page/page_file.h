#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/base/time.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// A page is held in memory several times while it is made.
constexpr std::uint64_t kMostPageBytes = std::uint64_t{1} << 30U;
/// A page's memory ends at 2 GiB (cmake/web.cmake), and the log is in it whole. Also in served.js.
constexpr std::uint64_t kMostLogInPageBytes = 2'000'000'000;

/// What a page consists of (docs/programs/page.md).
struct PageParts {
  std::string title;
  std::string viewer_script;      ///< rocinante-viewer.js: emscripten's, which starts the next
  Bytes viewer;                   ///< rocinante-viewer.wasm
  Bytes cell;                     ///< a baked cell (docs/baked-cell.md)
  std::string left_out;           ///< what the cell lacks to be small; empty: nothing
  std::string findings = "null";  ///< pageFindings(), or null: nobody has looked
  std::string events = "null";    ///< pageEvents(), or null: the viewer finds them in the log
  std::string layout;  ///< PageLayout's JSON: what the page begins with; empty: nothing is said
  std::optional<bool> is_light;  ///< the theme; empty: that of the system
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

/// Where a page opens: "#t=12.5&camera=overview&select=arm/link4", to be appended to its address.
/// Seconds count from the session's origin. What is empty is left out; of `select` the second part
/// may be.
std::string pageLink(std::optional<Nanoseconds> moment, std::string_view camera,
                     const Path& select);

}  // namespace rocinante
