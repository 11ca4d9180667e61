#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/test_session.h"
#include "viewer/render/frame_maker.h"

namespace rocinante::test {

/// A robot or site of the shared data, with cameras and a few poses.
struct RealMachine {
  std::string name;
  std::string folder;              ///< below sharedData()
  std::string cell;                ///< of its cell, behind the search root and the device
  std::string model;               ///< what the device names
  std::vector<std::string> poses;  ///< positional joints at 0 s, 1 s ...; empty: at rest, no log
};

inline const std::vector<RealMachine>& realMachines() {
  static const std::vector<RealMachine> machines{
      {"puma",
       "robots/puma560_description",
       "[[camera]]\nname = \"near\"\neye = [1.6, -1.5, 1.3]\ntarget = [0, 0, 0.6]\n",
       "urdf/puma560_robot.urdf",
       {"0 0 0 0 0 0", "0.7 -1.1 0.6 0.4 -0.9 1.2", "-2.1 -0.3 2.2 -1.4 1.1 -2.0"}},
      {"kuka",
       "robots/kuka_iiwa",
       "[[camera]]\nname = \"near\"\neye = [1.7, 1.2, 1.1]\ntarget = [0, 0, 0.6]\n",
       "model.urdf",
       {"0 0 0 0 0 0 0", "0.5 0.9 -0.4 -1.2 0.3 1.0 0.2", "-1.6 0.4 1.1 1.3 -0.8 -0.9 2.1"}},
      {"panda",
       "robots/franka_panda",
       "[[camera]]\nname = \"near\"\neye = [1.5, -1.3, 1.0]\ntarget = [0.2, 0, 0.5]\n",
       "panda.urdf",
       {"0 -0.4 0 -2.1 0 1.7 0.8 0.02", "1.1 0.6 -0.7 -1.0 0.9 2.4 -0.5 0.04"}},
      {"r2d2",
       "robots/r2d2",
       "[[camera]]\nname = \"near\"\neye = [-1.3, -1.5, 0.9]\ntarget = [0, 0, 0]\n",
       "r2d2.urdf",
       {"0 0 0 0 0 0 0 0", "0.9 0.9 -0.9 -0.9 -0.2 0.3 0.4 1.2"}},
      {"yard",
       "env/waste_yard",
       "[[model]]\nname = \"yard\"\nobj = \"waste_yard.obj\"\nunit = \"m\"\nup = \"z\"\n"
       "[[camera]]\nname = \"corner\"\neye = [30, -30, 20]\ntarget = [0, 10, 4]\nfov_deg = 60\n"
       "[[camera]]\nname = \"windows\"\neye = [-14, -18, 6]\ntarget = [-6, 10, 5]\nfov_deg = 45\n"
       "[[camera]]\nname = \"plan\"\neye = [0, 10, 60]\ntarget = [0, 10, 0]\nup = [0, 1, 0]\n"
       "ortho_height_m = 60\n",
       "yard",
       {}},
  };
  return machines;
}

/// Draws it in the reproducible profile; its files are read in place.
inline Result<FrameMaker> makerOf(const RealMachine& machine, const TemporaryFolder& folder) {
  const std::filesystem::path file = folder / (machine.name + ".cell.toml");
  writeText(file, "format = 1\nsearch = [\"" + sharedData(machine.folder).string() + "\", \"" +
                      sharedData("robots").string() + "\"]\n[[device]]\nname = \"" + machine.name +
                      "\"\nmodel = \"" + machine.model + "\"\n" + machine.cell);
  auto cell = loadCell(file, {});
  if (!cell) return cell.error();
  std::optional<Timeline> session;
  if (!machine.poses.empty()) {
    std::vector<std::pair<std::int64_t, std::string>> packets;
    for (std::size_t i = 0; i < machine.poses.size(); ++i) {
      packets.emplace_back(static_cast<std::int64_t>(i) * 1000,
                           "joints " + machine.name + " " + machine.poses[i] + "\n");
    }
    writeSession(folder / (machine.name + ".mcap"), packets);
    auto opened = Timeline::open(folder / (machine.name + ".mcap"));
    if (!opened) return opened.error();
    session = std::move(*opened);
  }
  return FrameMaker::open(std::move(*cell), std::move(session), Profile::reproducible);
}

}  // namespace rocinante::test
