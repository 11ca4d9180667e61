#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

#include "core/base/bytes.h"
#include "core/document/fault_list.h"
#include "core/document/xml_places.h"

namespace rocinante {

/// The text of an XML file as UTF-8: from UTF-16 (by its byte order mark, or by its first `<`), and
/// from ISO-8859-1 and Windows-1252 where the declaration names them. UTF-8 is copied without its
/// mark, and so are bytes of no declared encoding. Empty with a reason in `problem` for others.
std::string xmlAsUtf8(std::string_view bytes, std::string& problem);

/// An XML file as a tree, with the places of its elements: lines, and columns in UTF-8.
class XmlDocument {
 public:
  struct Rules {
    std::string_view xml, too_many;
  };

  /// Null, with an error in `faults`, when there is no element, the XML is not well-formed or
  /// nested deeper than 100 elements, or it has more than `most_elements`.
  static std::unique_ptr<XmlDocument> parse(std::string text, std::size_t most_elements,
                                            const Rules& rules, FaultList& faults);
  /// The same of a file's bytes, by xmlAsUtf8().
  static std::unique_ptr<XmlDocument> parse(ByteView bytes, std::size_t most_elements,
                                            const Rules& rules, FaultList& faults);
  ~XmlDocument();
  XmlDocument(const XmlDocument&) = delete;
  XmlDocument& operator=(const XmlDocument&) = delete;

  const tinyxml2::XMLElement& root() const;
  const XmlPlaces& places() const { return places_; }
  const std::string& text() const { return text_; }

 private:
  explicit XmlDocument(std::string text);

  std::string text_;
  XmlPlaces places_;
  std::unique_ptr<tinyxml2::XMLDocument> tree_;
};

}  // namespace rocinante
