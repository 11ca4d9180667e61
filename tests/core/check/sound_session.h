#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/check/rules/check_report.h"

namespace rocinante::test {

/// One packet of the valid session, in parts that a fault can be put into.
struct SaidPacket {
  double arrives_s = 0;  ///< from the start
  std::string source, run = "a", sequence, time, words;
  std::vector<std::string> statements;
  std::string encoding = "rk1";
};

/// A cell of two robots and a planner, and fourteen seconds of its session without any fault. Tests
/// put a fault into it to see which rule finds it.
struct SoundSession {
  SoundSession();

  std::string urdf, obj, cell;
  std::vector<SaidPacket> packets;  ///< in order of arrival

  /// In every file and statement; the text must be there.
  void replace(std::string& text, std::string_view what, std::string_view by);
  /// In the statements of all packets of a source that arrive in [from, until).
  void replaceSaid(std::string_view source, std::string_view what, std::string_view by,
                   double from_s = 0, double until_s = 100);
  /// Packets of a source in [from, until), restatements or not.
  std::vector<SaidPacket*> of(std::string_view source, double from_s = 0, double until_s = 100,
                              bool restated = false);
  /// Appends a statement to the first packet of a source at or after a moment.
  void say(std::string_view source, double at_s, std::string statement);
  void erase(std::string_view source, double from_s, double until_s);
  /// Sends the statements of `packet` from another source at another time, in order of arrival.
  void insert(SaidPacket packet);
  void sort();

  CheckReport judge() const;
};

}  // namespace rocinante::test
