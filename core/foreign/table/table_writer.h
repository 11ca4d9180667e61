#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/base/time.h"
#include "core/mcap/byte_sink.h"

namespace rocinante {

/// Receives a table row by row: begin() once, row() in order of time, end() once. NaN: no value.
class TableWriter {
 public:
  virtual ~TableWriter() = default;
  virtual Status begin(std::span<const std::string> columns) = 0;
  /// `time` is since the session's origin; `values` are as many as columns.
  virtual Status row(Nanoseconds time, std::span<const double> values) = 0;
  virtual Status end() = 0;
};

/// Appends bytes to an output, all or fails.
using AppendBytes = std::function<Status(ByteView)>;

/// Comma-separated values (RFC 4180, LF): a header `t,COLUMN...`; seconds with as many decimals as
/// the nanoseconds need, and the shortest decimals that read back as the same doubles. NaN is an
/// empty field. The form that `source --csv` reads (docs/programs/source.md).
std::unique_ptr<TableWriter> makeCsvTable(AppendBytes out);

/// A NumPy file (NEP 1, version 1.0, or 2.0 for a long header) with one structured array: fields
/// `t` (float64, seconds), `t_ns` (int64, nanoseconds, exact) and one float64 for each column, all
/// little-endian and packed. Memory is one block of rows. The sink must be overwritable; the caller
/// closes it.
std::unique_ptr<TableWriter> makeNpyTable(ByteSink& out);

/// A NumPy archive: an uncompressed ZIP (with ZIP64 where needed) with one array for each column,
/// `t` and `t_ns` first. Rows are kept in an unnamed file in `folder` until end(), since columns
/// can only be written one after the other: the disk holds the table twice for that long. Memory is
/// one block of rows.
std::unique_ptr<TableWriter> makeNpzTable(ByteSink& out, std::string folder);

}  // namespace rocinante
