#include "golden/why/model_change.h"

#include <fmt/format.h>

#include <utility>

#include "core/base/plain_text.h"
#include "core/bundle/cell_folder.h"
#include "core/check/drift/model_drift.h"
#include "golden/why/file_change.h"

namespace rocinante {
namespace {

void addTo(std::vector<std::string>& lines, std::vector<std::string> more) {
  lines.insert(lines.end(), std::make_move_iterator(more.begin()),
               std::make_move_iterator(more.end()));
}

std::vector<std::string> driftLines(const Cell& golden, const Cell& now) {
  std::vector<std::string> lines;
  for (const Finding& finding : modelDrift(golden, now)) lines.push_back(plainText(finding.text));
  return lines;
}

/// Replaces the texts of a bundle with the golden's for the lifetime of this object.
class GoldenTexts {
 public:
  GoldenTexts(CellBundle& bundle, const FileHashes& golden, const FileTexts& texts)
      : bundle_(bundle) {
    for (std::size_t i = 0; i < bundle.contents.size(); ++i) {
      BundleManifest::File& file = bundle.manifest.files[i];
      const auto before = golden.find(file.name);
      if (before == golden.end() || before->second == file.sha256) continue;
      const auto text = texts.find(before->second);
      if (text == texts.end()) {
        unknown_ += isToldText(file.name) ? 1 : 0;
        continue;
      }
      const ByteView bytes = bytesOf(text->second);
      kept_.emplace_back(i, file, std::exchange(bundle.contents[i], {bytes.begin(), bytes.end()}));
      file.bytes = bytes.size();
      file.sha256 = before->second;
    }
  }
  ~GoldenTexts() {
    for (auto& [place, file, content] : kept_) {
      bundle_.manifest.files[place] = std::move(file);
      bundle_.contents[place] = std::move(content);
    }
  }
  GoldenTexts(const GoldenTexts&) = delete;
  GoldenTexts& operator=(const GoldenTexts&) = delete;

  bool any() const { return !kept_.empty(); }
  /// Number of changed files without a kept text.
  std::size_t unknown() const { return unknown_; }

 private:
  struct Kept {
    Kept(std::size_t its_place, BundleManifest::File its_file, Bytes its_content)
        : place(its_place), file(std::move(its_file)), content(std::move(its_content)) {}
    std::size_t place;
    BundleManifest::File file;
    Bytes content;
  };
  CellBundle& bundle_;
  std::vector<Kept> kept_;
  std::size_t unknown_ = 0;
};

}  // namespace

std::vector<std::string> cellFaults(const Cell& cell) {
  std::vector<std::string> lines;
  for (const Finding& fault : cell.faults) {
    if (fault.severity != Severity::error) continue;
    std::string place = fault.file.empty() ? "" : fault.file + ": ";
    if (fault.line > 0) place.insert(place.size() - 2, fmt::format(":{}", fault.line));
    lines.push_back(plainText(place + fault.text));
  }
  return lines;
}

std::vector<std::string> modelChanges(const Cell& golden, const Cell& now) {
  std::vector<std::string> lines = cellFaults(now);
  addTo(lines, driftLines(golden, now));
  return lines;
}

std::vector<std::string> modelChanges(const FileHashes& golden, const FileTexts& texts,
                                      CellBundle& today, const Cell& now) {
  std::vector<std::string> lines;
  const FileHashes files_today = hashesOf(today);
  const GoldenTexts put_back(today, golden, texts);
  if (put_back.any()) {
    const auto before = loadBundle(today, "", {});
    if (before.ok()) addTo(lines, driftLines(*before, now));
  }
  addTo(lines, fileChanges(golden, files_today));
  if (put_back.unknown() > 0) {
    lines.push_back(
        "changes in these texts are unknown: the golden was accepted before texts were kept");
  }
  return lines;
}

}  // namespace rocinante
