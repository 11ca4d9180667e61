#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "core/document/fault_list.h"

namespace tinyxml2 {
class XMLDocument;
class XMLElement;
}  // namespace tinyxml2

namespace rocinante {

/// Lines and columns in an XML text: tinyxml2 keeps lines only. Columns count bytes from 1.
class XmlPlaces {
 public:
  /// Finds the start tags. `text` is borrowed and must outlive this.
  explicit XmlPlaces(std::string_view text);

  std::size_t elementCount() const { return starts_.size(); }
  /// Notes in each element of `document`, parsed from the same text, where its tag starts (in its
  /// user data).
  void attach(tinyxml2::XMLDocument& document) const;

  Place of(const tinyxml2::XMLElement& element) const;
  /// Of the attribute's name; of the element when it has no such attribute.
  Place of(const tinyxml2::XMLElement& element, std::string_view attribute) const;

 private:
  Place at(std::size_t offset) const;
  void scan();
  std::size_t after(std::string_view end, std::size_t from) const;

  std::string_view text_;
  std::vector<std::size_t> starts_;  // of tags, in document order
  std::vector<std::size_t> lines_;   // offsets of their first bytes
};

}  // namespace rocinante
