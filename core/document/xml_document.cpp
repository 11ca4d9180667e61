#include "core/document/xml_document.h"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>
#include <cstdint>

#include "core/base/plain_text.h"
#include "core/document/xml_tags.h"

namespace rocinante {
namespace {

constexpr std::uint32_t kReplacement = 0xFFFD;
constexpr std::size_t kMaxDeclaration = 200;

// Windows-1252 from 0x80; 0: not assigned.
constexpr std::uint16_t kWindows1252[32] = {
    0x20AC, 0,      0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
    0x2039, 0x0152, 0,      0x017D, 0,      0,      0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0,      0x017E, 0x0178};

void addUtf8(std::uint32_t code, std::string& text) {
  const auto add = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
  if (code < 0x80) {
    add(code);
  } else if (code < 0x800) {
    add(0xC0 | code >> 6);
    add(0x80 | (code & 0x3F));
  } else if (code < 0x10000) {
    add(0xE0 | code >> 12);
    add(0x80 | (code >> 6 & 0x3F));
    add(0x80 | (code & 0x3F));
  } else {
    add(0xF0 | code >> 18);
    add(0x80 | (code >> 12 & 0x3F));
    add(0x80 | (code >> 6 & 0x3F));
    add(0x80 | (code & 0x3F));
  }
}

std::string fromUtf16(std::string_view bytes, bool big_endian) {
  const auto unit = [&](std::size_t i) -> std::uint32_t {
    const std::uint32_t first = static_cast<unsigned char>(bytes[i]);
    const std::uint32_t second = static_cast<unsigned char>(bytes[i + 1]);
    return big_endian ? first << 8U | second : second << 8U | first;
  };
  std::string text;
  text.reserve(bytes.size() / 2);
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    std::uint32_t code = unit(i);
    if (code >= 0xD800 && code < 0xDC00 && i + 3 < bytes.size() && unit(i + 2) >= 0xDC00 &&
        unit(i + 2) < 0xE000) {
      code = 0x10000 + ((code - 0xD800) << 10U) + (unit(i + 2) - 0xDC00);
      i += 2;
    } else if (code >= 0xD800 && code < 0xE000) {
      code = kReplacement;
    }
    addUtf8(code, text);
  }
  if (bytes.size() % 2 != 0) addUtf8(kReplacement, text);
  return text;
}

std::string fromLatin(std::string_view bytes, bool windows) {
  std::string text;
  text.reserve(bytes.size() + bytes.size() / 8);
  for (const char c : bytes) {
    std::uint32_t code = static_cast<unsigned char>(c);
    if (windows && code >= 0x80 && code < 0xA0) {
      code = kWindows1252[code - 0x80] == 0 ? kReplacement : kWindows1252[code - 0x80];
    }
    addUtf8(code, text);
  }
  return text;
}

/// The encoding that `<?xml ... encoding="..."?>` names, in small letters; empty: none.
std::string declaredEncoding(std::string_view bytes) {
  const std::size_t begin = std::min(bytes.find("<?xml"), kMaxDeclaration);
  std::string_view head = bytes.substr(std::min(begin, bytes.size()), kMaxDeclaration);
  head = head.substr(0, head.find("?>"));
  std::string encoding(attributeOf({"?xml", head, false, true}, "encoding"));
  std::ranges::transform(encoding, encoding.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return encoding;
}

std::string problemOf(tinyxml2::XMLError error) {
  switch (error) {
    case tinyxml2::XML_ERROR_EMPTY_DOCUMENT:
      return "the file holds no XML";
    case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT:
      return "the XML breaks off here: an end tag does not match its start tag";
    case tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED:
      return "the XML is nested deeper than 100 elements";
    case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE:
      return "the XML breaks off here: an attribute is not NAME=\"VALUE\"";
    case tinyxml2::XML_ERROR_PARSING_COMMENT:
      return "the XML breaks off here: a comment does not end";
    case tinyxml2::XML_ERROR_PARSING_CDATA:
      return "the XML breaks off here: a CDATA section does not end";
    default:
      return "the XML breaks off here: this is not a well-formed element";
  }
}

/// A declaration behind a comment is an error of XML that many tools make and none misses: blanks.
void blankLateDeclaration(std::string& text) {
  const std::size_t late = text.find("<?xml ");
  if (late == std::string::npos || text.find_first_not_of(kXmlBlanks) == late) return;
  XmlTag first;
  if (!XmlTags(text).next(first) || first.name.data() < text.data() + late) return;
  const std::size_t end = text.find("?>", late);
  if (end == std::string::npos) return;
  std::replace_if(
      text.begin() + static_cast<std::ptrdiff_t>(late),
      text.begin() + static_cast<std::ptrdiff_t>(end) + 2, [](char c) { return c != '\n'; }, ' ');
}

}  // namespace

std::string xmlAsUtf8(std::string_view bytes, std::string& problem) {
  using namespace std::string_view_literals;
  if (bytes.starts_with("\xFF\xFE\0\0"sv) || bytes.starts_with("\0\0\xFE\xFF"sv)) {
    problem = "the file is UTF-32, which is not read: save it as UTF-8";
    return {};
  }
  if (bytes.starts_with("\xFF\xFE"sv)) return fromUtf16(bytes.substr(2), false);
  if (bytes.starts_with("\xFE\xFF"sv)) return fromUtf16(bytes.substr(2), true);
  if (bytes.starts_with("<\0"sv)) return fromUtf16(bytes, false);
  if (bytes.starts_with("\0<"sv)) return fromUtf16(bytes, true);
  if (bytes.starts_with("\xEF\xBB\xBF"sv)) return std::string(bytes.substr(3));
  const std::string encoding = declaredEncoding(bytes);
  if (encoding.empty() || encoding == "utf-8" || encoding == "utf8" || isUtf8(bytesOf(bytes))) {
    return std::string(bytes);
  }
  if (encoding == "iso-8859-1" || encoding == "latin1" || encoding == "us-ascii") {
    return fromLatin(bytes, false);
  }
  if (encoding == "windows-1252" || encoding == "cp1252") return fromLatin(bytes, true);
  problem = fmt::format("the file is in the encoding {}, which is not read: save it as UTF-8",
                        quotedInFault(encoding));
  return {};
}

XmlDocument::XmlDocument(std::string text)
    : text_(std::move(text)), places_(text_), tree_(std::make_unique<tinyxml2::XMLDocument>()) {}

XmlDocument::~XmlDocument() = default;

std::unique_ptr<XmlDocument> XmlDocument::parse(std::string text, std::size_t most_elements,
                                                const Rules& rules, FaultList& faults) {
  blankLateDeclaration(text);
  std::unique_ptr<XmlDocument> made(new XmlDocument(std::move(text)));
  if (made->places_.elementCount() > most_elements) {
    faults.error(rules.too_many, {},
                 fmt::format("the file has more than {} elements", most_elements));
    return nullptr;
  }
  tinyxml2::XMLDocument& tree = *made->tree_;
  tree.Parse(made->text_.data(), made->text_.size());
  if (tree.Error()) {
    faults.error(rules.xml, {tree.ErrorLineNum(), 0}, problemOf(tree.ErrorID()));
    return nullptr;
  }
  if (tree.RootElement() == nullptr) {
    faults.error(rules.xml, {}, "the file holds no XML element");
    return nullptr;
  }
  made->places_.attach(tree);
  return made;
}

std::unique_ptr<XmlDocument> XmlDocument::parse(ByteView bytes, std::size_t most_elements,
                                                const Rules& rules, FaultList& faults) {
  std::string problem;
  std::string text = xmlAsUtf8(textOf(bytes), problem);
  if (problem.empty()) return parse(std::move(text), most_elements, rules, faults);
  faults.error(rules.xml, {}, std::move(problem));
  return nullptr;
}

const tinyxml2::XMLElement& XmlDocument::root() const { return *tree_->RootElement(); }

}  // namespace rocinante
