#include "core/document/xml_places.h"

#include <tinyxml2.h>

#include <algorithm>
#include <cstdint>

namespace rocinante {
namespace {

constexpr std::string_view kSpaces = " \t\r\n";

bool isSpace(char c) { return kSpaces.find(c) != std::string_view::npos; }

}  // namespace

XmlPlaces::XmlPlaces(std::string_view text) : text_(text) {
  lines_.push_back(0);
  for (std::size_t i = 0; i < text_.size(); ++i) {
    if (text_[i] == '\n') lines_.push_back(i + 1);
  }
  scan();
}

std::size_t XmlPlaces::after(std::string_view end, std::size_t from) const {
  const std::size_t found = text_.find(end, from);
  return found == std::string_view::npos ? text_.size() : found + end.size();
}

void XmlPlaces::scan() {
  std::size_t at = 0;
  while ((at = text_.find('<', at)) != std::string_view::npos) {
    const std::string_view rest = text_.substr(at);
    if (rest.starts_with("<!--")) {
      at = after("-->", at + 4);
    } else if (rest.starts_with("<![CDATA[")) {
      at = after("]]>", at + 9);
    } else if (rest.starts_with("<?")) {
      at = after("?>", at + 2);
    } else if (rest.starts_with("<!") || rest.starts_with("</")) {
      at = after(">", at + 2);
    } else {
      starts_.push_back(at);
      for (++at; at < text_.size() && text_[at] != '>'; ++at) {
        if (text_[at] == '"' || text_[at] == '\'') {
          at = std::min(text_.find(text_[at], at + 1), text_.size() - 1);
        }
      }
    }
  }
}

void XmlPlaces::attach(tinyxml2::XMLDocument& document) const {
  std::size_t next = 0;
  tinyxml2::XMLElement* element = document.FirstChildElement();
  while (element != nullptr && next < starts_.size()) {
    element->SetUserData(reinterpret_cast<void*>(static_cast<std::uintptr_t>(starts_[next] + 1)));
    ++next;
    tinyxml2::XMLElement* following = element->FirstChildElement();
    while (following == nullptr && element != nullptr) {
      following = element->NextSiblingElement();
      tinyxml2::XMLNode* above = element->Parent();
      element = above == nullptr ? nullptr : above->ToElement();
    }
    element = following;
  }
}

Place XmlPlaces::at(std::size_t offset) const {
  const auto next = std::upper_bound(lines_.begin(), lines_.end(), offset);
  return {static_cast<int>(next - lines_.begin()), static_cast<int>(offset - *std::prev(next)) + 1};
}

Place XmlPlaces::of(const tinyxml2::XMLElement& element) const {
  const auto noted = reinterpret_cast<std::uintptr_t>(element.GetUserData());
  if (noted == 0) return {element.GetLineNum(), 0};
  return at(noted - 1);
}

Place XmlPlaces::of(const tinyxml2::XMLElement& element, std::string_view attribute) const {
  const auto noted = reinterpret_cast<std::uintptr_t>(element.GetUserData());
  if (noted == 0) return {element.GetLineNum(), 0};
  std::size_t i = noted;
  while (i < text_.size() && text_[i] != '>') {
    if (text_[i] == '"' || text_[i] == '\'') {
      const std::size_t end = text_.find(text_[i], i + 1);
      if (end == std::string_view::npos) break;
      i = end + 1;
      continue;
    }
    if (isSpace(text_[i - 1]) && text_.substr(i).starts_with(attribute)) {
      std::size_t behind = i + attribute.size();
      while (behind < text_.size() && isSpace(text_[behind])) ++behind;
      if (behind < text_.size() && text_[behind] == '=') return at(i);
    }
    ++i;
  }
  return of(element);
}

}  // namespace rocinante
