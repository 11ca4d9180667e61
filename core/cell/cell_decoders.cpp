#include <fmt/format.h>

#include "core/base/atomic_file.h"
#include "core/cell/cell_sections.h"
#include "core/document/toml_node.h"

namespace rocinante {
namespace {

constexpr std::size_t kMaxDecoderBytes = std::size_t{1} << 20U;

}  // namespace

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

void addDecoderFiles(const Cell& cell, MeshStore& files) {
  if (cell.decoders.empty()) return;
  files.addFile(cell.decoders);
  const Result<std::string> text = readFile(cell.decoders, kMaxDecoderBytes);
  if (!text) return;
  const Result<TomlNode> document = parseToml(*text, cell.decoders.string());
  if (!document) return;
  const std::filesystem::path folder = cell.decoders.parent_path();
  for (const TomlNode::Entry& decoders : document->entries) {
    for (const TomlNode& decoder : decoders.value.items) {
      for (const TomlNode::Entry& entry : decoder.entries) {
        if (entry.key != "descriptor" || entry.value.text.empty()) continue;
        for (const auto& path :
             {folder / entry.value.text, folder / cell.decoders.stem() / entry.value.text}) {
          std::error_code error;
          if (std::filesystem::is_regular_file(path, error)) files.addFile(path);
        }
      }
    }
  }
}

}  // namespace rocinante
