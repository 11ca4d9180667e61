#pragma once

#include <map>
#include <optional>
#include <string>

#include "core/bundle/cell_bundle.h"
#include "core/cell/cell.h"
#include "golden/judge/suite_runs.h"
#include "golden/judge/suite_session.h"

namespace rocinante {

/// The cells that the logs of a suite's runs were accepted with: an accepted motion is that of its
/// own model, not of today's (docs/decisions/040). They are rebuilt from the texts that the
/// manifest keeps and today's other files, without geometry. Borrows the session. One thread.
class AcceptedCells {
 public:
  AcceptedCells(const SuiteSession& session, const SuiteOptions& options)
      : session_(session), options_(options) {}

  AcceptedCell of(const AcceptedRun& accepted);

 private:
  struct Rebuilt {
    std::optional<Cell> cell;  ///< empty: as today's, or unknown
    std::string unknown;
  };
  Rebuilt rebuilt(const AcceptedRun& accepted);

  const SuiteSession& session_;
  const SuiteOptions& options_;
  std::optional<CellBundle> today_;
  bool collected_ = false;
  std::map<std::string, Rebuilt> cells_;  ///< by AcceptedRun::cell
};

}  // namespace rocinante
