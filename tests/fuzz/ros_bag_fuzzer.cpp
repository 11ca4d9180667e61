// Any bytes as a bag of ROS 1 or an MCAP of ROS: imported whole. Nothing may crash, hang or take
// memory without bound, and what comes out is a log without damage.

#include <cstdlib>

#include "core/foreign/ros/bag_import.h"
#include "core/log/log_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace rocinante;
  const ByteView bytes(reinterpret_cast<const std::byte*>(data), size);
  Result<std::unique_ptr<ros::BagReader>> bag = ros::bagKindOf(bytes) == ros::BagKind::mcap
                                                    ? ros::openMcapBytes(bytes, "fuzz")
                                                    : ros::openRos1Bytes(bytes, "fuzz");
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
