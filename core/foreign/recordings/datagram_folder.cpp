#include "core/foreign/recordings/datagram_folder.h"

#include <sys/stat.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "core/base/atomic_file.h"
#include "core/base/count_text.h"
#include "core/base/hash.h"
#include "core/foreign/recordings/datagram_times.h"
#include "core/log/mapped_file.h"
#include "core/packet/decoder.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxFiles = 1'000'000;
constexpr std::uint64_t kMaxDatagramBytes = std::uint64_t{1} << 20U;

struct FolderContent {
  std::vector<DatagramFile> files;
  std::size_t passed_over = 0;  ///< folders, hidden files, devices
  std::size_t too_long = 0;
  std::string long_file;  ///< one of those; empty: none
};

/// What somebody named by mistake is not imported as datagrams: a folder of recordings, or a bag
/// whose files are compressed.
Status holdsDatagrams(const fs::path& folder, const FolderContent& content) {
  for (const DatagramFile& file : content.files) {
    if (file.name != "metadata.yaml") continue;
    return Error{ErrorKind::unsupported,
                 "a ROS 2 bag without a .db3 or .mcap file; files compressed as .zstd are unpacked "
                 "first: zstd -d FILE",
                 folder.string()};
  }
  if (content.files.empty() && content.long_file.empty()) return {};
  const std::string& one =
      content.long_file.empty() ? content.files.front().name : content.long_file;
  const Result<MappedFile> file = MappedFile::open(folder / one);
  // What cannot be read is counted when it is its turn.
  if (!file) return {};
  Bytes head(std::min<std::size_t>(file->bytes().size(), 64));
  if (!file->read(0, head) || ros::bagKindOf(head) == ros::BagKind::none) return {};
  return Error{ErrorKind::unsupported,
               "the folder holds recordings, not datagrams: name those files", folder.string()};
}

Result<FolderContent> contentOf(const fs::path& folder) {
  FolderContent content;
  std::error_code error;
  fs::directory_iterator entries(folder, error);
  for (; !error && entries != fs::directory_iterator(); entries.increment(error)) {
    const fs::path& path = entries->path();
    struct stat facts {};
    if (path.filename().string().starts_with('.') || ::stat(path.c_str(), &facts) != 0 ||
        !S_ISREG(facts.st_mode)) {
      ++content.passed_over;
      continue;
    }
    const auto bytes = static_cast<std::uint64_t>(facts.st_size);
    if (bytes > kMaxDatagramBytes) {
      ++content.too_long;
      content.long_file = path.filename().string();
      continue;
    }
    if (content.files.size() == kMaxFiles) {
      return Error{
          ErrorKind::unsupported,
          "the folder has more than 1,000,000 files: import parts of it, and merge the logs",
          folder.string()};
    }
    const std::int64_t changed_ns =
        static_cast<std::int64_t>(facts.st_mtim.tv_sec) * 1'000'000'000 + facts.st_mtim.tv_nsec;
    content.files.push_back({path.filename().string(), changed_ns, bytes});
  }
  if (error) {
    return Error{ErrorKind::unreadable, "the folder cannot be read: " + error.message(),
                 folder.string()};
  }
  if (Status they_are = holdsDatagrams(folder, content); !they_are) return they_are.error();
  if (content.files.empty()) {
    return Error{ErrorKind::not_found,
                 "the folder has no files: datagrams are files of at most 1 MiB, one each",
                 folder.string()};
  }
  return content;
}

class DatagramFolder final : public ros::BagReader {
 public:
  DatagramFolder(fs::path folder, FolderContent content)
      : folder_(std::move(folder)),
        passed_over_(content.passed_over),
        too_long_(content.too_long),
        order_(orderedDatagrams(std::move(content.files))) {
    for (const char* const encoding : {"octets", "rk1"}) {
      ros::BagTopic& topic = topics_.emplace_back();
      topic.name = "/datagrams";
      topic.type = "datagrams";
      topic.encoding = encoding;
      topic.captured = true;
    }
  }

