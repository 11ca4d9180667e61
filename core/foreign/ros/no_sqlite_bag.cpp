#include "core/foreign/ros/bag_reader.h"

namespace rocinante::ros {

Result<std::unique_ptr<BagReader>> openSqliteBag(const std::filesystem::path& path) {
  return Error{ErrorKind::unsupported,
               "it is a SQLite file; this build has no libsqlite3 to read ROS 2 bags of that kind",
               path.string()};
}

}  // namespace rocinante::ros
