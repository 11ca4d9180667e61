#include "core/foreign/table/row_spill.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace rocinante {
namespace {

constexpr std::size_t kBlockBytes = std::size_t{16} << 20;

/// A file without a name, which is gone when it is closed; -1 with errno.
int unnamedFile(const std::string& folder) {
  const int file = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (file >= 0) return file;
  // Some file systems have no O_TMPFILE.
  std::string path = folder + "/.rocinante-XXXXXX";
  const int named = ::mkostemp(path.data(), O_CLOEXEC);
  if (named >= 0) ::unlink(path.c_str());
  return named;
}

}  // namespace

Result<RowSpill> RowSpill::make(const std::string& folder, std::size_t columns) {
  const int file = unnamedFile(folder);
  if (file < 0) {
    return Error{ErrorKind::unreadable,
                 std::string("cannot make a temporary file: ") + std::strerror(errno), folder};
  }
  return RowSpill(file, folder, columns);
}

RowSpill::RowSpill(int file, std::string folder, std::size_t columns)
    : file_(file),
      folder_(std::move(folder)),
      columns_(columns),
      block_rows_(std::clamp<std::size_t>(kBlockBytes / (columns * 8), 16, 65536)),
      block_(block_rows_ * columns) {}

RowSpill::~RowSpill() {
  if (file_ >= 0) ::close(file_);
}

RowSpill::RowSpill(RowSpill&& other) noexcept
    : file_(std::exchange(other.file_, -1)),
      folder_(std::move(other.folder_)),
      columns_(other.columns_),
      block_rows_(other.block_rows_),
      block_(std::move(other.block_)),
      in_block_(other.in_block_),
      rows_(other.rows_) {}

Error RowSpill::refusal(const char* what) const {
  return {ErrorKind::unreadable, std::string(what) + ": " + std::strerror(errno), folder_};
}

Status RowSpill::add(std::span<const std::uint64_t> row) {
  for (std::size_t column = 0; column < columns_; ++column) {
    block_[column * block_rows_ + in_block_] = row[column];
  }
  ++in_block_;
  ++rows_;
  return in_block_ < block_rows_ ? Status{} : writeBlock();
}

Status RowSpill::writeBlock() {
  const ByteView bytes = std::as_bytes(std::span(block_));
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t count = ::write(file_, bytes.data() + done, bytes.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return refusal("cannot write a temporary file");
    done += static_cast<std::size_t>(count);
  }
  in_block_ = 0;
  return {};
}

Status RowSpill::readColumn(std::size_t column, const std::function<Status(ByteView)>& use) {
  const std::uint64_t blocks = rows_ / block_rows_;
  std::vector<std::uint64_t> cells(block_rows_);
  const std::span<std::byte> bytes = std::as_writable_bytes(std::span(cells));
  for (std::uint64_t block = 0; block < blocks; ++block) {
    const std::uint64_t from = (block * columns_ + column) * bytes.size();
    for (std::size_t done = 0; done < bytes.size();) {
      const ssize_t count =
          ::pread(file_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(from + done));
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return refusal("cannot read a temporary file");
      done += static_cast<std::size_t>(count);
    }
    if (Status used = use(bytes); !used) return used;
  }
  const auto last = std::span(block_).subspan(column * block_rows_, in_block_);
  return last.empty() ? Status{} : use(std::as_bytes(last));
}

}  // namespace rocinante
