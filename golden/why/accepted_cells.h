#pragma once

#include <map>
#include <optional>
#include <string>

#include "core/bundle/cell_bundle.h"
#include "core/cell/cell.h"
#include "golden/judge/suite_session.h"

namespace rocinante {

/// The cells that the logs of a suite's runs were accepted with: an accepted motion is that of its
/// own model, not of today's (docs/decisions/040). They are rebuilt from the texts that the
/// manifest keeps and today's other files, without geometry. Borrows the session. One thread.
class AcceptedCells {
 public:
  AcceptedCells(const SuiteSession& session, const SuiteOptions& options)
      : session_(session), options_(options) {}

  /// Null when its links are where today's are, or when it cannot be rebuilt: see unknown().
  const Cell* of(const AcceptedRun& accepted);
  /// A clause for the user when a cell that has changed could not be rebuilt; else empty.
  const std::string& unknown() const { return unknown_; }

 private:
  std::optional<Cell> rebuilt(const AcceptedRun& accepted);

  const SuiteSession& session_;
  const SuiteOptions& options_;
  std::optional<CellBundle> today_;
  bool collected_ = false;
  std::map<std::string, std::optional<Cell>> cells_;  ///< by AcceptedRun::cell
  std::string unknown_;
};

}  // namespace rocinante
