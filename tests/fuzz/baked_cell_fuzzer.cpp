// Any bytes as the sections of a baked cell, with every checksum right; and as the file itself.
// What is read must be posed in the empty state, and must bake to what reads the same again.

#include <cstdlib>

#include "core/cell/posed_scene.h"
#include "viewer/bake/bake_cell.h"

using namespace rocinante;

namespace {

void require(bool sound) {
  if (!sound) std::abort();
}

void readBaked(ByteView bytes) {
  const auto keeps = std::make_shared<const Bytes>(bytes.begin(), bytes.end());
  const auto file = BakedFile::parse(*keeps, "fuzz");
  if (!file.ok()) {
    require(!file.error().what.empty());
    return;
  }
  const auto cell = readBakedCell(*file, keeps);
  if (!cell.ok()) {
    require(!cell.error().what.empty());
    return;
  }
  const PosedScene scene = poseScene(*cell, SessionState{});
  for (const PosedDevice& device : scene.devices) {
    require(device.link_world.size() == device.model->links.size());
  }
  BakeOptions bare;
  bare.pictures = false;
  const auto again = std::make_shared<const Bytes>(bakeCell(*cell, bare));
  const auto parsed = BakedFile::parse(*again, "again");
  require(parsed.ok());
  const auto twice = readBakedCell(*parsed, again);
  require(twice.ok() && bakeCell(*twice, bare) == *again);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const ByteView bytes = std::as_bytes(std::span(data, size));
  readBaked(bytes);
  // Lengths of the sections, two bytes each, then their contents.
  constexpr std::size_t kSections = 5;
  if (size < 2 * kSections) return 0;
  ByteView left = bytes.subspan(2 * kSections);
  std::vector<BakedFile::Section> sections;
  for (std::size_t i = 0; i < kSections; ++i) {
    const std::size_t wanted = data[2 * i] + std::size_t{256} * data[2 * i + 1];
    const std::size_t length = std::min(wanted, left.size());
    sections.push_back({static_cast<std::uint32_t>(i + 1), left.first(length)});
    left = left.subspan(length);
  }
  readBaked(bakedFile({}, sections));
  return 0;
}
