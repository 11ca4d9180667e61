#include "viewer/page/page_viewer.h"

#include <string>
#include <utility>

#include "core/base/atomic_file.h"
#include "core/base/data_file.h"

namespace rocinante {
namespace {

constexpr const char* kScriptName = "rocinante-viewer.js";
constexpr const char* kViewerName = "rocinante-viewer.wasm";
constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 30U;

Error noViewer(const std::string& why) {
  return {ErrorKind::not_found,
          "the viewer of pages is not there: build it with scripts/build_web, then name its folder "
          "with --viewer DIR; " +
              why,
          {}};
}

Result<std::string> viewerFile(const std::filesystem::path& folder, const char* name) {
  if (folder.empty()) {
    const auto found = findDataFile(std::string("web/") + name);
    if (!found) return noViewer(found.error().what);
    return readFile(*found, kMostBytes);
  }
  auto content = readFile(folder / name, kMostBytes);
  if (!content) return noViewer(content.error().text());
  return content;
}

}  // namespace

Status readPageViewer(const std::filesystem::path& folder, PageParts& parts) {
  auto script = viewerFile(folder, kScriptName);
  if (!script) return script.error();
  parts.viewer_script = std::move(*script);
  const auto viewer = viewerFile(folder, kViewerName);
  if (!viewer) return viewer.error();
  const ByteView bytes = bytesOf(*viewer);
  parts.viewer.assign(bytes.begin(), bytes.end());
  return {};
}

}  // namespace rocinante
