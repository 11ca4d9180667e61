#include "core/foreign/ros/signal_translation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/plain_text.h"
#include "core/packet/packet_limits.h"
#include "core/packet/text_number.h"

namespace rocinante::ros {
namespace {

constexpr const char* kNotFinite = "not a number, or infinite";
/// Signals of a topic that names them itself.
constexpr std::size_t kMaxSlots = 4096;
/// Beyond this whole numbers are not exact in a double.
constexpr double kExact = 9007199254740992.0;
/// The fewest bytes of a DiagnosticStatus: bounds the count of a sequence.
constexpr std::size_t kLeastStatusBytes = 4 * sizeof(std::uint32_t);
constexpr std::string_view kLevels = "OK WARN ERROR STALE";
constexpr SignalField kLevel{Wire::u8, "level", "", "", FieldUse::signal, 1, kLevels};

std::size_t wireBytes(Wire wire) {
  switch (wire) {
    case Wire::boolean:
    case Wire::i8:
    case Wire::u8:
      return 1;
    case Wire::i16:
    case Wire::u16:
      return 2;
    case Wire::i32:
    case Wire::u32:
    case Wire::f32:
      return 4;
    default:
      return 8;
  }
}

double readNumberOf(FieldCursor& cursor, Wire wire) {
  switch (wire) {
    case Wire::boolean:
    case Wire::u8:
      return cursor.number<std::uint8_t>();
    case Wire::i8:
      return cursor.number<std::int8_t>();
    case Wire::i16:
      return cursor.number<std::int16_t>();
    case Wire::u16:
      return cursor.number<std::uint16_t>();
    case Wire::i32:
      return cursor.number<std::int32_t>();
    case Wire::u32:
      return cursor.number<std::uint32_t>();
    case Wire::i64:
      return static_cast<double>(cursor.number<std::int64_t>());
    case Wire::u64:
      return static_cast<double>(cursor.number<std::uint64_t>());
    case Wire::f32:
      return static_cast<double>(cursor.number<float>());
    default:
      return cursor.number<double>();
  }
}

/// Word `number` of the blank-separated; empty behind the last.
std::string_view wordOf(std::string_view words, std::size_t number) {
  for (; number > 0; --number) {
    const std::size_t blank = words.find(' ');
    if (blank == words.npos) return {};
    words.remove_prefix(blank + 1);
  }
  return words.substr(0, words.find(' '));
}

std::string_view digitsOf(std::uint8_t number) {
  static const std::array<std::string, 256> kDigits = [] {
    std::array<std::string, 256> all;
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = std::to_string(i);
    return all;
  }();
  return kDigits[number];
}

std::string signalName(std::string_view topic, const SignalField& is, std::size_t element) {
  std::string name(topic);
  if (is.name != kWhole) name.append(".").append(is.name);
  if (!is.parts.empty()) name.append(".") += is.parts[element];
  if (is.count == kSequence) name.append(".").append(std::to_string(element));
  return name;
}

}  // namespace

SignalTranslation::SignalTranslation(std::string_view topic, const DeviceFinder& devices,
                                     FrameTree& frames, std::span<const SignalMessage> rows,
                                     SignalNames& topics)
    : TopicTranslation(topic, devices, frames), rows_(rows), name_(topics.of(topic)) {
  std::size_t fields = 0;
  for (const SignalMessage& row : rows_) fields += row.fields.size();
  field_slots_.resize(fields);
  if (topics.isNumbered(topic)) {
    note("its signals are called `" + name_ + "`, since another topic has the name without number");
  }
}

RosTranslator::Outcome SignalTranslation::translate(ByteView message, FieldCursor::Layout layout,
                                                    LogTime, Translated& out) {
  if (!readSignals(message, layout)) return RosTranslator::Outcome::malformed;
  begin(stamp_ns_);
  addSignals();
  return end(out);
}

void SignalTranslation::use(const ChannelNames& stated) {
  if (stated.signal.empty() || field_slots_.size() != 1) return;
  stated_ = stated;
  slots_ = {{stated_->signal, stated_->unit}};
  field_slots_[0] = {0};
  owners_[""] = {stated_->device, stated_->link, true, {}};
}

void SignalTranslation::addLeftOut(Account& account) const {
  for (const auto& [what, count] : left_out_) {
    account.leaveOut({.kind = "value",
                      .name = std::string(what.first),
                      .reason = std::string(what.second),
                      .first = topic_,
                      .count = count});
  }
}

bool SignalTranslation::readSignals(ByteView message, FieldCursor::Layout layout) {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const std::size_t row = (row_ + i) % rows_.size();
    FieldCursor cursor(message, layout);
    if (!readRow(row, cursor)) continue;
    row_ = row;
    for (const LeftValues& each : left_values_) left_out_[{each.field, each.reason}] += each.count;
    for (const std::string_view sentence : sentences_) note(sentence);
    return true;
  }
  return false;
}

