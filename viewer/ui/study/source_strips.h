#pragma once

#include <string>
#include <utility>
#include <vector>

#include "viewer/ui/study/study_picture.h"

namespace rocinante {

/// Packets and losses as a wish has them, of all and then by source; known until `reached`.
/// `whole`: from where to where the log goes. Pure.
std::vector<SourceStrip> stripsOf(const SeriesScan& series, const StudyQuery& wish,
                                  const std::pair<LogTime, LogTime>& whole, LogTime reached);

/// A source's rate or loss as if it were a value; empty for a source that is not there. Pure.
std::vector<ValueColumn> rateColumns(const SeriesKey& key, const SeriesScan& series,
                                     const StudyQuery& wish, LogTime reached);

}  // namespace rocinante
