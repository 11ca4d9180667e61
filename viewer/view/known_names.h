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

/// What the PATHs of a view and the names of cameras can mean, so that a slip is told and does not
/// silently hide nothing: the rule of docs/rendering.md, section "Names". Borrows the cell. One
/// thread.
class KnownNames {
 public:
  explicit KnownNames(const Cell& cell);

  /// Devices that the log adds and views that it holds count too. It is read, once, when a name is
  /// asked for that the cell does not have.
  void useLog(std::filesystem::path log) { log_ = std::move(log); }
  /// A live session: nobody knows which devices and views will come.
  void expectOthers() { others_may_come_ = true; }

  /// not_found for a layer, device, link or part that no picture can have. What is no PATH at all
  /// is left to those who use it.
  Status check(const std::vector<std::string>& paths);
  Status check(const RenderStyle& style);
  /// not_found for a device that no picture can have.
  Status checkDevice(const std::string& device);
  /// The same for a camera, besides those that are built in and viewpoints in numbers.
  Status checkCamera(const std::string& name);
  /// The device that `path` names, when it is none of the cell's and only expectOthers() let it
  /// pass: a sentence to warn with. Empty otherwise.
  std::string doubtAbout(const std::string& path) const;

 private:
  using Models = std::vector<const Model*>;

  Status checkOne(const std::string& text);
  Status checkLayer(const std::string& layer) const;
  Status checkBelow(const ViewPath& path, const Models& models) const;
  Status readLog();
  /// Of a device as a picture may have it; empty when there is none of that name.
  std::optional<Models> modelsOf(const std::string& device) const;
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
  std::set<std::string> sound_;  ///< PATHs that were found to be fit
};

}  // namespace rocinante
