#include "core/mesh/collada_guard.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <map>
#include <string_view>
#include <vector>

#include "core/document/xml_tags.h"

namespace rocinante {
namespace {

constexpr std::size_t kDeepestXml = 100;      // elements in elements
constexpr std::size_t kLongestChain = 1000;   // of instanced nodes
constexpr std::size_t kMaxNodes = 1'000'000;  // after all instances are expanded

/// The nodes of a COLLADA file and their instances (<instance_node>).
class NodeGraph {
 public:
  std::size_t open(const XmlTag& tag, std::size_t parent) {
    nodes_.emplace_back();
    const std::size_t node = nodes_.size() - 1;
    if (parent != kNoNode) nodes_[parent].children.push_back(node);
    // assimp finds them by either.
    for (const std::string_view key : {"id", "name", "sid"}) {
      if (const std::string_view name = attributeOf(tag, key); !name.empty()) {
        named_[name].push_back(node);
      }
    }
    return node;
  }
  void standsFor(std::size_t node, std::string_view url) {
    if (url.starts_with('#')) url.remove_prefix(1);
    nodes_[node].stands_for.push_back(url);
    any_ = true;
  }

  std::string problem() {
    if (!any_) return {};
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (!count(i, 0)) return problem_;
    }
    return {};
  }

  static constexpr std::size_t kNoNode = static_cast<std::size_t>(-1);

 private:
  struct Node {
    std::vector<std::size_t> children;
    std::vector<std::string_view> stands_for;
    std::size_t size = 0;  ///< nodes in all, once counted
    bool counting = false;
  };

  bool count(std::size_t number, std::size_t depth) {
    Node& node = nodes_[number];
    if (node.size > 0) return true;
    if (node.counting || depth > kLongestChain) {
      problem_ = node.counting ? "a <node> contains itself by way of <instance_node>"
                               : "its nodes instance each other in a chain of more than 1000";
      return false;
    }
    node.counting = true;
    std::size_t size = 1;
    std::vector<std::size_t> below = node.children;
    for (const std::string_view name : node.stands_for) {
      const auto found = named_.find(name);
      if (found == named_.end()) continue;
      below.insert(below.end(), found->second.begin(), found->second.end());
    }
    for (const std::size_t each : below) {
      if (!count(each, depth + 1)) return false;
      size += nodes_[each].size;
      if (size <= kMaxNodes) continue;
      problem_ = fmt::format("its nodes expand to more than {} nodes", kMaxNodes);
      return false;
    }
    node.counting = false;
    node.size = size;
    return true;
  }

  std::vector<Node> nodes_;
  std::map<std::string_view, std::vector<std::size_t>> named_;
  bool any_ = false;
  std::string problem_;
};

/// The arrays of a COLLADA file and what its accessors read of them: assimp does not check the
/// bounds.
class ArrayReads {
 public:
  void add(const XmlTag& tag) {
    if (tag.name.ends_with("_array")) {
      const std::uint64_t count = numberOf(tag, "count", 0);
      const auto [array, is_new] = counts_.emplace(attributeOf(tag, "id"), count);
      if (!is_new) array->second = std::min(array->second, count);
    } else if (tag.name == "accessor") {
      std::string_view source = attributeOf(tag, "source");
      if (source.starts_with('#')) source.remove_prefix(1);
      reads_.push_back({source, numberOf(tag, "offset", 0), numberOf(tag, "count", 0),
                        numberOf(tag, "stride", 1)});
    }
  }

  std::string problem() const {
    for (const Read& read : reads_) {
      const auto array = counts_.find(read.array);
      if (array == counts_.end() || read.count == 0) continue;  // assimp refuses the first itself
      const std::uint64_t stride = std::max<std::uint64_t>(read.stride, 1);
      if (read.offset <= array->second && read.count <= (array->second - read.offset) / stride) {
        continue;
      }
      return fmt::format("an <accessor> reads {} times {} numbers of an array of {}", read.count,
                         stride, array->second);
    }
    return {};
  }

 private:
  struct Read {
    std::string_view array;
    std::uint64_t offset, count, stride;
  };

  static std::uint64_t numberOf(const XmlTag& tag, std::string_view key, std::uint64_t otherwise) {
    const std::string_view text = attributeOf(tag, key);
    std::uint64_t number = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
    return read.ec == std::errc() ? number : otherwise;
  }

  std::map<std::string_view, std::uint64_t> counts_;
  std::vector<Read> reads_;
};

/// Whether the element holds whole numbers and nothing else: assimp reads an index list to its end
/// and loops forever at a letter.
bool holdsIndices(std::string_view text, const XmlTag& tag) {
  const auto from = static_cast<std::size_t>(tag.inner.data() + tag.inner.size() + 1 - text.data());
  const std::size_t end = text.find_first_not_of("0123456789+- \t\r\n", from);
  return end == std::string_view::npos || text.substr(end).starts_with("</");
}

}  // namespace

std::string problemOfCollada(ByteView bytes) {
  const std::string_view text = textOf(bytes);
  if (text.starts_with("PK")) return "is a ZIP file; unpack it and name the .dae inside";
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
    return "is UTF-16 text; save it as UTF-8";
  }
  XmlTags tags(text);
  NodeGraph graph;
  ArrayReads arrays;
  std::vector<std::size_t> open;  // by element: the node that it is or is in
  for (XmlTag tag; tags.next(tag);) {
    if (tag.starts && !tag.ends && (tag.name == "p" || tag.name == "vcount") &&
        !holdsIndices(text, tag)) {
      return fmt::format("a <{}> holds something that is not an index", tag.name);
    }
    if (tag.starts) {
      arrays.add(tag);
      if (open.size() >= kDeepestXml) {
        return fmt::format("the XML is nested deeper than {} elements", kDeepestXml);
      }
      std::size_t node = open.empty() ? NodeGraph::kNoNode : open.back();
      if (tag.name == "node") node = graph.open(tag, node);
      if (tag.name == "instance_node" && node != NodeGraph::kNoNode) {
        graph.standsFor(node, attributeOf(tag, "url"));
      }
      open.push_back(node);
    }
    if (tag.ends && !open.empty()) open.pop_back();
  }
  const std::string array_problem = arrays.problem();
  return array_problem.empty() ? graph.problem() : array_problem;
}

char upAxisOfCollada(ByteView bytes) {
  const std::string_view text = textOf(bytes);
  const std::size_t tag = text.find("<up_axis>");
  if (tag == std::string_view::npos) return 'Y';
  const std::size_t word = text.find_first_not_of(kXmlBlanks, tag + 9);
  if (word == std::string_view::npos) return 'Y';
  return text[word] == 'Z' || text[word] == 'X' ? text[word] : 'Y';
}

}  // namespace rocinante
