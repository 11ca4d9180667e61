#include "core/foreign/recordings/opened_recording.h"

#include <algorithm>
#include <utility>

#include "core/base/hash.h"
#include "core/base/unfinished_path.h"
#include "core/base/version.h"
#include "core/bundle/cell_or_log.h"
#include "core/foreign/recordings/bag_folder.h"
#include "core/foreign/recordings/capture_import.h"
#include "core/foreign/recordings/file_digest.h"
#include "core/foreign/recordings/import_cache.h"
#include "core/foreign/recordings/recording_kind.h"
#include "core/foreign/ros/bag_import.h"
#include "core/foreign/ros/robot_description.h"
#include "core/log/import_record.h"
#include "core/log/log_reader.h"
#include "core/log/new_log_file.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

/// To be raised whenever the same recording would become another log.
constexpr std::string_view kImportFormat = "rocinante-import-6";
/// Hashing is about a tenth of the work.
constexpr double kHashedPart = 0.1;

class RecordingOpening {
 public:
  RecordingOpening(const RecordingRequest& request, RecordingKind kind)
      : request_(request), kind_(kind), files_(filesOfRecording(request.recording)) {}

  Result<OpenedRecording> open() {
    if (Status read = readCellNames(); !read) return read.error();
    const Result<std::string> key = keyOfImport();
    if (!key) return key.error();
    OpenedRecording opened;
    opened.recording = request_.recording;
    opened.imported = true;
    std::string trouble = "neither XDG_CACHE_HOME nor HOME names a folder";
    if (const std::optional<ImportCache> cache = ImportCache::ofUser()) {
      if (const auto found = cache->find(*key)) return withWarnings(std::move(opened), *found);
      const auto made = cache->findOrMake(
          *key, [&](const fs::path& log) { return make(log); }, [&] { return tell(kHashedPart); });
      if (!made) return made.error();
      if (!made->trouble) return withWarnings(std::move(opened), made->log);
      trouble = made->trouble->text();
    }
    const auto folder = PrivateFolder::make();
    if (!folder) return folder.error();
    opened.folder = *folder;
    const fs::path log = (*folder)->path() / "imported.mcap";
    UnfinishedPath unfinished(log);
    if (Status made = make(log); !made) return made.error();
    unfinished.keep();
    Result<OpenedRecording> whole = withWarnings(std::move(opened), log);
    if (whole) whole->not_kept = "the import is not kept for the next time: " + trouble;
    return whole;
  }

 private:
  Status tell(double part) const { return request_.progress ? request_.progress(part) : Status{}; }

  Status readCellNames() {
    if (request_.cell.empty() || request_.cell == request_.recording) return {};
    CellOptions options;
    static_cast<ModelSearch&>(options) = request_.search;
    options.geometry = false;
    Result<Cell> names = loadCellOrLog(request_.cell, options);
    if (!names) return names.error();
    names_ = std::move(*names);
    return {};
  }

  /// Everything that the log depends on.
  Result<std::string> keyOfImport() const {
    Sha256 hash;
    const auto add = [&](std::string_view text) {
      hash.addU64(text.size());
      hash.add(bytesOf(text));
    };
    add(kImportFormat);
    add(version());
    add(request_.recording.filename().string());  // damage names it
    add(request_.device);
    for (const std::string& sentence : damageOfBagFolder(request_.recording)) add(sentence);
    for (const ros::StatedMessages& each : statedOfBagFolder(request_.recording, 0)) {
      add(each.name);
      add(each.count ? std::to_string(*each.count) : "");
      add(each.compression);
    }
    addNames(add);
    if (Status described = addDescription(add); !described) return described.error();
    for (std::size_t i = 0; i < files_.size(); ++i) {
      if (Status added = addOneFile(hash, i); !added) return added.error();
    }
    return hexOf(hash.finish());
  }

  Status addOneFile(Sha256& hash, std::size_t number) const {
    const fs::path& file = files_[number];
    if (file != request_.recording) {
      const std::string name = file.filename().string();
      hash.addU64(name.size());
      hash.add(bytesOf(name));
    }
    const auto before = static_cast<double>(number);
    const auto all = static_cast<double>(files_.size());
    Status added =
        addFile(hash, file, [&](double part) { return tell((before + part) / all * kHashedPart); });
    // What a killed writer of a sqlite3 bag left beside it is read with it.
    const fs::path journal = file.string() + "-wal";
    std::error_code none;
    if (added && fs::is_regular_file(journal, none)) added = addFile(hash, journal, {});
    return added;
  }

  template <class Add>
  void addNames(const Add& add) const {
    if (!names_) return add("no cell");
    for (const CellDevice& device : names_->devices) {
      add("device");
      add(device.name);
      const Model* const model = names_->modelOf(device);
      if (model == nullptr) continue;
      for (std::size_t i = 0; i < model->links.size(); ++i) {
        add(i == model->root ? "root" : "link");
        add(model->links[i].name);
      }
      for (const Joint& joint : model->joints) {
        add(joint.mimic ? "mimic" : "joint");
        add(joint.name);
        add(std::to_string(static_cast<int>(joint.type)));
      }
    }
  }

