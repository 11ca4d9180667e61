#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/parallel_for.h"
#include "core/base/time.h"
#include "core/cell/cell.h"
#include "core/search/search_facts.h"

namespace rocinante {

/// Everything that a cell was made of: what must be as it was for a load to give the same cell,
/// with the same pictures.
struct CellInputs {
  struct File {
    std::filesystem::path path;
    std::uint64_t bytes = 0;
    std::uint64_t hash[2] = {};  ///< XXH3-128 of the XXH3-128s of its pieces of 1 MiB
  };
  /// A shared library of the process: a decoder may be in it. By its size and time, as packages
  /// replace whole files.
  struct Library {
    std::string path;
    std::uint64_t bytes = 0;
    std::int64_t changed_ns = 0;
  };
  std::vector<File> files;
  std::vector<std::pair<std::filesystem::path, SearchFacts::Answer>> answers;
  std::vector<Library> libraries;

  std::uint64_t fileBytes() const;
};

/// After the cell was loaded and its pictures decoded, the search having noted `facts`. Empty when
/// that cannot be told: a file changed within two seconds before `begun`, or later, and so perhaps
/// after it was read; a folder was listed; a file of a format whose library reads further files.
std::optional<CellInputs> inputsOf(const Cell& cell, const SearchFacts& facts, WallTime begun);

/// Whether everything is as it was: reads all files.
bool areUnchanged(const CellInputs& inputs, const ParallelFor& parallel);

Bytes encodeInputs(const CellInputs& inputs);
/// Empty for bytes that encodeInputs() did not write.
std::optional<CellInputs> decodeInputs(ByteView bytes);

}  // namespace rocinante
