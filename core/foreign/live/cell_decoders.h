#pragma once

#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/cell/cell.h"
#include "core/foreign/decode/decoder_set.h"

namespace rocinante {

/// The decoders of a live edge: those of `file` (--decoders), else those that the cell names; null
/// when there are neither.
inline Result<std::shared_ptr<const decode::DecoderSet>> decodersFor(const std::string& file,
                                                                     const Cell& cell) {
  if (!file.empty()) return decode::readDecoders(file);
  if (cell.decoders.empty()) return std::shared_ptr<const decode::DecoderSet>();
  auto set = decode::readDecoders(cell.decoders);
  if (set) return set;
  // A cell from a log lies in a folder that users do not know.
  Error error = set.error();
  error.what = cell.shown(std::move(error.what));
  error.where = cell.shown(std::move(error.where));
  return error;
}

}  // namespace rocinante
