#pragma once

#include <tinyxml2.h>

#include <optional>
#include <string>
#include <string_view>

#include "core/document/fault_list.h"
#include "core/document/xml_places.h"
#include "core/math/vector.h"

namespace rocinante {

/// The context for reading one URDF file; borrowed by the readers of its parts.
struct UrdfContext {
  const XmlPlaces& places;
  FaultList& faults;
};

/// One element with typed attributes. A malformed value is a fault with its place, and reads as if
/// the attribute were absent.
class UrdfElement {
 public:
  UrdfElement(const tinyxml2::XMLElement& element, const UrdfContext& context)
      : element_(&element), context_(&context) {}

  std::string_view tag() const { return element_->Name(); }
  Place place() const { return context_->places.of(*element_); }
  Place place(std::string_view attribute) const {
    return context_->places.of(*element_, attribute);
  }
  FaultList& faults() const { return context_->faults; }

  /// The child element of that name; a fault when there are several (the first is used).
  std::optional<UrdfElement> child(const char* name) const;
  /// Calls `use` for each child element of that name.
  template <class Use>
  void each(const char* name, Use use) const {
    for (const auto* e = element_->FirstChildElement(name); e; e = e->NextSiblingElement(name)) {
      use(UrdfElement(*e, *context_));
    }
  }
  template <class Use>
  void eachChild(Use use) const {
    for (const auto* e = element_->FirstChildElement(); e; e = e->NextSiblingElement()) {
      use(UrdfElement(*e, *context_));
    }
  }
  bool has(const char* attribute) const { return element_->Attribute(attribute) != nullptr; }
  /// Empty when absent.
  std::string text(const char* attribute) const;
  /// The text; a fault and empty when the attribute is absent or empty.
  std::optional<std::string> requiredText(const char* attribute) const;
  std::optional<double> number(const char* attribute) const;
  std::optional<double> requiredNumber(const char* attribute) const;
  std::optional<Vec3> vector(const char* attribute) const;
  std::optional<Vec4> vector4(const char* attribute) const;
  /// `<origin xyz rpy>`, or with `quat_xyzw` in place of `rpy`, below this element; identity when
  /// absent.
  Pose origin() const;

 private:
  bool numbers(const char* attribute, double* values, std::size_t count) const;
  void missing(const char* attribute) const;

  const tinyxml2::XMLElement* element_;
  const UrdfContext* context_;
};

}  // namespace rocinante