bool SignalTranslation::readRow(std::size_t row, FieldCursor& cursor) {
  stamp_ns_ = 0;
  frame_ = {};
  is_own_frame_ = false;
  values_.clear();
  left_values_.clear();
  sentences_.clear();
  std::size_t field = 0;
  for (std::size_t i = 0; i < row; ++i) field += rows_[i].fields.size();
  for (const SignalField& is : rows_[row].fields) {
    const std::size_t begins = values_.size();
    readField(cursor, field++, is);
    if (!cursor.ok()) return false;
    field_begins_ = begins;
    field_before_ = is.name;
  }
  return cursor.atEnd();
}

void SignalTranslation::readField(FieldCursor& cursor, std::size_t field, const SignalField& is) {
  if (is.wire == Wire::header) {
    const Header header = readHeader(cursor);
    stamp_ns_ = header.stamp_ns;
    frame_ = header.frame;
  } else if (is.wire == Wire::layout) {
    readLayout(cursor);
  } else if (is.wire == Wire::status || is.wire == Wire::statuses) {
    const std::uint32_t count = is.wire == Wire::status ? 1 : cursor.count(kLeastStatusBytes);
    for (std::uint32_t i = 0; i < count && cursor.ok(); ++i) readStatus(cursor);
  } else if (is.use == FieldUse::frame) {
    frame_ = frameName(cursor.string());
    is_own_frame_ = true;
  } else if (is.use == FieldUse::covariance || is.use == FieldUse::confidence) {
    readCovariance(cursor, is);
  } else if (is.wire == Wire::text) {
    takeText(slotOf(field, is, 0), cursor.string(), is.name);
  } else {
    const std::size_t bytes = wireBytes(is.wire);
    const std::size_t count = is.count == kSequence ? cursor.count(bytes)
                              : is.parts.empty()    ? 1
                                                    : is.parts.size();
    const std::size_t taken =
        is.count == kSequence ? std::min<std::size_t>(count, kMaxElements) : count;
    for (std::size_t i = 0; i < taken && cursor.ok(); ++i) {
      const double number = readNumberOf(cursor, is.wire);
      if (is.use != FieldUse::elsewhere) takeNumber(slotOf(field, is, i), number, is);
    }
    if (count == taken) return;
    cursor.skip(count - taken, bytes);
    leaveOut(is.name, "elements beyond the 64th of an array", count - taken);
  }
}

void SignalTranslation::readCovariance(FieldCursor& cursor, const SignalField& is) {
  bool any = false;
  double first = 0;
  for (std::uint32_t i = 0; i < is.count; ++i) {
    const double number = readNumberOf(cursor, is.wire);
    if (i == 0) first = number;
    any = number != 0 || any;
  }
  if (is.use == FieldUse::confidence && first == -1) {
    values_.resize(field_begins_, {});
    leaveOut(field_before_, "which the sender does not know: its covariance begins with -1");
  } else if (any) {
    leaveOut("covariance", "packets have no covariances");
  }
}

