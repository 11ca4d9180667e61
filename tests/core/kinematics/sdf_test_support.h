#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/loaded_module.h"
#include "core/kinematics/sdf_reader.h"
#include "tests/core/kinematics/model_test_support.h"
#include "tests/support/write_file.h"

#define ROCINANTE_NEEDS_SDF                         \
  if (!loadModule("librocinante_sdformat.so").ok()) \
  GTEST_SKIP() << "built without ROCINANTE_SDF (libsdformat)"

namespace rocinante::test {

inline constexpr const char* kTwoParts =
    "o left\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no right\nv 10 0 0\nv 12 0 0\nv 10 4 0\n"
    "f 4 5 6\n";

/// An SDF read from text named arm.sdf; `obj` is two.obj beside it.
struct ReadSdf : ReadModel {
  explicit ReadSdf(std::string_view text, std::string_view obj = {}) {
    if (!obj.empty()) writeFile(folder / "two.obj", std::string(obj));
    MeshStore meshes(search, true);
    model = readSdf(bytesOf(text), folder / "arm.sdf", meshes, faults);
  }
};

}  // namespace rocinante::test
