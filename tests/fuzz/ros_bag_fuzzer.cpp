// Any bytes as a bag of ROS 1, a sqlite3 bag or an MCAP of ROS: imported whole. Nothing may crash,
// hang or take memory without bound, and what comes out is a log without damage.

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "core/foreign/ros/bag_import.h"
#include "core/log/log_reader.h"

namespace {

using Bag = rocinante::Result<std::unique_ptr<rocinante::ros::BagReader>>;

/// SQLite opens files alone: one a process, removed when it ends.
class DatabaseFile {
 public:
  DatabaseFile()
      : path_(std::filesystem::temp_directory_path() /
              ("ros_bag_fuzzer." + std::to_string(::getpid()) + ".db3")) {}
  ~DatabaseFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }

  Bag open(rocinante::ByteView bytes) const {
    std::ofstream(path_, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    return rocinante::ros::openSqliteBag(path_);
  }

 private:
  std::filesystem::path path_;
};

Bag openBytes(rocinante::ByteView bytes) {
  using rocinante::ros::BagKind;
  static const DatabaseFile database;
  switch (rocinante::ros::bagKindOf(bytes)) {
    case BagKind::mcap:
      return rocinante::ros::openMcapBytes(bytes, "fuzz");
    case BagKind::sqlite:
      return database.open(bytes);
    default:
      return rocinante::ros::openRos1Bytes(bytes, "fuzz");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace rocinante;
  const ByteView bytes(reinterpret_cast<const std::byte*>(data), size);
  Bag bag = openBytes(bytes);
  if (!bag) return 0;
  std::vector<std::unique_ptr<ros::BagReader>> bags;
  bags.push_back(std::move(*bag));
  Bytes log;
  const Result<ros::ImportReport> report =
      ros::importBags(std::move(bags), makeMemorySink(log), "fuzz", {});
  if (!report) return 0;
  Result<LogReader> reader = LogReader::openBytes(log, "made");
  if (!reader || reader->summary().messages != report->messages) std::abort();
  while (*reader->next()) {
  }
  if (!reader->damage().empty()) std::abort();
  return 0;
}