void SignalTranslation::readLayout(FieldCursor& cursor) {
  const std::uint32_t dimensions = cursor.count(3 * sizeof(std::uint32_t));
  for (std::uint32_t i = 0; i < dimensions && cursor.ok(); ++i) {
    cursor.string();
    cursor.number<std::uint32_t>();
    cursor.number<std::uint32_t>();
  }
  const bool has_offset = cursor.number<std::uint32_t>() != 0;
  if (dimensions > 0 || has_offset) leaveOut("layout", "signals are numbered as they lie");
}

void SignalTranslation::readStatus(FieldCursor& cursor) {
  const auto level = cursor.number<std::uint8_t>();
  const std::string_view name = cursor.string();
  const std::string_view message = cursor.string();
  const std::string_view hardware = cursor.string();
  const std::uint32_t keys = cursor.count(2 * sizeof(std::uint32_t));
  if (!cursor.ok()) return;
  if (const auto slot = slotOf(name, "level", "level")) takeNumber(*slot, level, kLevel);
  if (const auto slot = slotOf(name, "message", "message")) takeText(*slot, message, "message");
  if (const auto slot = slotOf(name, "hardware_id", "hardware_id"); slot && !hardware.empty()) {
    takeText(*slot, hardware, "hardware_id");
  }
  for (std::uint32_t i = 0; i < keys && cursor.ok(); ++i) {
    const std::string_view key = cursor.string();
    const std::string_view value = cursor.string();
    if (!cursor.ok()) return;
    if (const auto slot = slotOf(name, "key " + std::string(key), key)) takeKeyValue(*slot, value);
  }
}

void SignalTranslation::takeNumber(std::size_t slot, double number, const SignalField& is) {
  if (!std::isfinite(number)) return leaveOut(is.name, kNotFinite);
  if (!is.words.empty()) {
    std::string_view word = wordOf(is.words, static_cast<std::size_t>(number));
    if (word.empty()) {
      word = digitsOf(static_cast<std::uint8_t>(number));
      sentences_.emplace_back("states that their type does not name, written as digits");
    }
    return addValue(slot, SignalKind::text, 0, word);
  }
  if (is.wire == Wire::boolean || is.use == FieldUse::boolean) {
    return addValue(slot, SignalKind::boolean, number != 0 ? 1 : 0);
  }
  const bool is_long = is.wire == Wire::i64 || is.wire == Wire::u64;
  if (is_long && std::abs(number) > kExact) {
    sentences_.emplace_back("whole numbers above 2^53, rounded");
  }
  addValue(slot, SignalKind::number, number);
}

void SignalTranslation::takeText(std::size_t slot, std::string_view text, std::string_view field) {
  // Bytes that are not UTF-8 are written as three.
  const std::size_t room = isUtf8(bytesOf(text)) ? limits::kStringBytes : limits::kStringBytes / 3;
  if (text.size() > room) return leaveOut(field, "texts that are longer than a signal's");
  addValue(slot, SignalKind::text, 0, text);
}

void SignalTranslation::takeKeyValue(std::size_t slot, std::string_view text) {
  const char* at = text.data();
  const char* const end = at + text.size();
  double number = 0;
  if (readNumber(at, end, number) && at == end) return addValue(slot, SignalKind::number, number);
  if (text == "true" || text == "True") return addValue(slot, SignalKind::boolean, 1);
  if (text == "false" || text == "False") return addValue(slot, SignalKind::boolean, 0);
  if (isNotFiniteWord(text)) return leaveOut("values", kNotFinite);
  takeText(slot, text, "values");
}

std::size_t SignalTranslation::slotOf(std::size_t field, const SignalField& is,
                                      std::size_t element) {
  std::vector<std::size_t>& slots = field_slots_[field];
  while (slots.size() <= element) {
    slots.push_back(slots_.size());
    slots_.push_back({signalName(name_, is, slots.size() - 1), is.unit});
  }
  return slots[element];
}

