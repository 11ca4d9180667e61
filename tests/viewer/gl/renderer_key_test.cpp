#include "viewer/gl/renderer_key.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <string_view>

namespace rocinante {
namespace {

TEST(RendererKey, NamesLlvmpipeWithItsVersions) {
  const RendererKey key = parseRendererKey("llvmpipe (LLVM 15.0.6, 128 bits)",
                                           "3.3 (Core Profile) Mesa 22.3.6", "sse4.1");
  EXPECT_EQ(key.text(), "llvmpipe-mesa22.3.6-llvm15.0.6-" + key.architecture + "-sse4.1");
}

/// llvmpipe as it would call itself on another machine.
RendererKey llvmpipeOn(const std::string& architecture, const std::string& caps) {
  RendererKey key =
      parseRendererKey("llvmpipe (LLVM 15.0.6, 128 bits)", "3.3 (Core Profile) Mesa 22.3.6", caps);
  key.architecture = architecture;
  return key;
}

TEST(RendererKey, EachArchitectureHasItsOwnPin) {
  EXPECT_TRUE(requireReproducible(llvmpipeOn("x86_64", "sse2")).has_value());
  EXPECT_FALSE(requireReproducible(llvmpipeOn("x86_64", "none")).has_value());
  // Nothing to choose there: the key says so by having no such part.
  const RendererKey arm = llvmpipeOn("aarch64", "none");
  EXPECT_EQ(arm.text(), "llvmpipe-mesa22.3.6-llvm15.0.6-aarch64");
  EXPECT_TRUE(requireReproducible(arm).has_value());
  for (const char* caps : {"", "sse4.1"}) {
    const Status fit = requireReproducible(llvmpipeOn("aarch64", caps));
    ASSERT_FALSE(fit.has_value()) << caps;
    EXPECT_NE(fit.error().what.find("LP_NATIVE_VECTOR_WIDTH=128"), std::string::npos);
  }
  EXPECT_EQ(llvmpipeOn("aarch64", "").text(), "llvmpipe-mesa22.3.6-llvm15.0.6-aarch64-native");
  // Where nobody has looked whether all processors draw the same, none is promised to.
  const Status unknown = requireReproducible(llvmpipeOn("riscv64", "none"));
  ASSERT_FALSE(unknown.has_value());
  EXPECT_EQ(unknown.error().kind, ErrorKind::refused);
  EXPECT_NE(unknown.error().what.find("riscv64"), std::string::npos);
}

TEST(RendererKey, APackagesRevisionIsNoPartOfIt) {
  // GL_VERSION of Debian 13, of Ubuntu 24.04 and of Arch.
  for (const char* version : {"4.5 (Core Profile) Mesa 25.0.7-2+deb13u1", "3.3 Mesa 25.0.7-2",
                              "3.3 Mesa 25.0.7-1ubuntu0.24.04.2~bpo1", "3.3 Mesa 25.0.7-arch1.1"}) {
    const RendererKey key =
        parseRendererKey("llvmpipe (LLVM 19.1.7-3+b1, 128 bits)", version, "sse4.1");
    EXPECT_EQ(key.text(), "llvmpipe-mesa25.0.7-llvm19.1.7-" + key.architecture + "-sse4.1");
  }
}

TEST(RendererKey, WhatUpstreamCallsAnotherVersionIsAnotherKey) {
  for (const auto& [version, kept] :
       {std::pair("Mesa 26.0.0-rc2", "26.0.0-rc2"), std::pair("Mesa 26.0.0-rc2-1", "26.0.0-rc2"),
        std::pair("Mesa 26.1.0-devel (git-0123456789)", "26.1.0-devel"),
        std::pair("Mesa 26.1.6", "26.1.6"), std::pair("Mesa -2", ""), std::pair("Mesa", "")}) {
    EXPECT_EQ(parseRendererKey("llvmpipe", version, "sse4.1").mesa, kept) << version;
  }
}

TEST(RendererKey, KeysThatCarryARevisionLoseIt) {
  for (const auto& [old, now] :
       {std::pair("llvmpipe-mesa25.0.7-2+deb13u1-llvm19.1.7-x86_64-sse4.1 640x480 4x",
                  "llvmpipe-mesa25.0.7-llvm19.1.7-x86_64-sse4.1 640x480 4x"),
        std::pair("llvmpipe-mesa22.3.6-llvm15.0.6-x86_64-sse4.1 640x480 4x",
                  "llvmpipe-mesa22.3.6-llvm15.0.6-x86_64-sse4.1 640x480 4x"),
        std::pair("Mesa_Intel_R_UHD-mesa24.2.8-1-x86_64-native",
                  "Mesa_Intel_R_UHD-mesa24.2.8-x86_64-native"),
        std::pair("4090-x86_64-native 16x16 1x", "4090-x86_64-native 16x16 1x"),
        std::pair("a-rc1-7 1x1 1x -2", "a-rc1 1x1 1x -2"), std::pair("", ""), std::pair("-", "-"),
        std::pair("a--2-", "a--")}) {
    EXPECT_EQ(withoutPackageRevisions(old), now);
    EXPECT_EQ(withoutPackageRevisions(now), now);
  }
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
    EXPECT_FALSE(requireReproducible(llvmpipeOn("x86_64", caps)).has_value()) << caps;
  }
  EXPECT_FALSE(
      requireReproducible(parseRendererKey("softpipe", "3.3 Mesa 22.3.6", "sse4.1")).has_value());
}

TEST(PinRendererEnvironment, PinsClearsAndKeepsTheThreadCount) {
  ::setenv("LP_DEBUG", "tex", 1);
  ::setenv("GALLIUM_DRIVER", "softpipe", 1);
  ::setenv("MESA_GL_VERSION_OVERRIDE", "2.1", 1);
  ::setenv("LIBGL_ALWAYS_INDIRECT", "1", 1);
  const char* const more[] = {
      "GALLIVM_PERF", "GALLIVM_DEBUG", "DRAW_USE_LLVM", "DRAW_FSE",           "TGSI_PRINT_SANITY",
      "NIR_DEBUG",    "ST_DEBUG",      "EGL_PLATFORM",  "force_glsl_version", "mesa_glthread"};
  for (const char* name : more) ::setenv(name, "1", 1);
  ::setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nowhere/10_nvidia.json", 1);
  ::setenv("__EGL_VENDOR_LIBRARY_DIRS", "/nowhere", 1);
  ::setenv("LP_NUM_THREADS", "2", 1);
  ::setenv("MESALIKE", "mine", 1);
  ::setenv("DRAWER", "mine too", 1);
  ::setenv("DRIRC_CONFIGDIR", "/home", 1);
  ::setenv("http_proxy", "http://mine", 1);
  pinRendererEnvironment("sse2");
  EXPECT_STREQ(::getenv("GALLIUM_OVERRIDE_CPU_CAPS"), "sse2");
  EXPECT_STREQ(::getenv("GALLIUM_DRIVER"), "llvmpipe");
  EXPECT_STREQ(::getenv("LIBGL_ALWAYS_SOFTWARE"), "1");
  EXPECT_STREQ(::getenv("LP_NATIVE_VECTOR_WIDTH"), "128");
  EXPECT_EQ(::getenv("LP_DEBUG"), nullptr);
  EXPECT_EQ(::getenv("MESA_GL_VERSION_OVERRIDE"), nullptr);
  EXPECT_EQ(::getenv("LIBGL_ALWAYS_INDIRECT"), nullptr);
  for (const char* name : more) EXPECT_EQ(::getenv(name), nullptr) << name;
  EXPECT_EQ(::getenv("__EGL_VENDOR_LIBRARY_DIRS"), nullptr);
  // Mesa's own, or where that lies elsewhere what libEGL finds by itself.
  const char* vendor = ::getenv("__EGL_VENDOR_LIBRARY_FILENAMES");
  EXPECT_TRUE(vendor == nullptr || std::string_view(vendor).ends_with("/50_mesa.json"));
  EXPECT_STREQ(::getenv("LP_NUM_THREADS"), "2");
  EXPECT_STREQ(::getenv("MESALIKE"), "mine");
  EXPECT_STREQ(::getenv("DRAWER"), "mine too");
  EXPECT_STREQ(::getenv("http_proxy"), "http://mine");
  EXPECT_STREQ(::getenv("DRIRC_CONFIGDIR"), "/nonexistent");
  ::unsetenv("LP_NUM_THREADS");
  ::unsetenv("MESALIKE");
  ::unsetenv("DRAWER");
  ::unsetenv("http_proxy");
  pinRendererEnvironment();
}

}  // namespace
}  // namespace rocinante
