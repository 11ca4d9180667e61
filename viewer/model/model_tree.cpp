#include <fmt/format.h>

#include <algorithm>

#include "core/base/plain_text.h"
#include "core/cli/text_table.h"
#include "viewer/model/model_info.h"

namespace rocinante {
namespace {

constexpr std::size_t kMaxLevels = 64;

struct Strokes {
  std::string_view child, last_child, beside, nothing;
};
constexpr Strokes kBoxes{"├─ ", "└─ ", "│  ", "   "};
constexpr Strokes kAscii{"|- ", "`- ", "|  ", "   "};

// A link still to be drawn.
struct Waiting {
  std::size_t link = 0;
  std::size_t depth = 0;
  bool last = false;      // of its parent's children
  std::string beginning;  // prefix of its children, up to the drawn depth
};

std::vector<std::vector<std::size_t>> childrenOf(const Model& model) {
  std::vector<std::vector<std::size_t>> children(model.links.size());
  for (const Joint& joint : model.joints) children[joint.parent].push_back(joint.child);
  return children;
}

std::string jointNote(const Model& model, const Joint& joint) {
  std::string note = limitsText(joint);
  if (joint.mimic) {
    note += fmt::format("{}mimics {}", note.empty() ? "" : ", ",
                        plainText(model.joints[joint.mimic->joint].name));
  }
  return note;
}

}  // namespace

std::string treeText(const Model& model, bool ascii) {
  const Strokes& strokes = ascii ? kAscii : kBoxes;
  const auto children = childrenOf(model);
  cli::TextTable table;
  table.is_number = {false, false, false, false};
  std::vector<Waiting> waiting;
  for (std::size_t i = model.links.size(); i-- > 0;) {
    if (!model.links[i].parent_joint) waiting.push_back({i, 0, true, ""});
  }
  // The root comes first, before other links without a parent.
  std::stable_partition(waiting.begin(), waiting.end(),
                        [&](const Waiting& w) { return w.link != model.root; });
  while (!waiting.empty()) {
    const Waiting at = std::move(waiting.back());
    waiting.pop_back();
    const Link& link = model.links[at.link];
    std::string line, below;
    if (at.depth == 0) {
      line = plainText(link.name);
    } else if (at.depth <= kMaxLevels) {
      line = at.beginning + std::string(at.last ? strokes.last_child : strokes.child) +
             plainText(link.name);
      below = at.beginning + std::string(at.last ? strokes.nothing : strokes.beside);
    } else {
      line = fmt::format("{}({} deep) {}", at.beginning, at.depth, plainText(link.name));
      below = at.beginning;
    }
    if (link.parent_joint) {
      const Joint& joint = model.joints[*link.parent_joint];
      table.rows.push_back(
          {line, plainText(joint.name), std::string(nameOf(joint.type)), jointNote(model, joint)});
    } else {
      table.rows.push_back({line, "", "", ""});
    }
    const auto& held = children[at.link];
    for (std::size_t i = held.size(); i-- > 0;) {
      waiting.push_back({held[i], at.depth + 1, i + 1 == held.size(), below});
    }
  }
  return table.text();
}

}  // namespace rocinante
