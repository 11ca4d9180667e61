#include "core/packet/packet_limits.h"
#include "core/packet/packet_text.h"
#include "core/packet/statement_reader.h"
#include "core/packet/text_number.h"

namespace rocinante {

bool StatementReader::takeNameOfValue() {
  const std::string_view field = fields_.peek();
  const std::size_t equals = field.find('=');
  if (equals == std::string_view::npos) return failHere(PacketFault::bad_name);
  const auto name = decodeName(field.substr(0, equals), scratch_.arena);
  if (!name) return failHere(PacketFault::bad_name);
  scratch_.names.push_back(*name);
  fields_.at() += equals + 1;
  return true;
}

bool StatementReader::readSignal() {
  if (!takeSignalPath()) return false;
  std::string_view name;
  if (!takeName(name)) return false;
  scratch_.names.push_back(name);
  if (fields_.takeWord("default")) {
    statement_->is_default = true;
    return true;
  }
  if (fields_.atEnd()) return failHere(PacketFault::missing_field);
  if (!takeSignalValue(true)) return false;
  const bool is_number = scratch_.kinds.back() == SignalKind::number;
  return !is_number || fields_.atEnd() || takeUnit();
}

bool StatementReader::readSignals() {
  if (!takeSignalPath()) return false;
  std::size_t count = 0;
  do {
    if (count++ == limits::kSignalValues) return failHere(PacketFault::too_many);
    if (!takeNameOfValue() || !takeSignalValue(false)) return false;
  } while (!fields_.atEnd());
  return true;
}

bool StatementReader::takeSignalPath() {
  const char* const place = fields_.peek().data();
  // A device of that name is written as %2D.
  if (fields_.takeWord("-")) return true;
  if (!takePath(statement_->path, true)) return false;
  return !statement_->path.is_layer || fail(PacketFault::bad_path, place);
}

bool StatementReader::takeSignalValue(bool with_text) {
  const char* const place = fields_.at();
  const char first = place == fields_.end() ? ' ' : *place;
  double number = 0;
  SignalKind kind = SignalKind::number;
  if (with_text && first == '"') {
    kind = SignalKind::text;
    if (!takeText()) return false;
  } else if (first == 't' || first == 'f') {
    kind = SignalKind::boolean;
    const std::string_view word = fields_.take();
    if (word != "true" && word != "false") return fail(PacketFault::bad_number, place);
    number = word == "true" ? 1 : 0;
  } else if (!readNumber(fields_.at(), fields_.end(), number) || !fields_.atSeparator()) {
    return fail(PacketFault::bad_number, place);
  }
  scratch_.numbers.push_back(number);
  scratch_.kinds.push_back(kind);
  return true;
}

bool StatementReader::takeUnit() {
  if (!isUnit(fields_.peek())) return failHere(PacketFault::bad_string);
  statement_->unit = fields_.take();
  return true;
}

}  // namespace rocinante
