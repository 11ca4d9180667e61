#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/packet/item_text.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// The signals of a table, and where its rows change them.
class CsvSignals {
 public:
  CsvSignals() = default;
  CsvSignals(CsvSignals&&) = default;
  CsvSignals& operator=(CsvSignals&&) = default;

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
  bool say(std::size_t row, std::size_t index, const SignalValue& value);

  /// Small, as a table has millions.
  struct Change {
    std::size_t row = 0;
    double number = 0;        ///< of a boolean 1 or 0
    std::uint32_t index = 0;  ///< into columns()
    std::uint32_t text = 0;   ///< of a text, for textOf()
    SignalKind kind{};
    bool is_first = false;  ///< of this signal
  };
  const std::string& textOf(const Change& change) const { return *texts_[change.text]; }
  /// All of them, by row.
  const std::vector<Change>& changes() const { return changes_; }
  std::span<const Change> of(std::size_t row) const;
  /// Whether the row changes anything in a turn that follows the last row.
  bool changesAgain(std::size_t row) const;

 private:
  std::vector<Column> columns_;
  std::set<std::string> names_;                ///< of the columns
  std::vector<std::optional<Change>> latest_;  ///< by column
  std::vector<Change> changes_;
  std::map<std::string, std::uint32_t> text_places_;  ///< each text once
  std::vector<const std::string*> texts_;             ///< the keys of that
};

}  // namespace rocinante
