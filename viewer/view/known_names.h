#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/cell/cell.h"
#include "core/cell/view_path.h"
#include "viewer/view/render_style.h"

namespace rocinante {

/// The valid PATHs and camera names of a cell and log, so that a typo is refused instead of hiding
/// nothing: docs/rendering.md, section "Names". Borrows the cell. Not thread-safe.
class KnownNames {
 public:
  explicit KnownNames(const Cell& cell);

  /// Also accepts devices and views of the log. The log is read once, for the first name that the
  /// cell does not have.
  void useLog(std::filesystem::path log) { log_ = std::move(log); }
  /// For a live session: unknown devices and views may still appear.
  void expectOthers() { others_may_come_ = true; }
  /// Devices have a ghost each (BesideSession).
  void expectBeside() { beside_is_shown_ = true; }

  /// not_found for a layer, device, link or part that no picture can have. Invalid PATHs are
  /// accepted here; their users refuse them.
  Status check(const std::vector<std::string>& paths);
  Status check(const RenderStyle& style);
  /// not_found for a device that no picture can have.
  Status checkDevice(const std::string& device);
  /// The same for a camera; built-in cameras and viewpoints in numbers are always valid.
  Status checkCamera(const std::string& name);
  /// A warning when the device of `path` is not in the cell and passed only because of
  /// expectOthers(). Empty otherwise.
  std::string doubtAbout(const std::string& path) const;

 private:
  using Models = std::vector<const Model*>;

  Status checkOne(const std::string& text);
  Status checkLayer(const std::string& layer) const;
  Status checkBelow(const ViewPath& path, const Models& models) const;
  Status readLog();
  void noteBare(std::string_view device);
  /// The possible models of a device; empty for an unknown name.
  std::optional<Models> modelsOf(const std::string& named) const;
  Models allModels() const;
  std::string deviceHint(const std::string& name) const;

  const Cell& cell_;
  std::set<std::string, std::less<>> layers_;
  std::map<std::string, Models, std::less<>> others_;  ///< ghosts, and devices of [[source]]
  std::filesystem::path log_;                          ///< empty: none
  bool log_read_ = false;
  std::map<std::string, std::set<std::string>, std::less<>> added_;  ///< models by device
  std::set<std::string, std::less<>> views_;
  bool others_may_come_ = false;
  bool beside_is_shown_ = false;
  std::set<std::string> sound_;  ///< PATHs already checked
};

}  // namespace rocinante
