#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/foreign/ros/signal_messages.h"
#include "core/foreign/ros/signal_names.h"
#include "core/foreign/ros/topic_translation.h"

namespace rocinante::ros {

/// Makes signals of the messages of one topic, as the table of signal_messages.h declares them.
class SignalTranslation : public TopicTranslation {
 public:
  /// `rows`: of the topic's type, at least one; they outlive this.
  SignalTranslation(std::string_view topic, const DeviceFinder& devices, FrameTree& frames,
                    std::span<const SignalMessage> rows, SignalNames& topics);

  RosTranslator::Outcome translate(ByteView message, FieldCursor::Layout layout, LogTime time,
                                   Translated& out) override;
  /// Of a message that is one value alone.
  void use(const ChannelNames& stated) override;
  void addLeftOut(Account& account) const override;

 protected:
  /// Reads all values of a message; false where it fits no definition of its type.
  bool readSignals(ByteView message, FieldCursor::Layout layout);
  std::int64_t stampNs() const { return stamp_ns_; }
  /// Adds the statements of what was read.
  void addSignals();

 private:
  /// A signal's name and unit.
  struct Slot {
    std::string name;
    std::string_view unit;
  };
  struct Value {
    std::size_t slot;
    SignalKind kind;
    double number;
    std::string_view text;  ///< borrowed from the message or the table
  };
  /// Whose the signals of a frame are: a device's, a link's, or nobody's.
  struct Owner {
    std::string device, link;
    bool is_known = true;           ///< the frame has no name, or this is what it names
    std::vector<bool> unit_stated;  ///< by slot
  };
  /// A status of diagnostics.
  struct Status {
    std::string name;
    SignalNames keys;
    std::map<std::string, std::size_t, std::less<>> slots;
  };
  /// Values of a message that become no signal.
  struct LeftValues {
    std::string_view field, reason;
    std::uint64_t count;
  };

  bool readRow(std::size_t row, FieldCursor& cursor);
  void readField(FieldCursor& cursor, std::size_t field, const SignalField& is);
  void readCovariance(FieldCursor& cursor, const SignalField& is);
  void readLayout(FieldCursor& cursor);
  void readStatus(FieldCursor& cursor);
  void takeNumber(std::size_t slot, double number, const SignalField& is);
  void takeText(std::size_t slot, std::string_view text, std::string_view field);
  void takeKeyValue(std::size_t slot, std::string_view text);
  /// An element of a field, which is counted over all rows.
  std::size_t slotOf(std::size_t field, const SignalField& is, std::size_t element);
  /// What a status names itself; `id` is unique in it. Empty beyond the limits.
  std::optional<std::size_t> slotOf(std::string_view status, std::string_view id,
                                    std::string_view key);
  void addValue(std::size_t slot, SignalKind kind, double number, std::string_view text = {}) {
    values_.push_back({slot, kind, number, text});
  }
  void leaveOut(std::string_view field, std::string_view reason, std::uint64_t count = 1) {
    left_values_.push_back({field, reason, count});
  }
  Owner& ownerOf(std::string_view frame);
  void addShort(const Owner& owner);

  std::span<const SignalMessage> rows_;
  std::size_t row_ = 0;                 ///< the definition that fitted last
  std::string name_;                    ///< of the topic
  std::optional<ChannelNames> stated_;  ///< by the channel; another one may have another unit
  std::vector<Slot> slots_;
  std::vector<std::vector<std::size_t>> field_slots_;  ///< by field of all rows
  SignalNames status_names_;
  std::map<std::string, Status, std::less<>> statuses_;
  std::map<std::string, Owner, std::less<>> owners_;  ///< by frame
  std::size_t unknown_frames_ = 0;
  std::map<std::pair<std::string_view, std::string_view>, std::uint64_t> left_out_;

  // Of the message that was read.
  std::int64_t stamp_ns_ = 0;
  std::string_view frame_;
  bool is_own_frame_ = false;  ///< the message names it as its device
  std::vector<Value> values_;
  std::vector<LeftValues> left_values_;
  std::vector<std::string_view> sentences_;
  std::size_t field_begins_ = 0;  ///< the values of the field before, in values_
  std::string_view field_before_;

  // Of a statement `signals`.
  std::vector<std::string_view> names_;
  std::vector<double> numbers_;
  std::vector<SignalKind> kinds_;
};

}  // namespace rocinante::ros
