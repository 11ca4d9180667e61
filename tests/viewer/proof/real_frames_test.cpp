// Hash goldens: the bits of frames of real machines, kept as hashes because their pictures are
// other people's. real_frames.txt has them, for one renderer; ROCINANTE_UPDATE=1 writes it anew and
// keeps the pictures beside it in ROCINANTE_UPDATE_PICTURES, to be looked at before it is
// committed.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include "core/atomic_file.h"
#include "tests/viewer/proof/real_machines.h"

namespace rocinante {
namespace {

const std::filesystem::path kTable =
    std::filesystem::path(ROCINANTE_SOURCE_DIR) / "tests/viewer/proof/real_frames.txt";

struct Looks {
  std::string name;
  std::vector<std::pair<std::string, std::string>> style;
};

const std::vector<Looks>& looksOfAll() {
  static const std::vector<Looks> looks{
      {"standard", {}},
      {"plain", {{"shading", "plain"}}},
      {"drawn", {{"shadows", "on"}, {"edges", "on"}, {"limits", "on"}}},
  };
  return looks;
}

/// Name of a frame to the hash of its pixels. Pictures go to `keep`, when it is named.
std::map<std::string, std::string> drawAll(std::string& key, const char* keep) {
  std::map<std::string, std::string> hashes;
  const test::TemporaryFolder folder;
  for (const test::RealMachine& machine : test::realMachines()) {
    auto maker = test::makerOf(machine, folder);
    if (!maker) {
      ADD_FAILURE() << machine.name << ": " << maker.error().text();
      continue;
    }
    key = maker->key().text();
    std::vector<std::string> cameras;
    for (const CellCamera& camera : maker->cell().cameras) cameras.push_back(camera.name);
    for (const std::string& camera : cameras) {
      for (std::size_t pose = 0; pose < std::max<std::size_t>(machine.poses.size(), 1); ++pose) {
        for (const Looks& looks : looksOfAll()) {
          FrameRequest request;
          request.time = test::sessionTime(static_cast<std::int64_t>(pose) * 1000);
          request.camera = camera;
          request.width = 320;
          request.height = 240;
          for (const auto& [word, value] : looks.style) {
            const Status set = setStyle(request.style, word, value);
            EXPECT_TRUE(set.has_value()) << set.error().text();
          }
          const auto frame = maker->frame(request);
          const std::string name =
              fmt::format("{}-{}-{}-{}", machine.name, camera, pose, looks.name);
          if (!frame) {
            ADD_FAILURE() << name << ": " << frame.error().text();
            continue;
          }
          hashes[name] = pictureXxh3(*frame);
          if (keep != nullptr) {
            const std::filesystem::path file = std::filesystem::path(keep) / (name + ".png");
            EXPECT_TRUE(writeFileWhole(file, encodePng(*frame), true).has_value());
          }
        }
      }
    }
  }
  return hashes;
}

TEST(RealFrames, HaveTheBitsThatWereLookedAt) {
  for (const test::RealMachine& machine : test::realMachines()) {
    ROCINANTE_NEEDS_SHARED_DATA(machine.folder);
  }
  std::string key;
  const auto drawn = drawAll(key, std::getenv("ROCINANTE_UPDATE_PICTURES"));
  if (std::getenv("ROCINANTE_UPDATE") != nullptr) {
    std::ofstream table(kTable);
    table << key << "\n";
    for (const auto& [name, hash] : drawn) table << name << " " << hash << "\n";
    FAIL() << "updated: look at the pictures, then run again without ROCINANTE_UPDATE";
  }
  std::ifstream table(kTable);
  std::string wanted_key;
  std::getline(table, wanted_key);
  if (key != wanted_key) {
    GTEST_SKIP() << "skipped: the hashes are of " << wanted_key << ", and this is " << key;
  }
  std::map<std::string, std::string> wanted;
  for (std::string name, hash; table >> name >> hash;) wanted[name] = hash;
  EXPECT_EQ(drawn.size(), wanted.size());
  for (const auto& [name, hash] : wanted) {
    const auto found = drawn.find(name);
    ASSERT_NE(found, drawn.end()) << name << " is not drawn any more";
    EXPECT_EQ(found->second, hash) << name;
  }
}

}  // namespace
}  // namespace rocinante
