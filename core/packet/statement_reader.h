#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/packet/packet.h"
#include "core/packet/text_lines.h"
#include "core/packet/text_name.h"

namespace rocinante {

/// Collects the statements of one datagram. Spans into `numbers` and `names` stay valid because
/// begin() reserves for the worst case of the datagram.
struct StatementScratch {
  std::vector<Statement> statements;
  std::vector<FaultAt> faults;
  std::vector<double> numbers;
  std::vector<std::string_view> names;
  std::vector<SignalKind> kinds;
  TextArena arena;

  void begin(std::size_t datagram_bytes);
};

/// Reads statement lines (docs/packet-format.md, section "Statements") into the scratch.
class StatementReader {
 public:
  explicit StatementReader(StatementScratch& scratch) : scratch_(scratch) {}

  /// Reads a line that is neither blank nor a comment: a statement, a fault, or both.
  void read(std::string_view line, std::uint32_t number);

 private:
  using Reader = bool (StatementReader::*)();
  struct Row {
    std::string_view word;
    StatementKind kind;
    Reader reader;
  };
  static const Row kTable[];
  static const Row* findRow(std::string_view word);

  bool readJoints();
  bool readOrder();
  bool readJoint();
  bool readPose();
  bool readAdd();
  bool readRemove();
  bool readShow();
  bool readHide();
  bool readColor();
  bool readLine();
  bool readPoints();
  bool readLabel();
  bool readErase();
  bool readEvent();
  bool readView();
  bool readSignal();
  bool readSignals();
  bool readSeen();

  bool readDrawing(std::string_view size_word);

  // Each takes the next field, or sets fault_.
  bool takeName(std::string_view& name);
  /// NAME= of a joint's or signal's value, up to the value.
  bool takeNameOfValue();
  bool takeDrawingId();
  bool takePath(PathView& path, bool with_layers);
  bool takeSignalPath();
  /// The value of a signal at the reader's place, in the middle of a field.
  bool takeSignalValue(bool with_text);
  bool takeUnit();
  bool takeCarrier();
  bool takeColor();
  bool takeText();
  bool takeNumber(double& number);
  bool takeNumbers(std::size_t count);
  bool takeNumbersToEnd();
  bool takePositive(std::string_view text, std::optional<double>& number);
  bool takeEnd();

  bool fail(PacketFault fault, const char* place);
  /// missing_field at the end of the line, else `fault` at the next field.
  bool failHere(PacketFault fault);
  void normaliseQuaternion(double* xyzw, const char* place);

  StatementScratch& scratch_;
  TextFields fields_{{}};
  std::uint32_t number_ = 0;
  Statement* statement_ = nullptr;  ///< the one being read, at the back of the scratch's
  FaultAt fault_{};
};

}  // namespace rocinante
