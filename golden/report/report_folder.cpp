#include <set>

#include "core/base/atomic_file.h"
#include "golden/report/report_formats.h"
#include "golden/report/report_pictures.h"
#include "golden/report/report_reader.h"
#include "golden/why/run_pictures.h"

namespace rocinante {
namespace {

constexpr const char* kPictureEndings[] = {".frame.png", ".golden.png", ".difference.png"};

/// Files that are moved into a folder together, after all of them are written.
class ArrivingFiles {
 public:
  explicit ArrivingFiles(const std::filesystem::path& folder)
      : folder_(folder), aside_(folder / ".new") {}
  ~ArrivingFiles() {
    std::error_code ignored;
    std::filesystem::remove_all(aside_, ignored);
  }
  ArrivingFiles(const ArrivingFiles&) = delete;
  ArrivingFiles& operator=(const ArrivingFiles&) = delete;

  Status open() {
    std::error_code fault;
    std::filesystem::remove_all(aside_, fault);  // of a killed run
    std::filesystem::create_directories(aside_, fault);
    if (!fault) return {};
    return Error{ErrorKind::unreadable, "cannot create: " + fault.message(), folder_.string()};
  }

  Status write(const std::string& name, ByteView bytes) {
    names_.push_back(name);
    Status written = writeFileWhole(aside_ / name, bytes, true);
    if (written) return written;
    // Name the final path, which the user knows.
    return Error{written.error().kind, written.error().what, (folder_ / name).string()};
  }

  /// In the order in which they were written.
  Status arrive() {
    for (const std::string& name : names_) {
      std::error_code fault;
      std::filesystem::rename(aside_ / name, folder_ / name, fault);
      if (fault) {
        return Error{ErrorKind::unreadable, "cannot create: " + fault.message(),
                     (folder_ / name).string()};
      }
    }
    return {};
  }

  std::set<std::string> names() const { return {names_.begin(), names_.end()}; }

 private:
  std::filesystem::path folder_, aside_;
  std::vector<std::string> names_;
};

Status writePictures(const JudgedFrame& judged, ArrivingFiles& files) {
  if (isFine(judged.verdict)) return {};
  const auto write = [&](const char* ending, const Picture& picture) {
    return files.write(judged.frame.name + ending, encodePng(picture));
  };
  if (judged.drawn) {
    if (auto status = write(kPictureEndings[0], *judged.drawn); !status) return status;
  }
  if (judged.accepted) {
    if (auto status = write(kPictureEndings[1], *judged.accepted); !status) return status;
  }
  if (!judged.drawn || !judged.accepted || judged.accepted->width != judged.drawn->width ||
      judged.accepted->height != judged.drawn->height) {
    return {};
  }
  return write(kPictureEndings[2], differencePicture(judged.compared(), *judged.accepted));
}

Status writeRunPictures(const JudgedRun& run, ArrivingFiles& files) {
  for (std::size_t i = 0; i < run.pictures.size(); ++i) {
    const Bytes png = encodePng(run.pictures[i].picture);
    if (Status written = files.write(runPictureFile(run, i), png); !written) return written;
  }
  if (run.log_copy) return files.write(runLogFile(run), bytesOf(*run.log_copy));
  return {};
}

/// The names of pictures and pages of the report in a folder, whether or not the files exist.
std::set<std::string> besideReport(const std::filesystem::path& folder) {
  std::set<std::string> names;
  const auto text = readFile(folder / "report.json");
  if (!text.ok()) return names;
  const auto old = parseReport(*text, folder);
  if (!old.ok()) return names;
  names.insert(kDifferenceSheetFile);
  names.insert(kSessionPageFile);
  for (const JudgedFrame& judged : old->frames) {
    for (const char* ending : kPictureEndings) names.insert(judged.frame.name + ending);
  }
  for (const JudgedRun& run : old->runs) {
    names.insert(runPageFile(run));
    names.insert(runLogFile(run));
    for (std::size_t i = 0; i < kMaxRunPictures; ++i) names.insert(runPictureFile(run, i));
  }
  return names;
}

}  // namespace

Status writeReport(const SuiteReport& report, const std::filesystem::path& folder) {
  ArrivingFiles files(folder);
  if (auto opened = files.open(); !opened) return opened;
  for (const JudgedFrame& judged : report.frames) {
    if (auto written = writePictures(judged, files); !written) return written;
  }
  for (const JudgedRun& run : report.runs) {
    if (auto written = writeRunPictures(run, files); !written) return written;
  }
  for (const auto& [name, html] : report.pages) {
    if (auto written = files.write(name, bytesOf(html)); !written) return written;
  }
  if (const auto sheet = differenceSheet(report)) {
    const Bytes png = encodePng(sheetPicture(*sheet));
    if (auto written = files.write(kDifferenceSheetFile, png); !written) return written;
  }
  if (auto written = files.write(kPagePicturesFile, bytesOf(pagePicturesJson(report))); !written) {
    return written;
  }
  if (auto written = files.write("report.json", bytesOf(reportJson(report))); !written) {
    return written;
  }
  if (auto written = files.write("index.html", bytesOf(reportHtml(report))); !written) {
    return written;
  }
  const std::set<std::string> old_files = besideReport(folder);
  if (auto arrived = files.arrive(); !arrived) return arrived;
  const std::set<std::string> names = files.names();
  std::error_code ignored;
  for (const std::string& name : old_files) {
    if (!names.contains(name)) std::filesystem::remove(folder / name, ignored);
  }
  return {};
}

}  // namespace rocinante
