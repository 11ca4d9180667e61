#include "golden/self_test/test_frame.h"

#include <array>
#include <memory>

#include "core/kinematics/urdf_reader.h"
#include "core/mesh/mesh_store.h"
#include "core/search/file_search.h"

// ROCINANTE_SELF_TEST_FOLDER is set by CMakeLists.txt.
#define ROCINANTE_EMBED(name, file)                \
  ".global rocinante_self_test_" name              \
  "\n"                                             \
  "rocinante_self_test_" name                      \
  ":\n"                                            \
  ".incbin \"" ROCINANTE_SELF_TEST_FOLDER "/" file \
  "\"\n"                                           \
  ".global rocinante_self_test_" name              \
  "_end\n"                                         \
  "rocinante_self_test_" name "_end:\n"
asm(".section .rodata\n" ROCINANTE_EMBED("model", "arm.urdf") ROCINANTE_EMBED("frame", "frame.png")
        ROCINANTE_EMBED("picture", "picture.jpg") ".byte 0\n"
                                                  ".previous\n");
#undef ROCINANTE_EMBED

extern "C" {
// Hidden, so that their distance is a link-time constant in a shared library too.
#define ROCINANTE_EMBEDDED(name)                                                             \
  extern const std::byte rocinante_self_test_##name[] __attribute__((visibility("hidden"))); \
  extern const std::byte rocinante_self_test_##name##_end[] __attribute__((visibility("hidden")));
ROCINANTE_EMBEDDED(model)
ROCINANTE_EMBEDDED(frame)
ROCINANTE_EMBEDDED(picture)
#undef ROCINANTE_EMBEDDED
}

namespace rocinante {
namespace {

// Add a new one after looking at `rocinante self-test draw -o` on that renderer.
constexpr std::string_view kDebianFrame =
    "5e2b146f1a44a53903d80ddc105371a360e8b75ae02661c3bd71f7ba532c656f";
constexpr std::array kKnownFrames{
    KnownFrame{"llvmpipe-mesa22.3.6-llvm15.0.6-x86_64-sse4.1", kDebianFrame, "Debian 12"},
    KnownFrame{"llvmpipe-mesa25.0.7-llvm19.1.7-x86_64-sse4.1", kDebianFrame, "Debian 13"},
    KnownFrame{"llvmpipe-mesa26.1.6-llvm21.1.8-x86_64-sse4.1",
               "2d57f167b09a2189fd2cd16c7c7b081262fe934ad31fef465570fcdd0a150112",
               "Debian forky of November 2026, whose Mesa rounds differently"},
};

}  // namespace

std::span<const KnownFrame> knownFrames() { return kKnownFrames; }

Result<Cell> testCell() {
  const char* name = "self-test.urdf";
  const FileSearch nowhere;
  MeshStore meshes(nowhere, /*geometry=*/true);
  Cell cell;
  cell.file = name;
  auto model = readUrdf(ByteView(rocinante_self_test_model, rocinante_self_test_model_end), name,
                        meshes, cell.faults);
  if (!model) return Error{ErrorKind::damaged, "the built-in model cannot be read", name};
  cell.models[name] = std::make_shared<const Model>(std::move(*model));
  CellDevice device;
  device.name = "arm";
  device.model = name;
  cell.devices.push_back(std::move(device));
  CellCamera camera;
  camera.name = "view";
  camera.eye = {2.3, -3.1, 1.9};
  camera.target = {0.35, 0.1, 0.7};
  camera.fov_deg = 40;
  cell.cameras.push_back(std::move(camera));
  return cell;
}

FrameRequest testFrameRequest() {
  FrameRequest request;
  request.camera = "view";
  request.width = 192;
  request.height = 144;
  request.style.shadows = true;
  return request;
}

Result<Picture> referenceFrame() {
  return decodePng(ByteView(rocinante_self_test_frame, rocinante_self_test_frame_end), "frame.png");
}

ByteView testPictureFile() {
  return ByteView(rocinante_self_test_picture, rocinante_self_test_picture_end);
}

}  // namespace rocinante