  std::string_view kind() const override { return "datagrams"; }
  const std::vector<ros::BagTopic>& topics() const override { return topics_; }
  double part() const override {
    return static_cast<double>(at_) / static_cast<double>(order_.datagrams.size());
  }
  Result<std::optional<Bytes>> lastOf(std::size_t) override { return std::optional<Bytes>(); }

  Result<std::optional<ros::BagMessage>> next() override {
    while (at_ < order_.datagrams.size()) {
      const TimedDatagram& datagram = order_.datagrams[at_++];
      Result<std::string> bytes = readFile(folder_ / datagram.name, kMaxDatagramBytes);
      if (!bytes) {
        if (unread_++ == 0) first_unread_ = bytes.error().text();
        continue;
      }
      bytes_ = std::move(*bytes);
      ros::BagMessage message;
      message.payload = bytesOf(bytes_);
      message.topic = encodingOf(message.payload) == "rk1" ? 1 : 0;
      message.sequence = sequences_[message.topic]++;
      message.log_time = datagram.time;
      message.publish_time_ns = datagram.time.time_since_epoch().count();
      return std::optional(message);
    }
    return std::optional<ros::BagMessage>();
  }

  std::vector<std::string> damage() const override {
    std::vector<std::string> sentences;
    if (too_long_ > 0) {
      sentences.push_back(countText(too_long_, "file") + " of more than 1 MiB left out (" +
                          folder_.string() + ")");
    }
    if (unread_ > 0) {
      sentences.push_back(countText(unread_, "file") + " left out, the first: " + first_unread_);
    }
    return sentences;
  }

  std::vector<std::string> remarks() const override {
    std::vector<std::string> sentences;
    const std::string where = " (" + folder_.string() + ")";
    switch (order_.rule) {
      case DatagramOrder::Rule::names_are_times:
        sentences.push_back("the times of the datagrams are their files' names" + where);
        break;
      case DatagramOrder::Rule::names_are_numbers:
        sentences.push_back(
            "the order of the datagrams is that of the numbers in their files' names; their times "
            "are when the files were changed" +
            where);
        break;
      case DatagramOrder::Rule::changed:
        sentences.push_back("order and times of the datagrams are when their files were changed" +
                            where);
    }
    if (order_.held > 0) {
      sentences.push_back(countText(order_.held, "file") +
                          " changed before the one in front; its time is used" + where);
    }
    if (passed_over_ > 0) {
      sentences.push_back(countText(passed_over_, "folder or hidden or special file") +
                          " passed over" + where);
    }
    return sentences;
  }

 private:
  fs::path folder_;
  std::size_t passed_over_, too_long_;
  DatagramOrder order_;
  std::vector<ros::BagTopic> topics_;
  std::size_t at_ = 0;
  std::uint32_t sequences_[2] = {0, 0};
  std::string bytes_;
  std::size_t unread_ = 0;
  std::string first_unread_;
};

}  // namespace

Result<std::unique_ptr<ros::BagReader>> openDatagramFolder(const fs::path& folder) {
  Result<FolderContent> content = contentOf(folder);
  if (!content) return content.error();
  return std::unique_ptr<ros::BagReader>(
      std::make_unique<DatagramFolder>(folder, std::move(*content)));
}

Result<std::string> datagramFolderId(const fs::path& folder) {
  Result<FolderContent> content = contentOf(folder);
  if (!content) return content.error();
  std::ranges::sort(content->files, {}, &DatagramFile::name);
  Sha256 hash;
  for (const DatagramFile& file : content->files) {
    hash.addU64(file.name.size());
    hash.add(bytesOf(file.name));
    hash.addU64(static_cast<std::uint64_t>(file.changed_ns));
    hash.addU64(file.bytes);
  }
  return hexOf(hash.finish()).substr(0, 32);
}

}  // namespace rocinante
