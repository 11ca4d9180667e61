#include "viewer/render/renderer_key.h"

#include <gtest/gtest.h>
#include <stdlib.h>

namespace rocinante {
namespace {

TEST(RendererKey, NamesLlvmpipeWithItsVersions) {
  const RendererKey key = parseRendererKey("llvmpipe (LLVM 15.0.6, 128 bits)",
                                           "3.3 (Core Profile) Mesa 22.3.6", "sse4.1");
  EXPECT_EQ(key.text(), "llvmpipe-mesa22.3.6-llvm15.0.6-" + key.architecture + "-sse4.1");
  EXPECT_TRUE(requireReproducible(key).has_value());
}

TEST(RendererKey, AGpuIsNativeAndNotReproducible) {
  const RendererKey key = parseRendererKey("NVIDIA RTX A2000/PCIe/SSE2", "4.6.0 NVIDIA 535.1", "");
  EXPECT_EQ(key.text(), "NVIDIA_RTX_A2000_PCIe_SSE2-" + key.architecture + "-native");
  const Status fit = requireReproducible(key);
  ASSERT_FALSE(fit.has_value());
  EXPECT_EQ(fit.error().kind, ErrorKind::refused);
  EXPECT_NE(fit.error().what.find("NVIDIA RTX A2000/PCIe/SSE2"), std::string::npos);
}

TEST(RendererKey, UnpinnedOrWronglyPinnedLlvmpipeIsRefused) {
  for (const char* caps : {"", "avx", "sse4.1,avx"}) {
    EXPECT_FALSE(requireReproducible(
                     parseRendererKey("llvmpipe (LLVM 15.0.6, 256 bits)", "3.3 Mesa 22.3.6", caps))
                     .has_value());
  }
  EXPECT_FALSE(
      requireReproducible(parseRendererKey("softpipe", "3.3 Mesa 22.3.6", "sse4.1")).has_value());
}

TEST(PinRendererEnvironment, PinsClearsAndKeepsTheThreadCount) {
  ::setenv("LP_DEBUG", "tex", 1);
  ::setenv("GALLIUM_DRIVER", "softpipe", 1);
  ::setenv("MESA_GL_VERSION_OVERRIDE", "2.1", 1);
  ::setenv("LIBGL_ALWAYS_INDIRECT", "1", 1);
  const char* const more[] = {"GALLIVM_PERF",      "GALLIVM_DEBUG", "DRAW_USE_LLVM", "DRAW_FSE",
                              "TGSI_PRINT_SANITY", "NIR_DEBUG",     "ST_DEBUG"};
  for (const char* name : more) ::setenv(name, "1", 1);
  ::setenv("LP_NUM_THREADS", "2", 1);
  ::setenv("MESALIKE", "mine", 1);
  ::setenv("DRAWER", "mine too", 1);
  pinRendererEnvironment("sse2");
  EXPECT_STREQ(::getenv("GALLIUM_OVERRIDE_CPU_CAPS"), "sse2");
  EXPECT_STREQ(::getenv("GALLIUM_DRIVER"), "llvmpipe");
  EXPECT_STREQ(::getenv("LIBGL_ALWAYS_SOFTWARE"), "1");
  EXPECT_STREQ(::getenv("LP_NATIVE_VECTOR_WIDTH"), "128");
  EXPECT_EQ(::getenv("LP_DEBUG"), nullptr);
  EXPECT_EQ(::getenv("MESA_GL_VERSION_OVERRIDE"), nullptr);
  EXPECT_EQ(::getenv("LIBGL_ALWAYS_INDIRECT"), nullptr);
  for (const char* name : more) EXPECT_EQ(::getenv(name), nullptr) << name;
  EXPECT_STREQ(::getenv("LP_NUM_THREADS"), "2");
  EXPECT_STREQ(::getenv("MESALIKE"), "mine");
  EXPECT_STREQ(::getenv("DRAWER"), "mine too");
  ::unsetenv("LP_NUM_THREADS");
  ::unsetenv("MESALIKE");
  ::unsetenv("DRAWER");
  pinRendererEnvironment();
}

}  // namespace
}  // namespace rocinante
