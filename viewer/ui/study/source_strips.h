#pragma once

#include <string>
#include <utility>
#include <vector>

#include "viewer/ui/study/log_study.h"

namespace rocinante {

/// Packets and losses of a source as a wish has them; known until `reached`. `whole`: from where to
/// where the log goes. Pure.
SourceStrip stripOf(const std::string& name, const SourceSeries& source, const StudyWish& wish,
                    const std::pair<LogTime, LogTime>& whole, LogTime reached);

/// A source's rate or loss as if it were a value; empty for a source that is not there. Pure.
std::vector<ValueColumn> rateColumns(const SeriesKey& key, const SeriesScan& series,
                                     const StudyWish& wish, LogTime reached);

}  // namespace rocinante
