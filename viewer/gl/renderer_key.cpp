#include "viewer/gl/renderer_key.h"

#include <stdlib.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>
#include <vector>

#include "viewer/gl/hidden_drirc.h"
#include "viewer/gl/shader_cache.h"

namespace rocinante {
namespace {

/// The text after `word` up to a space, comma or parenthesis; empty when `word` is missing.
std::string after(const std::string& text, std::string_view word) {
  const std::size_t at = text.find(word);
  if (at == std::string::npos) return {};
  const std::size_t from = at + word.size();
  return text.substr(from, text.find_first_of(" ,()", from) - from);
}

/// Debian's revisions begin with a digit, Arch's with "arch".
bool isPackageRevision(std::string_view part) {
  if (part.starts_with("arch")) part.remove_prefix(4);
  return !part.empty() && part.front() >= '0' && part.front() <= '9';
}

/// Mesa's drivers read each drirc option as an environment variable too, all in lower case:
/// "force_glsl_version". No variable of ours has such a name.
bool mayBeDrircOption(std::string_view name) {
  const bool is_lower = std::ranges::all_of(
      name, [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; });
  return is_lower && name.find('_') != name.npos && !name.ends_with("_proxy");
}

bool isRendererVariable(std::string_view name) {
  constexpr std::array<std::string_view, 12> kPrefixes{
      "LP_",  "GALLIUM_", "GALLIVM_", "DRAW_", "MESA_",         "LIBGL_",
      "NIR_", "TGSI_",    "ST_DEBUG", "EGL_",  "__EGL_VENDOR_", "DRIRC_"};
  if (name == "LP_NUM_THREADS") return false;
  if (mayBeDrircOption(name)) return true;
  for (const std::string_view prefix : kPrefixes) {
    if (name.starts_with(prefix)) return true;
  }
  return false;
}

/// The pin disables newer CPU features and cannot add missing ones. SSSE3 to SSE4.2 draw the same
/// bits (emulated core2duo to Westmere), older processors different ones (Opteron_G3).
bool processorDrawsAsSse41() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("ssse3") != 0;
#else
  return true;  // the architecture is part of the key
#endif
}

constexpr std::string_view kNoCaps = "none";

/// The CPU features pinned by the environment; empty without the pin. On architectures without that
/// choice, the pinned vector width shows it.
std::string pinnedCaps() {
#if defined(__x86_64__)
  const char* caps = ::getenv("GALLIUM_OVERRIDE_CPU_CAPS");
  return caps == nullptr ? "" : caps;
#else
  const char* width = ::getenv("LP_NATIVE_VECTOR_WIDTH");
  return width == nullptr || std::string_view(width) != "128" ? std::string()
                                                              : std::string(kNoCaps);
#endif
}

/// libglvnd's file for Mesa, at its default place. Of several vendors the first one with a
/// surfaceless display would draw, which may be a GPU's.
const char* mesaVendorFile() {
  for (const char* file :
       {"/etc/glvnd/egl_vendor.d/50_mesa.json", "/usr/share/glvnd/egl_vendor.d/50_mesa.json"}) {
    if (::access(file, R_OK) == 0) return file;
  }
  return nullptr;
}

/// A renderer's name as part of a file name: names of GPUs have spaces and slashes.
std::string fileNameOf(const std::string& name) {
  std::string safe;
  for (const char c : name) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       c == '.' || c == '_';
    if (plain) {
      safe += c;
    } else if (!safe.empty() && safe.back() != '_') {
      safe += '_';
    }
  }
  return safe.empty() ? "unknown" : safe;
}

}  // namespace

const std::vector<std::string>& pinnableCaps() {
#if defined(__x86_64__)
  static const std::vector<std::string> kCaps{"sse4.1", "sse2"};
#else
  static const std::vector<std::string> kCaps{std::string(kNoCaps)};
#endif
  return kCaps;
}

