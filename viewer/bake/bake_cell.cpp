#include "viewer/bake/bake_cell.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "viewer/bake/baked_guard.h"
#include "viewer/bake/cell_fields.h"
#include "viewer/bake/field_reader.h"
#include "viewer/bake/field_writer.h"
#include "viewer/picture/mipmaps.h"
#include "viewer/picture/picture.h"
#include "viewer/picture/png_files.h"

namespace rocinante {
namespace {

enum SectionId : std::uint32_t {
  kCellSection = 1,
  kModelSection = 2,
  kMeshSection = 3,
  kImageSection = 4,
  kPictureSection = 5,
};

/// A picture that some material names.
struct NamedPicture {
  std::filesystem::path name;
  std::shared_ptr<const Bytes> embedded;
  Bytes png{};
};

void addPicture(const Material& material,
                std::map<std::filesystem::path, std::shared_ptr<const Bytes>>& named) {
  if (!material.diffuse_map.empty()) named.emplace(material.diffuse_map, material.diffuse_bytes);
}

void addPictures(const Model& model,
                 std::map<std::filesystem::path, std::shared_ptr<const Bytes>>& named) {
  for (const Link& link : model.links) {
    for (const Visual& visual : link.visuals) {
      if (visual.material) addPicture(*visual.material, named);
      if (!visual.mesh) continue;
      for (const Material& material : visual.mesh->materials) addPicture(material, named);
    }
  }
}

/// In the order of SceneCatalog, which takes the first of two embedded ones of a name.
std::vector<NamedPicture> picturesOf(const Cell& cell) {
  std::map<std::filesystem::path, std::shared_ptr<const Bytes>> named;
  for (const auto& [name, model] : cell.models) {
    if (model) addPictures(*model, named);
  }
  for (const CellDevice& device : cell.devices) {
    if (device.dressed) addPictures(*device.dressed, named);
  }
  std::vector<NamedPicture> pictures;
  for (auto& [name, embedded] : named) pictures.push_back({name, std::move(embedded)});
  return pictures;
}

void decodeAll(std::vector<NamedPicture>& pictures, const Cell& cell, const BakeOptions& options) {
  const auto decodeOne = [&](std::size_t i) {
    NamedPicture& each = pictures[i];
    const auto at_hand = cell.pictures.find(each.name);
    Result<Picture> picture = at_hand != cell.pictures.end()
                                  ? decodePicture(at_hand->second, each.name.string())
                              : each.embedded ? decodePicture(*each.embedded, each.name.string())
                                              : readPicture(each.name);
    if (!picture || picture->width < 1 || picture->height < 1) return;
    while (options.largest_side > 0 &&
           std::max(picture->width, picture->height) > options.largest_side) {
      picture = halved(*picture);
    }
    each.png = options.compressed ? encodePng(*picture) : storedPng(*picture);
  };
  forEachIndex(options.parallel, pictures.size(), decodeOne);
  std::erase_if(pictures, [](const NamedPicture& each) { return each.png.empty(); });
}

/// A count, then names and lengths, then the pictures.
Bytes pictureSection(const std::vector<NamedPicture>& pictures, BakedSharing& sharing) {
  std::vector<std::pair<std::filesystem::path, std::size_t>> table;
  std::size_t total = 0;
  for (const NamedPicture& each : pictures) {
    table.emplace_back(each.name, each.png.size());
    total += each.png.size();
  }
  FieldWriter head(sharing);
  head(table);
  Bytes section = head.take();
  section.reserve(section.size() + total);
  for (const NamedPicture& each : pictures) {
    section.insert(section.end(), each.png.begin(), each.png.end());
  }
  return section;
}

Error brokenSection(const BakedFile& file, std::string_view what) {
  return {ErrorKind::damaged, fmt::format("the baked cell's {} break its format", what),
          file.name()};
}

/// Reads all values of a section, each checked by `guard`.
template <class Value, class Guard>
Status readShared(const BakedFile& file, std::uint32_t id, std::string_view what,
                  const ReadSharing& sharing, std::vector<std::shared_ptr<const Value>>& values,
                  const Guard& guard) {
  const Result<ByteView> section = file.section(id);
  if (!section) return section.error();
  FieldReader reader(*section, sharing);
  std::uint32_t count = 0;
  reader(count);
  for (std::uint32_t i = 0; i < count && reader.ok(); ++i) {
    auto value = std::make_shared<Value>();
    reader(*value);
    if (!reader.ok()) break;
    if (const char* const fault = guard(*value); fault != nullptr) {
      return Error{ErrorKind::damaged, fmt::format("in the baked cell's {}: {}", what, fault),
                   file.name()};
    }
    values.push_back(std::move(value));
  }
  if (!reader.finished()) return brokenSection(file, what);
  return {};
}

Status readPictures(const BakedFile& file, const ReadSharing& sharing, Cell& cell) {
  const Result<ByteView> section = file.section(kPictureSection);
  if (!section) return section.error();
  FieldReader reader(*section, sharing);
  std::vector<std::pair<std::filesystem::path, std::size_t>> table;
  reader(table);
  ByteView left = reader.left();
  for (const auto& [name, size] : table) {
    if (size == 0 || size > left.size()) return brokenSection(file, "pictures");
    if (!cell.pictures.emplace(name, left.first(size)).second)
      return brokenSection(file, "pictures");
    left = left.subspan(size);
  }
  if (!reader.ok() || !left.empty()) return brokenSection(file, "pictures");
  return {};
}

}  // namespace

Bytes bakeCell(const Cell& cell, const BakeOptions& options, const MoreSections& more) {
  BakedSharing sharing;
  sharing.path_text = options.path_text;
  std::vector<std::pair<std::uint32_t, Bytes>> made;
  FieldWriter cell_fields(sharing);
  cell_fields(cell);
  made.emplace_back(kCellSection, cell_fields.take());
  // Each section may name values of the next.
  const auto addShared = [&](std::uint32_t id, const auto& values) {
    FieldWriter writer(sharing);
    writer(static_cast<std::uint32_t>(values.size()));
    for (const auto* value : values) writer(*value);
    made.emplace_back(id, writer.take());
  };
  addShared(kModelSection, sharing.models.values());
  addShared(kMeshSection, sharing.meshes.values());
  addShared(kImageSection, sharing.images.values());
  std::vector<NamedPicture> pictures;
  if (options.pictures) {
    pictures = picturesOf(cell);
    decodeAll(pictures, cell, options);
  }
  made.emplace_back(kPictureSection, pictureSection(pictures, sharing));
  if (more) {
    for (auto& section : more()) made.push_back(std::move(section));
  }
  std::vector<BakedFile::Section> sections;
  for (const auto& [id, content] : made) sections.push_back({id, content});
  return bakedFile(options.key, sections);
}

Result<Cell> readBakedCell(const BakedFile& file, std::shared_ptr<const void> keeps) {
  ReadSharing sharing;
  const auto no_guard = [](const Bytes&) -> const char* { return nullptr; };
  Status read = readShared(file, kImageSection, "images", sharing, sharing.images, no_guard);
  if (read) read = readShared(file, kMeshSection, "meshes", sharing, sharing.meshes, faultOfMesh);
  if (read) read = readShared(file, kModelSection, "models", sharing, sharing.models, faultOfModel);
  if (!read) return read.error();

  const Result<ByteView> section = file.section(kCellSection);
  if (!section) return section.error();
  Cell cell;
  FieldReader reader(*section, sharing);
  reader(cell);
  if (!reader.finished()) return brokenSection(file, "fields");
  if (const char* const fault = faultOfCell(cell); fault != nullptr) {
    return Error{ErrorKind::damaged, fmt::format("in the baked cell: {}", fault), file.name()};
  }
  if (Status pictures = readPictures(file, sharing, cell); !pictures) return pictures.error();
  cell.keeps_pictures = std::move(keeps);
  return cell;
}

}  // namespace rocinante
