#include "core/archive/zip_archive.h"

#include <fmt/format.h>
#include <zip.h>

#include <utility>

#include "core/base/plain_text.h"

namespace rocinante {
namespace {

std::string textOfFault(zip_error_t& fault) {
  std::string text = zip_error_strerror(&fault);
  zip_error_fini(&fault);
  return text;
}

Error notReadable(const std::string& file, const std::string& why) {
  return {ErrorKind::damaged, "the ZIP file cannot be read: " + why, file};
}

struct CloseFile {
  void operator()(zip_file_t* file) const { zip_fclose(file); }
};

}  // namespace

struct ZipArchive::Handle {
  explicit Handle(zip_t* opened) : zip(opened) {}
  // Never written: nothing to keep.
  ~Handle() { zip_discard(zip); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;

  zip_t* zip;
};

ZipArchive::ZipArchive(std::unique_ptr<Handle> handle, std::string file)
    : handle_(std::move(handle)), file_(std::move(file)) {}
ZipArchive::~ZipArchive() = default;
ZipArchive::ZipArchive(ZipArchive&&) noexcept = default;

Result<ZipArchive> ZipArchive::open(const std::filesystem::path& path) {
  int code = 0;
  zip_t* const zip = zip_open(path.c_str(), ZIP_RDONLY, &code);
  if (zip == nullptr) {
    zip_error_t fault;
    zip_error_init_with_code(&fault, code);
    return notReadable(path.string(), textOfFault(fault));
  }
  return made(std::make_unique<Handle>(zip), path.string());
}

Result<ZipArchive> ZipArchive::ofBytes(ByteView bytes, const std::string& file) {
  zip_error_t fault;
  zip_error_init(&fault);
  zip_source_t* const source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &fault);
  if (source == nullptr) return notReadable(file, textOfFault(fault));
  zip_t* const zip = zip_open_from_source(source, ZIP_RDONLY, &fault);
  if (zip == nullptr) {
    zip_source_free(source);
    return notReadable(file, textOfFault(fault));
  }
  return made(std::make_unique<Handle>(zip), file);
}

Result<ZipArchive> ZipArchive::made(std::unique_ptr<Handle> handle, const std::string& file) {
  const zip_int64_t files = zip_get_num_entries(handle->zip, 0);
  if (files > kMaxFiles) {
    return Error{ErrorKind::refused,
                 fmt::format("the ZIP file has {} files, more than {}", files, kMaxFiles), file};
  }
  ZipArchive archive(std::move(handle), file);
  for (zip_int64_t i = 0; i < files; ++i) {
    const char* const name =
        zip_get_name(archive.handle_->zip, static_cast<zip_uint64_t>(i), ZIP_FL_ENC_GUESS);
    if (name == nullptr || *name == '\0') continue;
    std::string text = name;
    if (text.back() != '/') archive.names_.push_back(std::move(text));
  }
  return archive;
}

Result<std::string> ZipArchive::read(const std::string& name, std::uint64_t most_bytes) const {
  const auto wrong = [&](const std::string& what) {
    return Error{ErrorKind::damaged, fmt::format("{} in the ZIP file {}", plainText(name), what),
                 file_};
  };
  zip_stat_t stat;
  zip_stat_init(&stat);
  if (zip_stat(handle_->zip, name.c_str(), ZIP_FL_ENC_GUESS, &stat) != 0 ||
      (stat.valid & ZIP_STAT_SIZE) == 0) {
    return wrong("cannot be read: " + std::string(zip_strerror(handle_->zip)));
  }
  if (stat.size > most_bytes) {
    return Error{ErrorKind::refused,
                 fmt::format("{} in the ZIP file has {} bytes, more than {}", plainText(name),
                             stat.size, most_bytes),
                 file_};
  }
  const std::unique_ptr<zip_file_t, CloseFile> file(zip_fopen_index(handle_->zip, stat.index, 0));
  if (!file) return wrong("cannot be read: " + std::string(zip_strerror(handle_->zip)));
  // Grows with what is there: a size that is a lie allocates nothing.
  std::string content;
  char piece[65536];
  while (true) {
    const zip_int64_t got = zip_fread(file.get(), piece, sizeof piece);
    if (got < 0) return wrong("cannot be read: " + std::string(zip_file_strerror(file.get())));
    if (got == 0) break;
    if (content.size() + static_cast<std::size_t>(got) > stat.size) {
      return wrong("is larger than its header states");
    }
    content.append(piece, static_cast<std::size_t>(got));
  }
  if (content.size() != stat.size) return wrong("ends early");
  return content;
}

}  // namespace rocinante
