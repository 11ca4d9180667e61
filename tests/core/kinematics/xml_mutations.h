#pragma once

#include <tinyxml2.h>

#include <functional>
#include <set>
#include <string>
#include <vector>

namespace rocinante::test {

/// One change of an XML text: what it is, and the text after it.
struct XmlMutation {
  std::string what;
  std::string text;
};

/// Each element and attribute of `text` removed, and an unknown element and attribute put into each
/// element, one at a time. Of elements in `unread` only the removal: what is in something that is
/// left out is left out with it.
inline std::vector<XmlMutation> mutationsOf(const std::string& text,
                                            const std::set<std::string>& unread) {
  using namespace tinyxml2;
  std::vector<XmlMutation> mutations;
  const auto elementsOf = [&](XMLDocument& document) {
    std::vector<XMLElement*> elements;
    const std::function<void(XMLElement*)> walk = [&](XMLElement* element) {
      elements.push_back(element);
      if (unread.contains(element->Name())) return;
      for (auto* child = element->FirstChildElement(); child; child = child->NextSiblingElement()) {
        walk(child);
      }
    };
    walk(document.RootElement());
    return elements;
  };
  // `change` makes one change to element `number`, and returns what it did; empty: nothing.
  const auto add = [&](std::size_t number, const auto& change) {
    XMLDocument document;
    document.Parse(text.c_str());
    std::vector<XMLElement*> elements = elementsOf(document);
    std::string what = change(*elements[number]);
    if (what.empty()) return false;
    XMLPrinter printer;
    document.Print(&printer);
    mutations.push_back({std::move(what), printer.CStr()});
    return true;
  };
  XMLDocument whole;
  whole.Parse(text.c_str());
  const std::size_t count = elementsOf(whole).size();
  const auto named = [](const XMLElement& element) {
    const char* const name = element.Attribute("name");
    return std::string("<") + element.Name() + (name ? std::string(" ") + name : "") + ">";
  };
  for (std::size_t i = 0; i < count; ++i) {
    add(i, [&](XMLElement& element) {
      if (element.Parent()->ToElement() == nullptr) return std::string();
      std::string what = "without " + named(element);
      element.Parent()->DeleteChild(&element);
      return what;
    });
    XMLElement* const here = elementsOf(whole)[i];
    if (unread.contains(here->Name())) continue;
    add(i, [&](XMLElement& element) {
      element.InsertFirstChild(element.GetDocument()->NewElement("zweckfrei"));
      return "an element in " + named(element);
    });
    add(i, [&](XMLElement& element) {
      element.SetAttribute("zweckfrei", "1");
      return "an attribute of " + named(element);
    });
    bool more = true;
    for (int attribute = 0; more; ++attribute) {
      more = add(i, [&](XMLElement& element) {
        const XMLAttribute* each = element.FirstAttribute();
        for (int skip = 0; skip < attribute && each; ++skip) each = each->Next();
        if (each == nullptr) return std::string();
        const std::string name = each->Name();
        std::string what = named(element) + " without " + name;
        element.DeleteAttribute(name.c_str());
        return what;
      });
    }
  }
  return mutations;
}

}  // namespace rocinante::test
