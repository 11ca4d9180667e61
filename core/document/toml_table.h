#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/document/toml_node.h"
#include "core/math/vector.h"

namespace rocinante {

/// `text`, which is UTF-8, as a TOML string.
std::string tomlText(std::string_view text);

/// One TOML table read strictly: every key that was asked for is known, and finish() reports the
/// others. A value of the wrong kind is a fault with its place, and reads as absent. Borrows the
/// node and the faults.
class TomlTable {
 public:
  /// `what` names the table in messages: "[[device]]".
  TomlTable(const TomlNode& node, std::string what, FaultList& faults)
      : node_(&node), what_(std::move(what)), faults_(&faults) {}

  const std::string& what() const { return what_; }
  Place place() const { return node_->place; }
  /// Of the key's value; of the table when there is none.
  Place place(std::string_view key) const;
  FaultList& faults() const { return *faults_; }
  bool has(std::string_view key) const;

  std::optional<std::string> text(std::string_view key);
  std::optional<std::string> requiredText(std::string_view key);
  /// A name of at most 255 bytes, not empty, without a slash.
  std::optional<std::string> requiredName(std::string_view key);
  std::optional<double> number(std::string_view key);
  /// A number above 0; a fault for any other.
  std::optional<double> positiveNumber(std::string_view key);
  std::optional<bool> flag(std::string_view key);
  std::optional<Vec3> vector(std::string_view key);
  std::optional<Vec3> requiredVector(std::string_view key);
  /// A vector scaled to unit length; empty too when it has none.
  std::optional<Vec3> direction(std::string_view key);
  std::optional<Vec2> pair(std::string_view key);
  std::optional<Vec4> vector4(std::string_view key);
  /// [low, high] with low <= high.
  std::optional<std::pair<double, double>> range(std::string_view key);
  std::vector<std::string> texts(std::string_view key);
  /// "#rrggbb" or "#rrggbbaa".
  std::optional<glm::vec4> color(std::string_view key);
  /// xyz and one of rpy, rpy_deg, quaternion, of this table itself.
  Pose pose();
  std::optional<TomlTable> table(std::string_view key, std::string what);
  /// `[[key]]`: an array of tables.
  std::vector<TomlTable> tables(std::string_view key, const std::string& what);
  const TomlNode* node(std::string_view key);

  /// Reports the keys that nothing asked for, except x-*, with the likely intended key or all valid
  /// ones.
  void finish() const;

  void error(std::string_view rule, std::string_view key, std::string text,
             std::string hint = {}) const {
    faults_->error(rule, place(key), std::move(text), std::move(hint));
  }

 private:
  const TomlNode* find(std::string_view key) const;
  const TomlNode* find(std::string_view key, TomlNode::Kind kind);
  bool numbers(std::string_view key, double* values, std::size_t count);
  void missing(std::string_view key) const;

  const TomlNode* node_;
  std::string what_;
  FaultList* faults_;
  std::vector<std::string> known_;
};

}  // namespace rocinante
