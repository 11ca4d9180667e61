#include "core/packet/statement_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/math/transform.h"
#include "core/packet/packet_limits.h"
#include "core/packet/text_number.h"

namespace rocinante {
namespace {

// A quaternion this close to unit length is left unchanged, so that a restated one is the same to
// the last bit.
constexpr double kUnitTolerance = 1e-12;

}  // namespace

const StatementReader::Row StatementReader::kTable[] = {
    {"joints", StatementKind::joints, &StatementReader::readJoints},
    {"joint", StatementKind::joint, &StatementReader::readJoint},
    {"pose", StatementKind::pose, &StatementReader::readPose},
    {"signals", StatementKind::signals, &StatementReader::readSignals},
    {"signal", StatementKind::signal, &StatementReader::readSignal},
    {"order", StatementKind::order, &StatementReader::readOrder},
    {"line", StatementKind::line, &StatementReader::readLine},
    {"points", StatementKind::points, &StatementReader::readPoints},
    {"label", StatementKind::label, &StatementReader::readLabel},
    {"erase", StatementKind::erase, &StatementReader::readErase},
    {"event", StatementKind::event, &StatementReader::readEvent},
    {"add", StatementKind::add, &StatementReader::readAdd},
    {"remove", StatementKind::remove, &StatementReader::readRemove},
    {"show", StatementKind::show, &StatementReader::readShow},
    {"hide", StatementKind::hide, &StatementReader::readHide},
    {"color", StatementKind::color, &StatementReader::readColor},
    {"view", StatementKind::view, &StatementReader::readView},
    {"seen", StatementKind::seen, &StatementReader::readSeen},
};

void StatementScratch::begin(std::size_t datagram_bytes) {
  statements.clear();
  faults.clear();
  numbers.clear();
  names.clear();
  kinds.clear();
  // Every number and every name takes at least one byte and a separator.
  const std::size_t most_fields = datagram_bytes / 2 + 1;
  if (numbers.capacity() < most_fields) numbers.reserve(most_fields);
  if (names.capacity() < most_fields) names.reserve(most_fields);
  if (kinds.capacity() < most_fields) kinds.reserve(most_fields);
  arena.begin(datagram_bytes);
}

const StatementReader::Row* StatementReader::findRow(std::string_view word) {
  for (const Row& row : kTable) {
    if (row.word == word) return &row;
  }
  return nullptr;
}

void StatementReader::read(std::string_view line, std::uint32_t number) {
  fields_ = TextFields(line);
  number_ = number;
  const std::string_view word = fields_.take();
  const Row* const row = findRow(word);
  if (row == nullptr) {
    fail(PacketFault::unknown_statement, word.data());
    scratch_.faults.push_back(fault_);
    return;
  }
  statement_ = &scratch_.statements.emplace_back();
  statement_->kind = row->kind;
  statement_->line = number;
  const std::size_t faults_before = scratch_.faults.size();
  const std::size_t numbers_before = scratch_.numbers.size();
  const std::size_t names_before = scratch_.names.size();
  const std::size_t kinds_before = scratch_.kinds.size();
  if ((this->*row->reader)() && takeEnd()) {
    statement_->numbers = std::span(scratch_.numbers).subspan(numbers_before);
    statement_->names = std::span(scratch_.names).subspan(names_before);
    statement_->signal_kinds = std::span(scratch_.kinds).subspan(kinds_before);
  } else {
    // Only this line is discarded, with the values it has added so far.
    scratch_.statements.pop_back();
    scratch_.numbers.resize(numbers_before);
    scratch_.names.resize(names_before);
    scratch_.kinds.resize(kinds_before);
    scratch_.faults.resize(faults_before);
    scratch_.faults.push_back(fault_);
  }
}

bool StatementReader::readJoints() {
  if (!takeName(statement_->name)) return false;
  const char* const place = fields_.peek().data();
  if (std::string_view hex; fields_.takeAfter("@", hex)) {
    const auto tag = readHex(hex, 8);
    if (!tag) return fail(PacketFault::bad_number, place);
    statement_->order_tag = static_cast<std::uint32_t>(*tag);
  }
  return takeNumbersToEnd();
}

bool StatementReader::readOrder() {
  if (!takeName(statement_->name)) return false;
  for (std::size_t count = 0; !fields_.atEnd(); ++count) {
    if (count == limits::kJointValues) return failHere(PacketFault::too_many);
    std::string_view joint;
    if (!takeName(joint)) return false;
    scratch_.names.push_back(joint);
  }
  return true;
}

bool StatementReader::readJoint() {
  if (!takeName(statement_->name)) return false;
  std::size_t count = 0;
  do {
    if (count++ == limits::kJointValues) return failHere(PacketFault::too_many);
    if (!takeNameOfValue()) return false;
    double value = 0;
    const char* const place = fields_.at();
    if (!readNumber(fields_.at(), fields_.end(), value) || !fields_.atSeparator()) {
      return fail(PacketFault::bad_number, place);
    }
    scratch_.numbers.push_back(value);
  } while (!fields_.atEnd());
  return true;
}

bool StatementReader::readPose() {
  if (!takeName(statement_->name) || !takeNumbers(3)) return false;
  fields_.atEnd();
  const char* const place = fields_.at();
  if (!takeNumbers(4)) return false;
  double* const xyzw = scratch_.numbers.data() + scratch_.numbers.size() - 4;
  if (xyzw[0] == 0 && xyzw[1] == 0 && xyzw[2] == 0 && xyzw[3] == 0) {
    return fail(PacketFault::zero_quaternion, place);
  }
  if (fields_.peek() == "in" && !takeCarrier()) return false;
  normaliseQuaternion(xyzw, place);
  return true;
}

bool StatementReader::readAdd() {
  if (!takeName(statement_->name) || !takeName(statement_->text)) return false;
  const char* const place = fields_.peek().data();
  std::string_view hex;
  if (!fields_.takeAfter("kin=", hex)) return true;
  statement_->kinematics = readHex(hex, 16);
  return statement_->kinematics || fail(PacketFault::bad_number, place);
}

bool StatementReader::readRemove() { return takeName(statement_->name); }

bool StatementReader::readShow() {
  if (!takePath(statement_->path, true)) return false;
  statement_->is_default = fields_.takeWord("default");
  return true;
}

bool StatementReader::readHide() { return takePath(statement_->path, true); }

bool StatementReader::readColor() {
  if (!takePath(statement_->path, true)) return false;
  statement_->is_default = fields_.takeWord("default");
  return statement_->is_default || takeColor();
}

bool StatementReader::readLine() { return readDrawing("width="); }

bool StatementReader::readPoints() { return readDrawing("size="); }

bool StatementReader::readDrawing(std::string_view size_word) {
  if (!takeDrawingId() || !takeColor()) return false;
  for (;;) {
    std::string_view size;
    const std::string_view field = fields_.peek();
    if (field == "in" && statement_->carrier.first.empty()) {
      if (!takeCarrier()) return false;
    } else if (!statement_->size_px && fields_.takeAfter(size_word, size)) {
      if (!takePositive(size, statement_->size_px)) return false;
    } else {
      break;
    }
  }
  const std::size_t before = scratch_.numbers.size();
  if (!takeNumbersToEnd()) return false;
  if ((scratch_.numbers.size() - before) % 3 == 0) return true;
  return fail(PacketFault::missing_field, fields_.end());
}

bool StatementReader::readLabel() {
  if (!takeName(statement_->name)) return false;
  if (fields_.peek() == "in" && !takeCarrier()) return false;
  return takeNumbers(3) && takeText();
}

bool StatementReader::readErase() { return fields_.takeWord("*") || takeName(statement_->name); }

bool StatementReader::readEvent() { return takeText(); }

bool StatementReader::readView() {
  if (!takeName(statement_->name) || !takeNumbers(6)) return false;
  fields_.atEnd();
  const char* place = fields_.at();
  if (!takeNumbers(1)) return false;
  const double fov_deg = scratch_.numbers.back();
  if (!(fov_deg > 0 && fov_deg < 180)) return fail(PacketFault::bad_number, place);
  const double* const eye = scratch_.numbers.data() + scratch_.numbers.size() - 7;
  if (std::equal(eye, eye + 3, eye + 3)) return fail(PacketFault::bad_number, place);
  bool has_up = false;
  for (;;) {
    const std::string_view field = fields_.peek();
    place = field.data();
    if (field == "in" && statement_->carrier.first.empty()) {
      if (!takeCarrier()) return false;
    } else if (!has_up && fields_.takeWord("up")) {
      has_up = true;
      if (!takeNumbers(3)) return false;
      const double* const up = scratch_.numbers.data() + scratch_.numbers.size() - 3;
      if (up[0] == 0 && up[1] == 0 && up[2] == 0) return fail(PacketFault::bad_number, place);
    } else if (!statement_->ortho_height_m && fields_.takeWord("ortho")) {
      if (fields_.atEnd()) return failHere(PacketFault::missing_field);
      if (!takePositive(fields_.take(), statement_->ortho_height_m)) return false;
    } else {
      break;
    }
  }
  if (!has_up) scratch_.numbers.insert(scratch_.numbers.end(), {0.0, 0.0, 1.0});
  return true;
}

bool StatementReader::readSeen() {
  if (!takeName(statement_->name)) return false;
  const auto nanoseconds = readUnsigned(fields_.peek());
  if (!nanoseconds || *nanoseconds > std::uint64_t{INT64_MAX}) {
    return failHere(PacketFault::bad_number);
  }
  fields_.take();
  statement_->seen_ns = static_cast<std::int64_t>(*nanoseconds);
  return true;
}

bool StatementReader::takeName(std::string_view& name) {
  const std::string_view field = fields_.peek();
  const auto decoded = decodeName(field, scratch_.arena);
  if (!decoded) return failHere(PacketFault::bad_name);
  fields_.skip(field);
  name = *decoded;
  return true;
}

// ID or ID:I/N. A name cannot contain a slash, so a slash tells the two apart.
bool StatementReader::takeDrawingId() {
  const std::string_view field = fields_.peek();
  const std::size_t slash = field.find('/');
  if (slash == std::string_view::npos) return takeName(statement_->name);
  const std::string_view before = field.substr(0, slash);
  const std::size_t colon = before.rfind(':');
  if (colon == std::string_view::npos) return failHere(PacketFault::bad_name);
  const auto id = decodeName(before.substr(0, colon), scratch_.arena);
  const auto index = readUnsigned(before.substr(colon + 1));
  const auto count = readUnsigned(field.substr(slash + 1));
  if (!id || !index || !count || *index == 0 || *index > *count) {
    return failHere(PacketFault::bad_name);
  }
  if (*count > limits::kDrawingParts) return failHere(PacketFault::too_many);
  fields_.take();
  statement_->name = *id;
  statement_->part_index = static_cast<std::uint32_t>(*index);
  statement_->part_count = static_cast<std::uint32_t>(*count);
  return true;
}

bool StatementReader::takePath(PathView& path, bool with_layers) {
  const std::string_view field = fields_.peek();
  const std::size_t slash = field.find('/');
  const std::string_view first = field.substr(0, slash);
  const auto device = decodeName(first, scratch_.arena);
  if (!device) return failHere(PacketFault::bad_path);
  path.first = *device;
  if (slash != std::string_view::npos) {
    const auto second = decodeName(field.substr(slash + 1), scratch_.arena);
    if (!second) return failHere(PacketFault::bad_path);
    path.second = *second;
    // Checked before decoding: a device of that name is written as %6Cayer here.
    path.is_layer = with_layers && first == "layer";
  }
  fields_.take();
  return true;
}

bool StatementReader::takeCarrier() {
  fields_.take();
  const char* const place = fields_.peek().data();
  if (!takePath(statement_->carrier, false)) return false;
  return !statement_->carrier.second.empty() || fail(PacketFault::bad_path, place);
}

bool StatementReader::takeColor() {
  const std::string_view field = fields_.peek();
  const bool with_alpha = field.size() == 9;
  if (field.empty() || field[0] != '#') return failHere(PacketFault::bad_color);
  const auto rgba = readHex(field.substr(1), with_alpha ? 8 : 6);
  if (!rgba) return failHere(PacketFault::bad_color);
  fields_.take();
  statement_->rgba = static_cast<std::uint32_t>(with_alpha ? *rgba : *rgba << 8U | 0xFFU);
  return true;
}

bool StatementReader::takeText() {
  if (fields_.atEnd()) return failHere(PacketFault::missing_field);
  const char* const place = fields_.at();
  const auto text = decodeString(fields_.at(), fields_.end(), scratch_.arena);
  if (!text || !fields_.atSeparator()) return fail(PacketFault::bad_string, place);
  statement_->text = *text;
  return true;
}

bool StatementReader::takeNumber(double& number) {
  if (fields_.atEnd()) return failHere(PacketFault::missing_field);
  const char* const place = fields_.at();
  if (!readNumber(fields_.at(), fields_.end(), number) || !fields_.atSeparator()) {
    return fail(PacketFault::bad_number, place);
  }
  return true;
}

bool StatementReader::takeNumbers(std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    double number = 0;
    if (!takeNumber(number)) return false;
    scratch_.numbers.push_back(number);
  }
  return true;
}