void pinRendererEnvironment(const std::string& caps) {
  std::vector<std::string> doomed;
  for (char** entry = environ; entry != nullptr && *entry != nullptr; ++entry) {
    const std::string_view text(*entry);
    const std::string_view name = text.substr(0, text.find('='));
    if (isRendererVariable(name)) doomed.emplace_back(name);
  }
  for (const std::string& name : doomed) ::unsetenv(name.c_str());
  if (caps != kNoCaps) ::setenv("GALLIUM_OVERRIDE_CPU_CAPS", caps.c_str(), 1);
  ::setenv("GALLIUM_DRIVER", "llvmpipe", 1);
  ::setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
  ::setenv("LP_NATIVE_VECTOR_WIDTH", "128", 1);
  // A missing folder: from Mesa 23 on no drirc of the system is read, and ~/.drirc is hidden too.
  ::setenv("DRIRC_CONFIGDIR", kNoDrircFolder, 1);
  // What Mesa takes from HOME, which is hidden from it: the place of its cache of shaders.
  const char* const home = ::getenv("HOME");
  if (::getenv("XDG_CACHE_HOME") == nullptr && home != nullptr && *home == '/') {
    ::setenv("XDG_CACHE_HOME", (std::string(home) + "/.cache").c_str(), 1);
  }
  if (const char* file = mesaVendorFile()) ::setenv("__EGL_VENDOR_LIBRARY_FILENAMES", file, 1);
  avoidShaderCacheOnFullDisk();
}

std::string RendererKey::text() const {
  std::string key = fileNameOf(renderer);
  if (!mesa.empty()) key += "-mesa" + mesa;
  if (!llvm.empty()) key += "-llvm" + llvm;
  key += "-" + architecture;
  return caps == kNoCaps ? key : key + "-" + caps;
}

RendererKey parseRendererKey(const std::string& renderer, const std::string& version,
                             const std::string& caps) {
  RendererKey key;
  // "llvmpipe (LLVM 15.0.6, 128 bits)", "Mesa Intel(R) UHD Graphics 620 (KBL GT2)"
  key.renderer = renderer.starts_with("llvmpipe") ? "llvmpipe" : renderer;
  key.llvm = withoutPackageRevisions(after(renderer, "LLVM "));
  key.mesa = withoutPackageRevisions(after(version, "Mesa "));
  utsname machine{};
  key.architecture = ::uname(&machine) == 0 ? machine.machine : "unknown";
  key.caps = caps.empty() ? "native" : caps;
  return key;
}

std::string withoutPackageRevisions(std::string_view text) {
  const std::size_t end =
      std::min(text.find(' '), text.size());  // the size follows in a golden's key
  std::string kept;
  for (std::size_t at = 0; at <= end;) {
    const std::size_t next = std::min(text.find('-', at), end);
    const std::string_view part = text.substr(at, next - at);
    if (at == 0) {
      kept = part;
    } else if (!isPackageRevision(part)) {
      kept.append("-").append(part);
    }
    at = next + 1;
  }
  return kept.append(text.substr(end));
}

RendererKey rendererKey(const GlTable& gl) {
  const auto text = [&](GLenum name) {
    const auto* value = reinterpret_cast<const char*>(gl.GetString(name));
    return std::string(value == nullptr ? "" : value);
  };
  return parseRendererKey(text(GL_RENDERER), text(GL_VERSION), pinnedCaps());
}

Status requireReproducible(const RendererKey& key) {
  if (key.renderer != "llvmpipe") {
    return Error{ErrorKind::refused,
                 "the reproducible profile needs Mesa's llvmpipe, but this renderer is \"" +
                     key.renderer + "\"",
                 {}};
  }
  if (key.architecture == "aarch64") {
    if (key.caps == kNoCaps) return {};
    return Error{ErrorKind::refused,
                 "the reproducible profile needs LP_NATIVE_VECTOR_WIDTH=128 set before the first "
                 "context; it was not",
                 {}};
  }
  if (key.architecture != "x86_64") {
    return Error{ErrorKind::refused,
                 "the reproducible profile draws the same bits only on x86_64 and aarch64, but "
                 "this machine is \"" +
                     key.architecture + "\": --profile fast draws on any",
                 {}};
  }
  if (key.caps != "sse4.1" && key.caps != "sse2") {
    return Error{ErrorKind::refused,
                 "the reproducible profile needs GALLIUM_OVERRIDE_CPU_CAPS set before the first "
                 "context, but it is " +
                     (key.caps == "native" ? std::string("unset") : "\"" + key.caps + "\""),
                 {}};
  }
  if (key.caps == "sse4.1" && !processorDrawsAsSse41()) {
    return Error{ErrorKind::refused,
                 "this processor lacks SSSE3, so it cannot draw the bits of sse4.1; --caps sse2 "
                 "draws bits that every x86-64 machine can",
                 {}};
  }
  return {};
}

}  // namespace rocinante
