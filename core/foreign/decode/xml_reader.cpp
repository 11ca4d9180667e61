#include <tinyxml2.h>

#include <algorithm>

#include "core/foreign/decode/field_reader.h"

namespace rocinante::decode {
namespace {

using tinyxml2::XMLAttribute;
using tinyxml2::XMLElement;

/// A path below the root: the elements on the way and, behind @, an attribute.
struct XmlPath {
  std::vector<std::string> elements;
  std::string attribute;  ///< empty: the element's text
};

XmlPath pathOf(std::string_view text) {
  XmlPath path;
  const std::size_t at = text.find('@');
  if (at != text.npos) path.attribute = text.substr(at + 1);
  text = text.substr(0, at);
  while (!text.empty()) {
    const std::size_t end = text.find('/');
    path.elements.emplace_back(text.substr(0, end));
    text.remove_prefix(end == text.npos ? text.size() : end + 1);
  }
  return path;
}

class XmlReader final : public FieldReader {
 public:
  explicit XmlReader(const Decoder& decoder) : decoder_(decoder) {
    for (const Field& field : decoder.fields) paths_.push_back(pathOf(field.path));
  }

  bool read(ByteView datagram, std::span<FieldValue> values) override {
    const XMLElement* const root = parse(datagram);
    if (root == nullptr) return refuse("it is not XML");
    for (std::size_t i = 0; i < paths_.size(); ++i) values[i] = valueAt(*root, paths_[i]);
    return true;
  }

  std::vector<FoundField> undeclared(ByteView datagram, std::size_t most) override {
    std::vector<FoundField> found;
    if (const XMLElement* const root = parse(datagram)) list(*root, "", most, found);
    return found;
  }

 private:
  const XMLElement* parse(ByteView datagram) {
    std::string_view text = textOf(datagram);
    while (text.ends_with('\0')) text.remove_suffix(1);
    if (document_.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS) return nullptr;
    return document_.RootElement();
  }

  static FieldValue valueAt(const XMLElement& root, const XmlPath& path) {
    const XMLElement* element = &root;
    for (const std::string& name : path.elements) {
      element = element->FirstChildElement(name.c_str());
      if (element == nullptr) return {};
    }
    const char* const text =
        path.attribute.empty() ? element->GetText() : element->Attribute(path.attribute.c_str());
    if (text == nullptr) return {};
    std::string_view value = text;
    const auto isBlank = [](char each) { return static_cast<unsigned char>(each) <= ' '; };
    while (!value.empty() && isBlank(value.front())) value.remove_prefix(1);
    while (!value.empty() && isBlank(value.back())) value.remove_suffix(1);
    return FieldValue::of(value);
  }

  /// As deep as the library parses.
  void list(const XMLElement& element, const std::string& path, std::size_t most,
            std::vector<FoundField>& found) const {
    const auto add = [&](std::string name, const char* value) {
      const auto declares = [&](const Field& field) { return field.path == name; };
      if (found.size() >= most) return;
      if (std::any_of(decoder_.fields.begin(), decoder_.fields.end(), declares)) return;
      found.push_back({std::move(name), value});
    };
    for (const XMLAttribute* each = element.FirstAttribute(); each != nullptr;
         each = each->Next()) {
      add(path + "@" + each->Name(), each->Value());
    }
    if (element.GetText() != nullptr && element.FirstChildElement() == nullptr) {
      add(path, element.GetText());
    }
    for (const XMLElement* each = element.FirstChildElement();
         each != nullptr && found.size() < most; each = each->NextSiblingElement()) {
      list(*each, path.empty() ? each->Name() : path + "/" + each->Name(), most, found);
    }
  }

  const Decoder& decoder_;
  std::vector<XmlPath> paths_;
  tinyxml2::XMLDocument document_;
};

}  // namespace

std::unique_ptr<FieldReader> makeXmlReader(const Decoder& decoder) {
  return std::make_unique<XmlReader>(decoder);
}

}  // namespace rocinante::decode
