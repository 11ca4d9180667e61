#include "core/mesh/scene_files.h"

#include <algorithm>
#include <cstring>
#include <memory>

#include "core/mesh/scene_reader.h"
#include "core/search/file_search.h"

namespace rocinante {
namespace {

/// A file in memory, for reading.
class MemoryStream : public Assimp::IOStream {
 public:
  explicit MemoryStream(ByteView bytes) : bytes_(bytes) {}
  explicit MemoryStream(Bytes own) : own_(std::move(own)), bytes_(own_) {}

  std::size_t Read(void* to, std::size_t size, std::size_t count) override {
    if (size == 0) return 0;
    const std::size_t whole = std::min(count, (bytes_.size() - at_) / size);
    if (whole > 0) std::memcpy(to, bytes_.data() + at_, whole * size);
    at_ += whole * size;
    return whole;
  }
  std::size_t Write(const void*, std::size_t, std::size_t) override { return 0; }
  aiReturn Seek(std::size_t offset, aiOrigin origin) override {
    const std::size_t base = origin == aiOrigin_SET   ? 0
                             : origin == aiOrigin_CUR ? at_
                                                      : bytes_.size();
    if (offset > bytes_.size() - base) return aiReturn_FAILURE;
    at_ = base + offset;
    return aiReturn_SUCCESS;
  }
  std::size_t Tell() const override { return at_; }
  std::size_t FileSize() const override { return bytes_.size(); }
  void Flush() override {}

 private:
  Bytes own_;
  ByteView bytes_;
  std::size_t at_ = 0;
};

}  // namespace

bool SceneFiles::Exists(const char* name) const {
  return name == name_ || !resolve_(name, path_.parent_path()).path.empty();
}

Assimp::IOStream* SceneFiles::Open(const char* name, const char* mode) {
  if (std::strchr(mode, 'w') != nullptr || std::strchr(mode, 'a') != nullptr) return nullptr;
  if (name == name_) return std::make_unique<MemoryStream>(bytes_).release();
  const std::filesystem::path found = resolve_(name, path_.parent_path()).path;
  if (found.empty()) {
    refused_ = name;
    return nullptr;
  }
  Result<Bytes> bytes = readWholeFile(found, kMaxSceneBytes);
  if (!bytes.ok()) return nullptr;
  return std::make_unique<MemoryStream>(std::move(*bytes)).release();
}

void SceneFiles::Close(Assimp::IOStream* stream) {
  const std::unique_ptr<Assimp::IOStream> ends(stream);
}

}  // namespace rocinante
