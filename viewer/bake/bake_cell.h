#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/bundle/baked_file.h"
#include "core/cell/cell.h"

namespace rocinante {

struct BakeOptions {
  BakedKey key{};  ///< names what the cell was made of
  /// Decodes the cell's pictures now, so that drawing opens no file; those that cannot be decoded
  /// are read when they are drawn, as without.
  bool pictures = true;
  bool compressed = false;  ///< pictures as compressed PNGs: a fifth to a third, and slow to decode
  /// Pictures are halved until no side has more pixels; 0: they stay as they are.
  int largest_side = 0;
  ParallelFor parallel;  ///< decodes pictures on several threads; may be empty
  /// What a path is written as, different paths differently; empty: itself. Once the cell is baked
  /// paths only name pictures.
  std::function<std::string(const std::filesystem::path&)> path_text{};
};

/// Section ids from here on are the caller's own.
inline constexpr std::uint32_t kFirstForeignSection = 0x100;

/// Further sections by id.
using MoreSections = std::function<std::vector<std::pair<std::uint32_t, Bytes>>()>;

/// A cell in one flat file: kinematics as doubles, meshes as they go to the GPU, shared values
/// once, pictures as PNG (docs/baked-cell.md). `more` is asked for further sections once the
/// pictures are decoded. The same cell gives the same bytes, on any number of threads. What keeps
/// the files of a cell from a log is not baked.
Bytes bakeCell(const Cell& cell, const BakeOptions& options, const MoreSections& more = {});

/// Reads what bakeCell() wrote. Every field equals that of the cell that was baked; values that it
/// shared are shared. `keeps` owns the file's bytes: the cell's pictures are views into them.
/// damaged when anything breaks the rules that readers of models keep: indices, trees, finite
/// numbers. Trusts nothing, so that nothing in the file can harm a renderer.
Result<Cell> readBakedCell(const BakedFile& file, std::shared_ptr<const void> keeps);

}  // namespace rocinante
