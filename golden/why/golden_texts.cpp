#include "golden/why/golden_texts.h"

#include <filesystem>
#include <set>
#include <utility>

#include "golden/why/file_change.h"

namespace rocinante {

FileContents contentsOf(const CellBundle& bundle) {
  FileContents contents;
  for (std::size_t i = 0; i < bundle.contents.size(); ++i) {
    contents.emplace(bundle.manifest.files[i].sha256, bundle.contents[i]);
  }
  return contents;
}

GoldenTexts::GoldenTexts(CellBundle& bundle, const FileHashes& golden, const FileTexts& texts,
                         const FileContents& at_hand)
    : bundle_(bundle), files_(bundle.contents.size()), names_(bundle.manifest.names.size()) {
  addGone(golden, texts, at_hand);
  for (std::size_t i = 0; i < files_; ++i) {
    BundleManifest::File& file = bundle.manifest.files[i];
    const auto before = golden.find(file.name);
    if (before == golden.end() || before->second == file.sha256) continue;
    const auto text = texts.find(before->second);
    const auto content = at_hand.find(before->second);
    if (text == texts.end() && content == at_hand.end()) {
      unknown_ += isRecordedText(file.name) ? 1 : 0;
      continue;
    }
    const ByteView bytes = text != texts.end() ? bytesOf(text->second) : content->second;
    kept_.push_back({i, file, std::exchange(bundle.contents[i], {bytes.begin(), bytes.end()})});
    file.bytes = bytes.size();
    file.sha256 = before->second;
  }
}

/// Files that the golden had by names that are no file's now. Who named them is not known: whoever
/// lies in a folder and gives the way from there.
void GoldenTexts::addGone(const FileHashes& golden, const FileTexts& texts,
                          const FileContents& at_hand) {
  const FileHashes today = hashesOf(bundle_);
  FileContents contents = contentsOf(bundle_);
  contents.insert(at_hand.begin(), at_hand.end());
  for (const auto& [sha256, text] : texts) contents.try_emplace(sha256, bytesOf(text));
  std::set<std::string> folders;
  for (const auto& [name, sha256] : golden) {
    folders.insert(std::filesystem::path(name).parent_path().generic_string());
  }
  for (const auto& [name, sha256] : golden) {
    const auto content = contents.find(sha256);
    if (today.contains(name) || content == contents.end()) continue;
    bundle_.manifest.files.push_back({name, content->second.size(), sha256});
    bundle_.contents.emplace_back(content->second.begin(), content->second.end());
    for (const std::string& folder : folders) {
      const std::string text =
          std::filesystem::path(name).lexically_relative(folder.empty() ? "." : folder).string();
      bundle_.manifest.names.push_back({folder, text.empty() ? name : text, name});
    }
  }
}

GoldenTexts::~GoldenTexts() {
  bundle_.manifest.files.resize(files_);
  bundle_.contents.resize(files_);
  bundle_.manifest.names.resize(names_);
  for (auto& [place, file, content] : kept_) {
    bundle_.manifest.files[place] = std::move(file);
    bundle_.contents[place] = std::move(content);
  }
}

}  // namespace rocinante
