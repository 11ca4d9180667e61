#include "core/foreign/recordings/recording_inputs.h"

#include <system_error>
#include <utility>

#include "core/base/hash.h"
#include "core/foreign/recordings/bag_folder.h"
#include "core/foreign/recordings/datagram_folder.h"
#include "core/foreign/recordings/recording_kind.h"
#include "core/foreign/ros/bag_import.h"

namespace rocinante {
namespace {

bool isDatagramFolder(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::is_directory(path, error);
}

}  // namespace

std::vector<std::filesystem::path> filesOfRecording(const std::filesystem::path& recording) {
  std::vector<std::filesystem::path> files = filesOfBagFolder(recording);
  if (files.empty()) files.push_back(recording);
  return files;
}

Result<std::unique_ptr<ros::BagReader>> openInput(const std::filesystem::path& path,
                                                  const std::string& device) {
  return isDatagramFolder(path) ? openDatagramFolder(path) : openRecording(path, device);
}

Result<std::string> sessionIdOfInputs(const std::vector<std::filesystem::path>& paths) {
  std::vector<std::filesystem::path> files;
  std::string folders;
  for (const std::filesystem::path& path : paths) {
    if (!isDatagramFolder(path)) {
      files.push_back(path);
      continue;
    }
    const Result<std::string> id = datagramFolderId(path);
    if (!id) return id.error();
    folders += *id;
  }
  Result<std::string> id = ros::importedSessionId(files);
  if (!id || folders.empty()) return id;
  Sha256 hash;
  hash.add(bytesOf(*id + folders));
  return hexOf(hash.finish()).substr(0, 32);
}

}  // namespace rocinante
