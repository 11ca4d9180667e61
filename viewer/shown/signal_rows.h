#pragma once

#include <string>
#include <vector>

#include "core/packet/session_state.h"
#include "core/series/series_key.h"

namespace rocinante {

/// One signal for the panel of its device, or of those of no device.
struct SignalRow {
  SeriesKey series;   ///< what a plot of it shows; its text() is the signal's name everywhere
  std::string name;   ///< within its device: NAME, or LINK NAME; no control characters
  std::string text;   ///< the value as people read it, with its unit
  std::string owner;  ///< the SOURCE that stated it last
  SignalKind kind = SignalKind::number;
  /// A text is no number: it has no curve.
  bool isPlotted() const { return kind != SignalKind::text; }
};

/// Of a device, or of its link unless that is empty; `device` empty: of no device. In the order of
/// links and names, at most `most`.
std::vector<SignalRow> signalRows(const std::string& device, const Signals& signals,
                                  const std::string& link, std::size_t most);

/// "12.5 N.m", "true", "auto": without control characters, of a text no more than a panel shows.
std::string signalValueText(const SignalValue& value);

}  // namespace rocinante
