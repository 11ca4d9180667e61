#include "core/cell/cell_decoders.h"

#include <fmt/format.h>

namespace rocinante {

void readDecodersName(const CellFile& file, const FileSearch& search, Cell& cell) {
  TomlTable& root = *file.root;
  const std::optional<std::string> name = root.text("decoders");
  if (!name) return;
  const FoundFile found = search.find(*name, file.folder);
  if (!found.path.empty()) {
    cell.decoders = found.path;
    return;
  }
  root.error(
      "cell.missing-file", "decoders",
      fmt::format("the decoders {} are not used: {}", quotedPathInFault(*name), found.problem()),
      found.hint());
}

}  // namespace rocinante
