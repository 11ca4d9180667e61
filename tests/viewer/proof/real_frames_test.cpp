// Hash goldens: the bits of frames of real machines, kept as hashes because their pictures are
// other people's. real_frames.txt has them, below the key of each renderer; ROCINANTE_UPDATE=1
// writes those of this one anew and keeps the pictures in ROCINANTE_UPDATE_PICTURES, to be looked
// at and to be compared with another key's (golden compare --tier rounding) before it is committed.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include "core/base/atomic_file.h"
#include "tests/viewer/proof/real_machines.h"

namespace rocinante {
namespace {

const std::filesystem::path kTable =
    std::filesystem::path(ROCINANTE_SOURCE_DIR) / "tests/viewer/proof/real_frames.txt";

using Hashes = std::map<std::string, std::string>;  // name of a frame, hash of its pixels

/// The accepted hashes of each renderer's key: a line of one word is a key, those below are its.
std::map<std::string, Hashes> readTable() {
  std::map<std::string, Hashes> table;
  std::ifstream file(kTable);
  Hashes* hashes = nullptr;
  for (std::string line; std::getline(file, line);) {
    const std::size_t blank = line.find(' ');
    if (blank == std::string::npos) {
      hashes = &table[line];
    } else if (hashes != nullptr) {
      (*hashes)[line.substr(0, blank)] = line.substr(blank + 1);
    }
  }
  return table;
}

void writeTable(const std::map<std::string, Hashes>& table) {
  std::ofstream file(kTable);
  for (const auto& [key, hashes] : table) {
    file << key << "\n";
    for (const auto& [name, hash] : hashes) file << name << " " << hash << "\n";
  }
}

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

/// Pictures go to `keep`, when it is named.
Hashes drawAll(std::string& key, const char* keep) {
  Hashes hashes;
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
  auto table = readTable();
  if (std::getenv("ROCINANTE_UPDATE") != nullptr) {
    table[key] = drawn;
    writeTable(table);
    FAIL() << "updated: look at the pictures, then run again without ROCINANTE_UPDATE";
  }
  const auto accepted = table.find(key);
  if (accepted != table.end()) {
    EXPECT_EQ(drawn.size(), accepted->second.size());
    for (const auto& [name, hash] : accepted->second) {
      const auto found = drawn.find(name);
      ASSERT_NE(found, drawn.end()) << name << " is not drawn any more";
      EXPECT_EQ(found->second, hash) << name;
    }
    return;
  }
  std::string others;
  for (const auto& frame : drawn) {
    const bool known = std::ranges::any_of(table, [&](const auto& renderer) {
      const auto found = renderer.second.find(frame.first);
      return found != renderer.second.end() && found->second == frame.second;
    });
    if (!known) others += " " + frame.first;
  }
  if (!others.empty()) {
    GTEST_SKIP() << "skipped: no frames of " << key
                 << " are accepted, and hashes cannot tell rounding from change; other bits have:"
                 << others;
  }
}

}  // namespace
}  // namespace rocinante