std::optional<std::size_t> SignalTranslation::slotOf(std::string_view status, std::string_view id,
                                                     std::string_view key) {
  auto found = statuses_.find(status);
  if (found != statuses_.end()) {
    if (const auto slot = found->second.slots.find(id); slot != found->second.slots.end()) {
      return slot->second;
    }
  }
  if (slots_.size() >= kMaxSlots || status.size() > limits::kNameBytes ||
      key.size() > limits::kNameBytes) {
    leaveOut("values", "diagnostics beyond 4096 of a topic, or with a name over 255 bytes");
    return std::nullopt;
  }
  if (found == statuses_.end()) {
    found = statuses_.emplace(std::string(status), Status{}).first;
    found->second.name = name_ + "." + status_names_.of(status);
    if (status_names_.isNumbered(status)) {
      sentences_.emplace_back("diagnostics whose names differ in no byte of a signal's, numbered");
    }
  }
  Status& its = found->second;
  const std::size_t slot = slots_.size();
  slots_.push_back({its.name + "." + its.keys.of(id, key), {}});
  if (its.keys.isNumbered(id)) {
    sentences_.emplace_back("diagnostics whose names differ in no byte of a signal's, numbered");
  }
  its.slots.emplace(std::string(id), slot);
  return slot;
}

SignalTranslation::Owner& SignalTranslation::ownerOf(std::string_view frame) {
  if (frame.size() > limits::kNameBytes) frame = {};
  if (const auto known = owners_.find(frame); known != owners_.end()) return known->second;
  if (owners_.size() >= kMaxFrames && !frame.empty()) {
    note("values of frames beyond 4096, as those of no frame");
    return ownerOf({});
  }
  Owner owner;
  owner.is_known = frame.empty();
  if (is_own_frame_ && !devices_.knowsDevices() && isName(frame)) {
    owner.device = frame;
    owner.is_known = true;
  } else if (auto link = frames_.ownerOf(frame)) {
    owner.device = std::move(link->device);
    owner.link = std::move(link->link);
    owner.is_known = true;
  } else if (const auto device = devices_.deviceOfTopic(topic_)) {
    owner.device = *device;
  } else if (isName(devices_.fallback())) {
    owner.device = devices_.fallback();
  }
  unknown_frames_ += owner.is_known ? 0 : 1;
  return owners_.emplace(std::string(frame), std::move(owner)).first->second;
}

void SignalTranslation::addSignals() {
  Owner& owner = ownerOf(frame_);
  if (!owner.is_known && unknown_frames_ > 1) {
    note("values of several frames that are no link, as one signal");
  }
  owner.unit_stated.resize(slots_.size());
  names_.clear();
  numbers_.clear();
  kinds_.clear();
  for (const Value& value : values_) {
    const Slot& slot = slots_[value.slot];
    const std::string_view name = slot.name;
    const bool is_first = !slot.unit.empty() && !owner.unit_stated[value.slot];
    const bool states_unit = value.kind == SignalKind::number && (stated_ || is_first);
    if (value.kind != SignalKind::text && !states_unit) {
      names_.push_back(name);
      numbers_.push_back(value.number);
      kinds_.push_back(value.kind);
      if (names_.size() == limits::kSignalValues) addShort(owner);
      continue;
    }
    if (states_unit) owner.unit_stated[value.slot] = true;
    Statement statement;
    statement.kind = StatementKind::signal;
    statement.path = {owner.device, owner.link, false};
    statement.names = std::span(&name, 1);
    statement.numbers = std::span(&value.number, 1);
    statement.signal_kinds = std::span(&value.kind, 1);
    statement.text = value.text;
    if (states_unit) statement.unit = slot.unit;
    add(statement);
  }
  addShort(owner);
}

void SignalTranslation::addShort(const Owner& owner) {
  if (names_.empty()) return;
  Statement statement;
  statement.kind = StatementKind::signals;
  statement.path = {owner.device, owner.link, false};
  statement.names = names_;
  statement.numbers = numbers_;
  statement.signal_kinds = kinds_;
  add(statement);
  names_.clear();
  numbers_.clear();
  kinds_.clear();
}

}  // namespace rocinante::ros
