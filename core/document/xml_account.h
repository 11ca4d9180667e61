#pragma once

#include <functional>
#include <map>
#include <string_view>
#include <vector>

#include "core/document/fault_list.h"
#include "core/document/xml_places.h"

namespace rocinante {

/// What a reader uses of the elements of one name.
struct XmlUse {
  std::vector<std::string_view> children{}, attributes{};
  /// Children that the format defines and the reader does not use, with the reason, a clause.
  std::map<std::string_view, std::string_view> ignored{};
};

/// By name: the same wherever an element of the name is.
using XmlUses = std::map<std::string_view, XmlUse>;

/// Adds to the account what `root` has and what is used below it has besides `uses`: elements by
/// their names, attributes as `ELEMENT/@NAME`, each at the place of the first. What looks like a
/// typo of a name that is used is a warning of `typo_rule`; namespace declarations are left alone.
/// `visit`, where given, sees each used element first; false: nothing below it is looked at.
void accountForXml(const tinyxml2::XMLElement& root, const XmlPlaces& places, const XmlUses& uses,
                   std::string_view typo_rule, FaultList& faults,
                   const std::function<bool(const tinyxml2::XMLElement&)>& visit = {});

}  // namespace rocinante
