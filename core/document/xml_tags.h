#pragma once

#include <algorithm>
#include <string_view>

namespace rocinante {

inline constexpr std::string_view kXmlBlanks = " \t\r\n";

/// One start or end tag; views into the text.
struct XmlTag {
  std::string_view name;   ///< without the slash
  std::string_view inner;  ///< the text between the name and the bracket
  bool ends = false;       ///< an end tag, or one that is both
  bool starts = false;
};

/// Walks through the tags of XML, without judging it: comments, CDATA and declarations are passed
/// over. Borrows the text.
class XmlTags {
 public:
  explicit XmlTags(std::string_view text) : text_(text) {}

  bool next(XmlTag& tag) {
    while ((at_ = text_.find('<', at_)) != std::string_view::npos) {
      const std::string_view rest = text_.substr(at_);
      if (rest.starts_with("<!--")) {
        skipPast("-->");
      } else if (rest.starts_with("<![CDATA[")) {
        skipPast("]]>");
      } else if (rest.starts_with("<?")) {
        skipPast("?>");
      } else if (rest.starts_with("<!")) {
        skipPast(">");
      } else {
        return readTag(tag);
      }
    }
    return false;
  }

 private:
  void skipPast(std::string_view end) {
    at_ = text_.find(end, at_);
    at_ = at_ == std::string_view::npos ? text_.size() : at_ + end.size();
  }

  bool readTag(XmlTag& tag) {
    std::size_t end = at_ + 1;
    for (; end < text_.size() && text_[end] != '>'; ++end) {
      if (text_[end] != '"' && text_[end] != '\'') continue;
      end = text_.find(text_[end], end + 1);
      if (end == std::string_view::npos) break;
    }
    if (end == std::string_view::npos || end >= text_.size()) return false;
    std::string_view inner = text_.substr(at_ + 1, end - at_ - 1);
    at_ = end + 1;
    tag.starts = !inner.starts_with('/');
    tag.ends = !tag.starts || inner.ends_with('/');
    if (!tag.starts) inner.remove_prefix(1);
    if (tag.starts && tag.ends) inner.remove_suffix(1);
    const std::size_t blank = std::min(inner.find_first_of(kXmlBlanks), inner.size());
    tag.name = inner.substr(0, blank);
    tag.inner = inner.substr(blank);
    return true;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

/// The value of an attribute; empty when there is none.
inline std::string_view attributeOf(const XmlTag& tag, std::string_view name) {
  for (std::size_t at = 0; (at = tag.inner.find(name, at)) != std::string_view::npos; ++at) {
    if (at == 0 || kXmlBlanks.find(tag.inner[at - 1]) == std::string_view::npos) continue;
    std::size_t from = tag.inner.find_first_not_of(kXmlBlanks, at + name.size());
    if (from == std::string_view::npos || tag.inner[from] != '=') continue;
    from = tag.inner.find_first_not_of(kXmlBlanks, from + 1);
    if (from == std::string_view::npos) return {};
    const std::size_t end = tag.inner.find(tag.inner[from], from + 1);
    if (end == std::string_view::npos) return {};
    return tag.inner.substr(from + 1, end - from - 1);
  }
  return {};
}

}  // namespace rocinante
