#include <algorithm>
#include <string_view>

#include "core/foreign/ros/bag_reader.h"
#include "core/foreign/ros/ros1_record.h"
#include "core/log/foreign_file.h"
#include "core/log/mapped_file.h"
#include "core/mcap/records.h"

namespace rocinante::ros {

std::optional<FieldCursor::Layout> BagTopic::layout() const {
  if (encoding == "cdr") return FieldCursor::Layout::cdr;
  if (encoding == "ros1") return FieldCursor::Layout::ros1;
  return std::nullopt;
}

BagKind bagKindOf(ByteView first_bytes) {
  const std::string_view text = textOf(first_bytes);
  if (text.starts_with(textOf(mcap::magic()))) return BagKind::mcap;
  if (text.starts_with("SQLite format 3")) return BagKind::sqlite;
  if (text.starts_with(kRos1Magic)) return BagKind::ros1;
  return BagKind::none;
}

Result<std::unique_ptr<BagReader>> openBag(const std::filesystem::path& path) {
  BagKind kind = BagKind::none;
  {
    const Result<MappedFile> file = MappedFile::open(path);
    if (!file) return file.error();
    Bytes first(std::min<std::size_t>(file->bytes().size(), 64));
    if (!file->read(0, first)) {
      return Error{ErrorKind::unreadable, "the file cannot be read", path.string()};
    }
    kind = bagKindOf(first);
    if (kind == BagKind::none) {
      return Error{ErrorKind::unsupported, notImportable(first), path.string()};
    }
  }
  switch (kind) {
    case BagKind::mcap:
      return openMcapBag(path);
    case BagKind::sqlite:
      return openSqliteBag(path);
    case BagKind::ros1:
      return openRos1Bag(path);
    case BagKind::none:
      break;
  }
  return Error{ErrorKind::unsupported, "not a bag", path.string()};
}

}  // namespace rocinante::ros
