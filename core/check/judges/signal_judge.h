#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "core/cell/cell.h"
#include "core/check/judges/sender_judge.h"
#include "core/check/judges/tally.h"
#include "core/packet/packet.h"

namespace rocinante {

/// Judges the signals of a session by the cell's [[signal]]s, and their kinds and units by
/// themselves. No allocation per packet once its signals have been seen. The cell must outlive it.
/// One thread.
class SignalJudge {
 public:
  explicit SignalJudge(const Cell& cell) : cell_(cell) {}

  /// A statement of kind signal or signals.
  void take(const Statement& statement, const PacketPlace& place);
  /// A statement that says where a device is; only what signals may be stuck beside is read.
  void takeMotion(const Statement& statement, const PacketPlace& place);
  /// The device was removed, and its signals with it.
  void forget(std::string_view device);

  /// `sources`: their names, by number.
  void report(const std::vector<std::string>& sources, Findings& findings) const;
  /// Forgets what was found; the signals are followed on.
  void dropFindings();

 private:
  struct Key {
    std::string device, link, name;
  };
  struct KeyView {
    KeyView(std::string_view of_device, std::string_view of_link, std::string_view of_name)
        : device(of_device), link(of_link), name(of_name) {}
    KeyView(const Key& key) : device(key.device), link(key.link), name(key.name) {}
    std::string_view device, link, name;
    bool operator<(const KeyView& o) const {
      return std::tie(device, link, name) < std::tie(o.device, o.link, o.name);
    }
  };
  struct Order {
    using is_transparent = void;
    bool operator()(const KeyView& a, const KeyView& b) const { return a < b; }
  };

  /// A finding's tally, with its worst case.
  struct Worst {
    Tally tally;
    double figure = 0;  ///< how bad, in the rule's own measure
    double value = 0;   ///< as the sentence says it
    void hit(const PacketPlace& place, double how_bad, double of_value);
  };
  /// Values or changes that are not allowed, by what they are.
  using Wrong = std::map<std::pair<std::string, std::string>, Tally>;

  struct Signal {
    const CellSignal* expected = nullptr;  ///< null: the cell says nothing of it
    bool has_value = false;
    SignalKind kind = SignalKind::number;
    double number = 0;
    std::string text, unit;
    std::uint32_t source = 0, stretch = 0;
    LogTime changed{};      ///< when the number last did
    bool is_stuck = false;  ///< already counted since then

    LogTime window_began{};
    std::uint64_t window_count = 0;
    bool is_counted = false;  ///< a window has begun

    bool is_other_unit = false;  ///< than the cell's: not judged as a number
    bool was_in_unit = false;    ///< some number was, since findings were dropped
    std::uint32_t writer = TwoSources::kNobody;

    TwoSources two_writers;
    Tally kinds, units, not_numbers;
    std::string other_kind, other_unit;  ///< of the first one
    std::string first_kind, first_unit, not_number;
    Worst range, jump, rate, stuck;
    Wrong values, transitions;
    /// Nothing is lost when it is forgotten.
    bool isClean() const;
    void drop();
  };
  using Signals = std::map<Key, Signal, Order>;

  /// Of a device with signals that may be stuck.
  struct Motion {
    std::map<std::size_t, std::size_t> values;  ///< what was stated last, by what it is; hashes
    LogTime began{}, last{};                    ///< of its changes without a pause
    /// False when it repeats what was stated last.
    bool changes(std::size_t what, std::size_t value);
  };

  /// The first of the cell that fits, or null.
  const CellSignal* expectedOf(const PathView& path, std::string_view name);
  /// Null when as many are followed as a state has at most, which refuses further ones.
  Signal* signalNamed(const PathView& path, std::string_view name);
  void judge(Signal& signal, const Statement& statement, std::size_t index,
             const PacketPlace& place) const;
  void judgeNumber(Signal& signal, double number, bool follows, const PacketPlace& place) const;
  void judgeState(Signal& signal, std::string_view text, bool follows,
                  const PacketPlace& place) const;
  void judgeRate(Signal& signal, const PacketPlace& place) const;
  void reportOne(const Key& key, const Signal& signal, const std::vector<std::string>& sources,
                 Findings& findings) const;
  std::string missingText(const CellSignal& expected, const std::string& name) const;

  const Cell& cell_;
  Signals signals_;
  std::set<const CellSignal*> came_;
  Tally too_many_;
  std::map<std::string, Motion, std::less<>> motions_;
};

}  // namespace rocinante
