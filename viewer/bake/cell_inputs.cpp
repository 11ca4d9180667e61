#include "viewer/bake/cell_inputs.h"

#include <fcntl.h>
#include <link.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <set>
#include <span>

#include "core/base/hash.h"
#include "viewer/bake/cell_fields.h"
#include "viewer/bake/field_reader.h"
#include "viewer/bake/field_writer.h"

namespace rocinante {

inline std::uint8_t enumeratorCount(SearchFacts::Kind) { return 4; }

template <class Fields>
void fields(Fields& io, Taken<Fields, SearchFacts::Answer>& answer) {
  auto& [kind, canonical] = answer;
  io(kind, canonical);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, CellInputs::File>& file) {
  auto& [path, bytes, hash] = file;
  io(path, bytes, hash[0], hash[1]);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, CellInputs::Library>& library) {
  auto& [path, bytes, changed_ns] = library;
  io(path, bytes, changed_ns);
}

template <class Fields>
void fields(Fields& io, Taken<Fields, CellInputs>& inputs) {
  auto& [files, answers, libraries] = inputs;
  io(files, answers, libraries);
}

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kPiece = std::size_t{1} << 20;
/// Clocks of file systems are coarse, and those of others' machines not ours.
constexpr std::int64_t kDoubtNs = 2'000'000'000;

std::int64_t nanosecondsOfTime(const timespec& time) {
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

struct HashedFile {
  CellInputs::File file;
  std::int64_t changed_ns = 0;  ///< also when only its name or owner did
};

std::optional<HashedFile> hashedFile(const fs::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return std::nullopt;
  HashedFile hashed{{path}, 0};
  Bytes piece(kPiece);
  Bytes digests;
  while (true) {
    std::size_t size = 0;
    ssize_t got = 1;
    while (size < piece.size() && got > 0) {
      got = ::read(file, piece.data() + size, piece.size() - size);
      if (got < 0 && errno == EINTR)
        got = 1;
      else if (got > 0)
        size += static_cast<std::size_t>(got);
    }
    if (got < 0) {
      ::close(file);
      return std::nullopt;
    }
    const auto digest = xxh3(ByteView(piece).first(size));
    digests.insert(digests.end(), digest.begin(), digest.end());
    hashed.file.bytes += size;
    if (size < piece.size()) break;
  }
  struct stat facts {};
  const bool known = ::fstat(file, &facts) == 0 && S_ISREG(facts.st_mode);
  ::close(file);
  if (!known) return std::nullopt;
  hashed.changed_ns = std::max(nanosecondsOfTime(facts.st_mtim), nanosecondsOfTime(facts.st_ctim));
  const auto whole = xxh3(digests);
  std::memcpy(hashed.file.hash, whole.data(), whole.size());
  return hashed;
}

std::optional<CellInputs::Library> libraryAt(const std::string& path) {
  struct stat facts {};
  if (::stat(path.c_str(), &facts) != 0) return std::nullopt;
  return CellInputs::Library{path, static_cast<std::uint64_t>(facts.st_size),
                             nanosecondsOfTime(facts.st_mtim)};
}

/// Of this process, but for the program itself: its code is in the key (cell_cache.h).
std::vector<CellInputs::Library> loadedLibraries() {
  std::vector<CellInputs::Library> libraries;
  ::dl_iterate_phdr(
      [](dl_phdr_info* info, std::size_t, void* data) {
        // The program has no name, and the kernel's library no file.
        const std::string path = info->dlpi_name == nullptr ? "" : info->dlpi_name;
        if (path.find('/') == std::string::npos) return 0;
        if (auto library = libraryAt(path)) {
          static_cast<std::vector<CellInputs::Library>*>(data)->push_back(std::move(*library));
        }
        return 0;
      },
      &libraries);
  return libraries;
}

}  // namespace

std::uint64_t CellInputs::fileBytes() const {
  std::uint64_t total = 0;
  for (const File& file : files) total += file.bytes;
  return total;
}

std::optional<CellInputs> inputsOf(const Cell& cell, const SearchFacts& facts, WallTime begun) {
  if (!facts.complete()) return std::nullopt;
  std::set<fs::path> paths(cell.files.begin(), cell.files.end());
  paths.insert(facts.contents().begin(), facts.contents().end());
  CellInputs inputs;
  for (const fs::path& path : paths) {
    if (path.extension() == ".sdf" || path.extension() == ".SDF") return std::nullopt;
    const auto hashed = hashedFile(path);
    if (!hashed) return std::nullopt;
    if (hashed->changed_ns > begun.time_since_epoch().count() - kDoubtNs) return std::nullopt;
    inputs.files.push_back(hashed->file);
    inputs.answers.emplace_back(path, SearchFacts::answerFor(path));
  }
  for (const auto& answer : facts.answers()) {
    if (!paths.contains(answer.first)) inputs.answers.push_back(answer);
  }
  inputs.libraries = loadedLibraries();
  return inputs;
}

bool areUnchanged(const CellInputs& inputs, const ParallelFor& parallel) {
  for (const CellInputs::Library& library : inputs.libraries) {
    const auto now = libraryAt(library.path);
    if (!now || now->bytes != library.bytes || now->changed_ns != library.changed_ns) return false;
  }
  for (const auto& [path, answer] : inputs.answers) {
    if (SearchFacts::answerFor(path) != answer) return false;
  }
  std::atomic<bool> same = true;
  const auto compare = [&](std::size_t i) {
    if (!same) return;
    const CellInputs::File& file = inputs.files[i];
    const auto now = hashedFile(file.path);
    if (!now || now->file.bytes != file.bytes || !std::ranges::equal(now->file.hash, file.hash)) {
      same = false;
    }
  };
  forEachIndex(parallel, inputs.files.size(), compare);
  return same;
}

Bytes encodeInputs(const CellInputs& inputs) {
  BakedSharing none;
  FieldWriter writer(none);
  writer(inputs);
  return writer.take();
}

std::optional<CellInputs> decodeInputs(ByteView bytes) {
  const ReadSharing none;
  FieldReader reader(bytes, none);
  CellInputs inputs;
  reader(inputs);
  if (!reader.finished()) return std::nullopt;
  return inputs;
}

}  // namespace rocinante
