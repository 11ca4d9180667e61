#include "core/document/xml_account.h"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>
#include <string>

#include "core/base/name_hint.h"

namespace rocinante {
namespace {

constexpr std::size_t kMaxHints = 1000;
constexpr std::size_t kNameBytes = 60;

class XmlAccount {
 public:
  using Visit = std::function<bool(const tinyxml2::XMLElement&)>;
  XmlAccount(const XmlPlaces& places, const XmlUses& uses, std::string_view typo_rule,
             FaultList& faults, const Visit& visit)
      : places_(places), uses_(uses), typo_rule_(typo_rule), faults_(faults), visit_(visit) {}

  // As deep as the XML, of which tinyxml2 reads 100 elements.
  void add(const tinyxml2::XMLElement& element) {
    if (visit_ && !visit_(element)) return;
    static const XmlUse kNothing;
    const auto known = uses_.find(element.Name());
    const XmlUse& use = known == uses_.end() ? kNothing : known->second;
    addAttributes(element, use);
    for (const auto* child = element.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
      const std::string_view name = child->Name();
      if (std::ranges::find(use.children, name) != use.children.end()) {
        add(*child);
      } else if (const auto ignored = use.ignored.find(name); ignored != use.ignored.end()) {
        faults_.leaveOut("element", name, places_.of(*child), std::string(ignored->second));
      } else {
        addUnknown(element, *child, use);
      }
    }
  }

 private:
  void addAttributes(const tinyxml2::XMLElement& element, const XmlUse& use) {
    for (const auto* each = element.FirstAttribute(); each != nullptr; each = each->Next()) {
      const std::string_view name = each->Name();
      if (name == "xmlns" || name.starts_with("xmlns:") || name.starts_with("xml:") ||
          name.starts_with("xsi:") ||
          std::ranges::find(use.attributes, name) != use.attributes.end()) {
        continue;
      }
      const std::string what =
          fmt::format("{}/@{}", element.Name(), std::string(name.substr(0, kNameBytes)));
      const std::string hint = hintFor(what, name, use.attributes, {});
      if (hint.empty()) {
        faults_.leaveOut("attribute", what, places_.of(element, name),
                         "an attribute that is not read");
      } else {
        faults_.leaveOut("attribute", what, places_.of(element, name),
                         fmt::format("<{}> has no such attribute", element.Name()),
                         Severity::warning, typo_rule_, hint);
      }
    }
  }

  void addUnknown(const tinyxml2::XMLElement& above, const tinyxml2::XMLElement& element,
                  const XmlUse& use) {
    const std::string name(std::string_view(element.Name()).substr(0, kNameBytes));
    const std::string hint =
        hintFor(fmt::format("{}/{}", above.Name(), name), name, use.children, use.ignored);
    if (hint.empty()) {
      faults_.leaveOut("element", name, places_.of(element), "an extension that is not read");
    } else {
      faults_.leaveOut("element", name, places_.of(element),
                       fmt::format("<{}> has no such element", above.Name()), Severity::warning,
                       typo_rule_, hint);
    }
  }

  /// Each once: a file may have a million of them, each beside twenty known names.
  std::string hintFor(const std::string& what, std::string_view name,
                      const std::vector<std::string_view>& used,
                      const std::map<std::string_view, std::string_view>& ignored) {
    const auto known = hints_.find(what);
    if (known != hints_.end()) return known->second;
    if (hints_.size() >= kMaxHints) return {};
    std::vector<std::string_view> names = used;
    for (const auto& [other, reason] : ignored) names.push_back(other);
    return hints_[what] = didYouMean(name, names);
  }

  const XmlPlaces& places_;
  const XmlUses& uses_;
  std::string_view typo_rule_;
  FaultList& faults_;
  const Visit& visit_;
  std::map<std::string, std::string> hints_;
};

}  // namespace

void accountForXml(const tinyxml2::XMLElement& root, const XmlPlaces& places, const XmlUses& uses,
                   std::string_view typo_rule, FaultList& faults,
                   const std::function<bool(const tinyxml2::XMLElement&)>& visit) {
  XmlAccount(places, uses, typo_rule, faults, visit).add(root);
}

}  // namespace rocinante
