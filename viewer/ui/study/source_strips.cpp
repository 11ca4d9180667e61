#include "viewer/ui/study/source_strips.h"

#include <algorithm>

namespace rocinante {
namespace {

/// The mean over which rates are formed.
constexpr Nanoseconds kRateOver = std::chrono::seconds(1);

std::vector<ValueColumn> columnsOfRates(const std::vector<float>& rates) {
  std::vector<ValueColumn> columns(rates.size());
  for (std::size_t i = 0; i < rates.size(); ++i) {
    columns[i].bin = {rates[i], rates[i], rates[i], false};
    columns[i].held = rates[i];
  }
  return columns;
}

SourceStrip stripOf(const std::string& name, const SourceSeries& source, const StudyQuery& wish,
                    const std::pair<LogTime, LogTime>& whole, LogTime reached) {
  SourceStrip strip;
  strip.source = name;
  const auto rates = [&](const CountBins& bins, Nanoseconds least) {
    return bins.rates(wish.from, wish.until, wish.strip_columns, least, reached);
  };
  strip.rates = rates(source.packets, kRateOver);
  strip.lost = rates(source.lost, Nanoseconds(0));
  const auto everywhere = source.packets.rates(whole.first, whole.second, 256, kRateOver, reached);
  strip.most = everywhere.empty() ? 0 : *std::ranges::max_element(everywhere);
  return strip;
}

}  // namespace

std::vector<SourceStrip> stripsOf(const SeriesScan& series, const StudyQuery& wish,
                                  const std::pair<LogTime, LogTime>& whole, LogTime reached) {
  std::vector<SourceStrip> strips{stripOf("", series.all(), wish, whole, reached)};
  for (const auto& [name, source] : series.sources()) {
    strips.push_back(stripOf(name, source, wish, whole, reached));
  }
  return strips;
}

std::vector<ValueColumn> rateColumns(const SeriesKey& key, const SeriesScan& series,
                                     const StudyQuery& wish, LogTime reached) {
  const auto& sources = series.sources();
  const auto found = sources.find(key.name);
  const SourceSeries* const source = key.name.empty()         ? &series.all()
                                     : found == sources.end() ? nullptr
                                                              : &found->second;
  if (source == nullptr) return {};
  const CountBins& bins = key.kind == SeriesKey::Kind::rate ? source->packets : source->lost;
  return columnsOfRates(bins.rates(wish.from, wish.until, wish.columns, kRateOver, reached));
}

}  // namespace rocinante
