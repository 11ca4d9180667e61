#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "core/cell/cell.h"
#include "core/packet/packet_text.h"
#include "core/packet/session_state.h"
#include "tests/core/kinematics/model_test_support.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"

namespace rocinante::test {

/// A state made from the lines of one packet.
inline SessionState stateOf(std::string_view lines) {
  PacketTextDecoder decoder;
  SessionState state;
  const std::string text = "RK1 test - -\n" + std::string(lines);
  if (const Packet* packet = decoder.decode(bytesOf(text))) {
    EXPECT_TRUE(packet->faults.empty()) << "the test's own packet is malformed: " << text;
    state.apply(LogTime{}, *packet);
  }
  return state;
}

/// A folder with the files that cells of the tests and of docs/cell-format.md name.
class CellFolder : public testing::Test {
 protected:
  CellFolder() {
    const std::string_view arm = R"(<robot name="arm"><link name="foot"/><link name="tip"/>
<joint name="lift" type="prismatic"><parent link="foot"/><child link="tip"/><axis xyz="0 0 1"/>
<limit lower="0" upper="1" effort="1" velocity="1"/></joint></robot>)";
    writeFile(folder_ / "arm.urdf", arm);
    writeFile(folder_ / "models/arm.urdf", arm);
    std::string gantry = "v 0 0 2\nv 1 0 2\nv 0 1 2\n";
    for (const char* group : {"frame", "bridge_left", "bridge_right", "trolley", "hand"}) {
      gantry += std::string("g ") + group + "\nf 1 2 3\n";
    }
    writeFile(folder_ / "gantry.obj", gantry);
    writeFile(folder_ / "site.cell.toml", "format = 1\n[[layer]]\nname = \"robots\"\n");
    writeFile(folder_ / "tank.obj", "v 0 0 0\nv 1000 0 0\nv 0 1000 0\nf 1 2 3\n");
  }

  Result<Cell> load(std::string_view text) {
    writeFile(folder_ / "test.cell.toml", text);
    return loadCell(folder_ / "test.cell.toml", {});
  }
  /// The faults of a cell; "REFUSED: why" when nothing loads.
  std::string faultsOf(std::string_view text) {
    const auto cell = load(text);
    if (cell.ok()) return printed(cell->faults, folder_.path());
    std::string why = cell.error().text();
    const std::string folder = folder_.path().string() + "/";
    if (const auto at = why.find(folder); at != std::string::npos) why.erase(at, folder.size());
    return "REFUSED: " + why;
  }

  TemporaryFolder folder_;
};

}  // namespace rocinante::test
