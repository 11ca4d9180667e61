#pragma once

namespace rocinante {

/// Mesa keeps compiled shaders in a file that it maps, made in MESA_SHADER_CACHE_DIR,
/// XDG_CACHE_HOME or ~/.cache. On a full disk its first write there would end the process by
/// SIGBUS, so that less than 8 MB left there switches the cache off, in the environment. To be
/// called before the first context is made, and before threads.
void avoidShaderCacheOnFullDisk();

}  // namespace rocinante
