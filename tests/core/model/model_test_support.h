#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "core/model/cell.h"
#include "core/model/urdf_reader.h"
#include "core/packet/packet_text.h"
#include "core/packet/session_state.h"
#include "tests/support/temporary_folder.h"

namespace rocinante::test {

/// Writes a file and the folders above it.
inline void writeFile(const std::filesystem::path& path, std::string_view text) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
}

/// The faults as a program lists them, one a line, without the folder `within`.
inline std::string printed(const ModelFaults& faults, const std::filesystem::path& within = {}) {
  std::string text;
  for (const ModelFault& fault : faults) text += fault.print() + "\n";
  const std::string folder = within.string() + "/";
  for (std::size_t at; !within.empty() && (at = text.find(folder)) != std::string::npos;) {
    text.erase(at, folder.size());
  }
  return text;
}

/// A URDF read from text named robot.urdf, with a search root of its own.
struct ReadUrdf {
  explicit ReadUrdf(std::string_view text) {
    static_cast<void>(search.addRoot(folder.path()).ok());
    MeshStore meshes(search, true);
    model = readUrdf(bytesOf(text), folder / "robot.urdf", meshes, faults);
  }
  std::string faultText() const { return printed(faults, folder.path()); }

  TemporaryFolder folder;
  FileSearch search;
  ModelFaults faults;
  std::optional<Model> model;
};

/// A state made by the lines of one packet.
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

}  // namespace rocinante::test
