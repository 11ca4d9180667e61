#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include "core/bundle/cell_bundle.h"
#include "core/log/log_reader.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"

namespace rocinante::test {

inline std::string fileText(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A triangle with a material library and a texture: an OBJ with every kind of file that it can
/// name.
inline void writeTank(const std::filesystem::path& folder, const std::string& texture) {
  writeFile(folder / "tank.obj",
            "mtllib tank.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
            "usemtl steel\nf 1/1 2/2 3/3\n");
  writeFile(folder / "tank.mtl", "newmtl steel\nKd 1 1 1\nmap_Kd " + texture + "\n");
}

constexpr std::string_view kArm = R"(<robot name="arm"><link name="foot"><visual><geometry>
<mesh filename="MESH"/></geometry></visual></link><link name="tip"/>
<joint name="lift" type="prismatic"><parent link="foot"/><child link="tip"/><axis xyz="0 0 1"/>
<limit lower="0" upper="1" effort="1" velocity="1"/></joint></robot>)";

inline std::string armWith(const std::string& mesh) {
  std::string text(kArm);
  return text.replace(text.find("MESH"), 4, mesh);
}

/// Files of a bundle with their content.
inline std::map<std::string, std::string> filesOf(const CellBundle& bundle) {
  std::map<std::string, std::string> files;
  for (std::size_t i = 0; i < bundle.contents.size(); ++i) {
    files[bundle.manifest.files[i].name] = textOf(bundle.contents[i]);
  }
  return files;
}

inline std::vector<std::string> namesIn(const CellBundle& bundle) {
  std::vector<std::string> names;
  for (const BundleManifest::File& file : bundle.manifest.files) names.push_back(file.name);
  return names;
}

/// A log with one captured message and, when given, a cell.
inline void writeLog(const std::filesystem::path& path, const CellBundle* bundle) {
  auto log = LogWriter::create(path, {}, "session-1");
  ASSERT_TRUE(log.ok()) << log.error().text();
  const LogTime time{Nanoseconds(1'700'000'000'000'000'000)};
  if (bundle != nullptr) {
    ASSERT_TRUE(AttachedBundle(*bundle).writeTo(*log, time).ok());
  }
  const auto channel = log->addChannel("/udp/19960/arm", "rk1", {});
  ASSERT_TRUE(channel.ok());
  ASSERT_TRUE(log->write(*channel, 0, time, 0, bytesOf("RK1 arm - -\njoints tank 0.5\n")).ok());
  ASSERT_TRUE(log->close("test").ok());
}

}  // namespace rocinante::test
