#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/packet/item_text.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// The signals of a table, and where its rows change them.
class CsvSignals {
 public:
  struct Column {
    NamedSignal signal;
    std::size_t column = 0;  ///< of the table, from 0
  };

  /// Why the column is none; empty: it is one.
  std::string_view add(NamedSignal signal, std::size_t column);
  /// In the order in which they were added.
  const std::vector<Column>& columns() const { return columns_; }

  /// What a row says of the signal at `index` into columns(), row after row. False for a text that
  /// no packet can have.
  bool say(std::size_t row, std::size_t index, SignalValue value);

  struct Change {
    std::size_t row = 0;
    std::size_t index = 0;  ///< into columns()
    SignalValue value;
    bool is_first = false;  ///< of this signal
  };
  /// All of them, by row.
  const std::vector<Change>& changes() const { return changes_; }
  std::span<const Change> of(std::size_t row) const;
  /// Whether the row changes anything in a turn that follows the last row.
  bool changesAgain(std::size_t row) const;

 private:
  std::vector<Column> columns_;
  std::vector<std::optional<SignalValue>> latest_;  ///< as many
  std::vector<Change> changes_;
};

}  // namespace rocinante
