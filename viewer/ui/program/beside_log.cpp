#include "viewer/ui/program/beside_log.h"

#include <utility>

#include "core/base/plain_text.h"
#include "core/check/log_account.h"
#include "viewer/ui/model/misfits.h"
#include "viewer/ui/program/view_content.h"

namespace rocinante {

Result<BesideAdded> addBeside(BesideLog beside, const ContentRequest& asked, ViewContent& content) {
  const std::string name = plainText(asked.beside.filename().string());
  const Cell& cell = content.model->cell();
  StateDamage hiding;  // the panel counts all places of damage
  const auto last = beside.session.stateAt(beside.session.end(), &hiding);
  if (!last.ok()) return last.error();
  const std::string why = whyNoSession(cell, **last);
  if (!why.empty()) return BesideAdded{name + " is not shown beside: it " + why, {}};
  const std::string note =
      logAccount(beside.session, cell.bare_model.empty() ? &cell : nullptr).note();
  if (!note.empty()) beside.warnings.push_back(note);
  const Status shown = content.model->showBeside(std::move(beside.session), asked.align);
  if (!shown) return shown.error();
  content.beside_folder = std::move(beside.folder);
  BesideAdded added;
  for (const std::string& warning : beside.warnings) {
    added.warnings.push_back(name + ": " + warning);
    content.model->viewer.panels.notes.push_back({added.warnings.back(), false});
  }
  return added;
}

}  // namespace rocinante
