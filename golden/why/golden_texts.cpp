#include "golden/why/golden_texts.h"

#include <utility>

#include "golden/why/file_change.h"

namespace rocinante {

GoldenTexts::GoldenTexts(CellBundle& bundle, const FileHashes& golden, const FileTexts& texts)
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