bool StatementReader::takeNumbersToEnd() {
  const bool bounded = statement_->kind == StatementKind::joints;
  std::size_t count = 0;
  do {
    double number = 0;
    if (bounded && count++ == limits::kJointValues) return failHere(PacketFault::too_many);
    if (!takeNumber(number)) return false;
    scratch_.numbers.push_back(number);
  } while (!fields_.atEnd());
  return true;
}

bool StatementReader::takePositive(std::string_view text, std::optional<double>& number) {
  const char* at = text.data();
  const char* const end = at + text.size();
  double value = 0;
  if (!readNumber(at, end, value) || at != end || !(value > 0)) {
    return fail(PacketFault::bad_number, text.data());
  }
  number = value;
  return true;
}

bool StatementReader::takeEnd() {
  return fields_.atEnd() || fail(PacketFault::extra_field, fields_.at());
}

bool StatementReader::fail(PacketFault fault, const char* place) {
  fault_ = {fault, number_, fields_.columnOf(place)};
  return false;
}

bool StatementReader::failHere(PacketFault fault) {
  return fail(fields_.atEnd() ? PacketFault::missing_field : fault, fields_.at());
}

void StatementReader::normaliseQuaternion(double* xyzw, const char* place) {
  // Scaled by the largest part, so that squares neither overflow nor vanish.
  double largest = 0;
  for (int i = 0; i < 4; ++i) largest = std::max(largest, std::abs(xyzw[i]));
  double squared = 0;
  for (int i = 0; i < 4; ++i) squared += (xyzw[i] / largest) * (xyzw[i] / largest);
  const double norm = largest * std::sqrt(squared);
  if (std::abs(norm - 1) > kUnitLengthTolerance) {
    fail(PacketFault::unnormalised_quaternion, place);
    scratch_.faults.push_back(fault_);
  }
  if (std::abs(norm - 1) <= kUnitTolerance) return;
  const double scaled_norm = std::sqrt(squared);
  for (int i = 0; i < 4; ++i) xyzw[i] = xyzw[i] / largest / scaled_norm + 0.0;  // -0 to 0
}

}  // namespace rocinante
