#include "viewer/ui/commands/study_actions.h"

#include <set>
#include <vector>

#include "viewer/shown/plot_scale.h"

namespace rocinante {

Status writePlotted(ViewModel& model, const std::filesystem::path& path) {
  std::set<SeriesKey> seen;
  std::vector<SeriesKey> keys;
  const auto add = [&](const SeriesKey& key) {
    SeriesKey series = plotValue(key, model.scene()).series;
    if (key.isValue() && seen.insert(series).second) keys.push_back(std::move(series));
  };
  for (const PlotBoard::Curve& curve : model.viewer.plots.curves()) add(curve.key);
  for (const PlotBoard::Path& both : model.viewer.plots.paths()) {
    add(both.x);
    add(both.y);
  }
  LogStudy* const study = model.study();
  if (study == nullptr || keys.empty()) {
    return Error{ErrorKind::bad_argument, "a table needs a plotted joint, pose or signal", ""};
  }
  study->writeTable(std::move(keys), model.viewer.time_view.from(), model.viewer.time_view.until(),
                    path);
  return {};
}

void showFinding(ViewModel& model, TimelineCursor& cursor, std::size_t number, SteadyTime now) {
  const FindingsStudy* const judged = model.findings();
  const CheckReport* const report = judged == nullptr ? nullptr : judged->report();
  if (report == nullptr || number == 0 || number > report->findings.size()) return;
  const Finding& finding = report->findings[number - 1];
  model.viewer.finding_shown = number;
  if (model.scene().findDevice(finding.subject) != nullptr) model.selected = {finding.subject, ""};
  if (!finding.first) return;
  cursor.seek(*finding.first, now);
  model.viewer.time_view.follow(*finding.first);
}

}  // namespace rocinante
