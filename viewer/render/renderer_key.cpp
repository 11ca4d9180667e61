#include "viewer/render/renderer_key.h"

#include <stdlib.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <string_view>
#include <vector>

namespace rocinante {
namespace {

/// What follows `word` up to a space, comma or parenthesis; empty when it is not there.
std::string after(const std::string& text, std::string_view word) {
  const std::size_t at = text.find(word);
  if (at == std::string::npos) return {};
  const std::size_t from = at + word.size();
  return text.substr(from, text.find_first_of(" ,()", from) - from);
}

bool isRendererVariable(std::string_view name) {
  constexpr std::array<std::string_view, 9> kPrefixes{
      "LP_", "GALLIUM_", "GALLIVM_", "DRAW_", "MESA_", "LIBGL_", "NIR_", "TGSI_", "ST_DEBUG"};
  if (name == "LP_NUM_THREADS") return false;
  for (const std::string_view prefix : kPrefixes) {
    if (name.starts_with(prefix)) return true;
  }
  return false;
}

/// The pin takes away what a processor has beyond it and cannot add what is missing. SSSE3 to
/// SSE4.2 draw the same bits (emulated core2duo to Westmere), those before others (Opteron_G3).
bool processorDrawsAsSse41() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("ssse3") != 0;
#else
  return true;  // the architecture is part of the key
#endif
}

/// A renderer's name as part of a file name: GPUs have spaces and slashes in theirs.
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

void pinRendererEnvironment(const std::string& caps) {
  std::vector<std::string> doomed;
  for (char** entry = environ; entry != nullptr && *entry != nullptr; ++entry) {
    const std::string_view text(*entry);
    const std::string_view name = text.substr(0, text.find('='));
    if (isRendererVariable(name)) doomed.emplace_back(name);
  }
  for (const std::string& name : doomed) ::unsetenv(name.c_str());
  ::setenv("GALLIUM_OVERRIDE_CPU_CAPS", caps.c_str(), 1);
  ::setenv("GALLIUM_DRIVER", "llvmpipe", 1);
  ::setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
  ::setenv("LP_NATIVE_VECTOR_WIDTH", "128", 1);
}

std::string RendererKey::text() const {
  std::string key = fileNameOf(renderer);
  if (!mesa.empty()) key += "-mesa" + mesa;
  if (!llvm.empty()) key += "-llvm" + llvm;
  return key + "-" + architecture + "-" + caps;
}

RendererKey parseRendererKey(const std::string& renderer, const std::string& version,
                             const std::string& caps) {
  RendererKey key;
  // "llvmpipe (LLVM 15.0.6, 128 bits)", "Mesa Intel(R) UHD Graphics 620 (KBL GT2)"
  key.renderer = renderer.starts_with("llvmpipe") ? "llvmpipe" : renderer;
  key.llvm = after(renderer, "LLVM ");
  key.mesa = after(version, "Mesa ");
  utsname machine{};
  key.architecture = ::uname(&machine) == 0 ? machine.machine : "unknown";
  key.caps = caps.empty() ? "native" : caps;
  return key;
}

RendererKey rendererKey(const GlTable& gl) {
  const auto text = [&](GLenum name) {
    const auto* value = reinterpret_cast<const char*>(gl.GetString(name));
    return std::string(value == nullptr ? "" : value);
  };
  const char* caps = ::getenv("GALLIUM_OVERRIDE_CPU_CAPS");
  return parseRendererKey(text(GL_RENDERER), text(GL_VERSION), caps == nullptr ? "" : caps);
}

Status requireReproducible(const RendererKey& key) {
  if (key.renderer != "llvmpipe") {
    return Error{
        ErrorKind::refused,
        "the reproducible profile needs Mesa's llvmpipe, and this renderer calls itself \"" +
            key.renderer + "\"",
        {}};
  }
  if (key.caps != "sse4.1" && key.caps != "sse2") {
    return Error{ErrorKind::refused,
                 "the reproducible profile needs GALLIUM_OVERRIDE_CPU_CAPS pinned before the first "
                 "context, and it is " +
                     (key.caps == "native" ? std::string("unset") : "\"" + key.caps + "\""),
                 {}};
  }
  if (key.caps == "sse4.1" && !processorDrawsAsSse41()) {
    return Error{ErrorKind::refused,
                 "this processor is older than SSSE3 and would draw other bits than sse4.1 stands "
                 "for: --caps sse2 draws those that every x86-64 machine can",
                 {}};
  }
  return {};
}

}  // namespace rocinante