  /// The robot that the bag describes, with the meshes that are found for it now.
  template <class Add>
  Status addDescription(const Add& add) const {
    if (kind_ != RecordingKind::bag) return {};
    for (const fs::path& file : files_) {
      const auto bag = ros::openBag(file);
      if (!bag) return bag.error();
      const auto robot = ros::describedRobot(**bag, request_.search);
      if (!robot || !*robot) continue;
      for (const std::string& note : (*robot)->notes) add(note);
      if ((*robot)->bundle) add(manifestText((*robot)->bundle->manifest));
      break;
    }
    return {};
  }

  Status make(const fs::path& log) const {
    Result<NewLogFile> file = NewLogFile::make(log, true);
    if (!file) return file.error();
    Result<std::string> session_id = ros::importedSessionId(files_);
    if (!session_id) return session_id.error();
    ros::ImportOptions options;
    options.cell = names_ ? &*names_ : nullptr;
    options.describe = true;
    options.device = request_.device;
    options.damage = damageOfBagFolder(request_.recording);
    options.stated = statedOfBagFolder(request_.recording, 0);
    options.search = request_.search;
    options.progress = [&](double part) { return tell(kHashedPart + part * (1 - kHashedPart)); };
    if (kind_ == RecordingKind::capture) {
      const auto report =
          importCapture(request_.recording, file->takeSink(), std::move(*session_id), options);
      if (!report) return report.error();
    } else {
      std::vector<std::unique_ptr<ros::BagReader>> all;
      for (const fs::path& input : files_) {
        auto recording = openRecording(input, request_.device);
        if (!recording) return recording.error();
        all.push_back(std::move(*recording));
      }
      const auto report =
          ros::importBags(std::move(all), file->takeSink(), std::move(*session_id), options);
      if (!report) {
        // Without a place it is about the recording.
        Error error = report.error();
        if (error.where.empty()) error.where = request_.recording.string();
        return error;
      }
    }
    return file->publish();
  }

  static Result<OpenedRecording> withWarnings(OpenedRecording opened, const fs::path& log) {
    const Result<LogReader> reader = LogReader::open(log);
    if (!reader) return reader.error();
    opened.log = log;
    opened.warnings = importWarningsOf(reader->metadata());
    opened.left_out = accountOfLines(importLeftOutOf(reader->metadata()));
    return opened;
  }

  const RecordingRequest& request_;
  RecordingKind kind_;
  std::vector<fs::path> files_;
  std::optional<Cell> names_;
};

void replaceAll(std::string& text, const std::string& old, const std::string& now) {
  for (std::size_t at = text.find(old); at != text.npos; at = text.find(old, at + now.size())) {
    text.replace(at, old.size(), now);
  }
}

}  // namespace

Error OpenedRecording::named(Error error) const {
  if (!imported) return error;
  replaceAll(error.what, log.string(), recording.string());
  replaceAll(error.where, log.string(), recording.string());
  return error;
}

Result<OpenedRecording> openedRecording(const RecordingRequest& request) {
  const RecordingKind kind = recordingKindOf(request.recording);
  std::error_code none;
  const fs::path& path = request.recording;
  if (kind == RecordingKind::none &&
      (fs::is_regular_file(path, none) || fs::is_directory(path, none))) {
    if (auto refusal = refusalOf(path)) {
      return Error{ErrorKind::unsupported, std::move(*refusal), path.string()};
    }
  }
  if (!isForeign(kind)) {
    OpenedRecording as_it_is;
    as_it_is.recording = as_it_is.log = request.recording;
    return as_it_is;
  }
  // "bag/" is "bag": what is kept of it lies beside the folder, not in it.
  RecordingRequest its = request;
  if (!its.recording.has_filename()) its.recording = its.recording.parent_path();
  if (request.cell == request.recording) its.cell = its.recording;
  Result<OpenedRecording> opened = RecordingOpening(its, kind).open();
  if (opened) opened->recording = request.recording;
  return opened;
}

Result<CellAndRecording> openedCellAndRecording(RecordingRequest request) {
  const bool alone = request.recording.empty() && isForeignRecording(request.cell);
  if (alone) request.recording = std::exchange(request.cell, {});
  CellAndRecording found;
  found.cell = request.cell;
  if (request.recording.empty()) return found;
  Result<OpenedRecording> opened = openedRecording(request);
  if (!opened) return opened.error();
  found.opened = std::move(*opened);
  found.log = found.opened.log;
  if (alone || request.cell == request.recording) found.cell = found.log;
  return found;
}

bool isForeignRecording(const std::filesystem::path& path) {
  return isForeign(recordingKindOf(path));
}

}  // namespace rocinante
