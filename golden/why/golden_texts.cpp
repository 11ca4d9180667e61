#include "golden/why/golden_texts.h"

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
    : bundle_(bundle) {
  for (std::size_t i = 0; i < bundle.contents.size(); ++i) {
    BundleManifest::File& file = bundle.manifest.files[i];
    const auto before = golden.find(file.name);
    if (before == golden.end() || before->second == file.sha256) continue;
    const auto text = texts.find(before->second);
    const auto content = at_hand.find(before->second);
    if (text == texts.end() && content == at_hand.end()) {
      unknown_ += isToldText(file.name) ? 1 : 0;
      continue;
    }
    const ByteView bytes = text != texts.end() ? bytesOf(text->second) : content->second;
    kept_.push_back({i, file, std::exchange(bundle.contents[i], {bytes.begin(), bytes.end()})});
    file.bytes = bytes.size();
    file.sha256 = before->second;
  }
}

GoldenTexts::~GoldenTexts() {
  for (auto& [place, file, content] : kept_) {
    bundle_.manifest.files[place] = std::move(file);
    bundle_.contents[place] = std::move(content);
  }
}

}  // namespace rocinante
