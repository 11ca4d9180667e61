#pragma once

#include <tinyxml2.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/document/fault_list.h"

namespace rocinante {

/// The XML of one COLLADA file: its references, its lists of numbers, and which elements were used.
/// What is not marked as used when the reading is over is the file's account, so that a reader
/// cannot forget to name what it leaves out.
class ColladaDocument {
 public:
  using Element = tinyxml2::XMLElement;

  explicit ColladaDocument(FaultList& faults) : faults_(faults) {}

  /// In any encoding of xmlAsUtf8(). damaged: another encoding, not XML, not COLLADA, nested deeper
  /// than 100 elements, or more than 10 million tags. The error lacks the file's name.
  Status parse(ByteView bytes);

  Element& root() { return *xml_.RootElement(); }
  FaultList& faults() { return faults_; }

  /// The first child `name`, marked as used; null when there is none.
  static Element* child(Element& parent, const char* name);
  /// All children `name`, marked as used.
  static std::vector<Element*> children(Element& parent, const char* name);
  static void use(Element& element) { element.SetUserData(&element); }

  /// The element `name` with that id, marked as used; null when there is none.
  Element* find(std::string_view name, std::string_view id) const;
  /// The element `name` that an attribute of `from` refers to as "#id"; null with a warning when
  /// the file has none.
  Element* follow(const Element& from, const char* attribute, const char* name);

  static std::string_view attribute(const Element& element, const char* name);
  /// `otherwise` when it is not a number from 0.
  static std::uint64_t numberOf(const Element& element, const char* name, std::uint64_t otherwise);
  static Place placeOf(const Element& element) { return {element.GetLineNum(), 0}; }

  /// The text without blanks around it.
  static std::string text(const Element& element);
  /// Numbers between blanks, which may begin and end the list. What is not a number is NaN, with a
  /// fault.
  std::vector<double> numbers(const Element& element);
  /// Those of an element that needs `count` finite ones; empty with a fault when it has others.
  std::vector<double> numbers(const Element& element, std::size_t count);
  /// Adds whole numbers from 0. What is none is kBadIndex, with a fault.
  void addIndices(const Element& element, std::vector<std::uint32_t>& indices);
  static constexpr std::uint32_t kBadIndex = 0xFFFFFFFF;

  /// Names everything that is not marked as used, the outermost elements only.
  void accountForRest();

 private:
  struct Key {
    std::string_view name, id;
    bool operator==(const Key&) const = default;
  };
  struct HashOfKey {
    std::size_t operator()(const Key& key) const;
  };
  Status index();
  void leaveOut(const Element& element);
  void leaveOutAttributes(const Element& element);
  void badNumber(const Element& element, std::string_view word);

  FaultList& faults_;
  tinyxml2::XMLDocument xml_;
  std::unordered_map<Key, Element*, HashOfKey> ids_;
};

}  // namespace rocinante
