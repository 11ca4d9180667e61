#pragma once

#include <vector>

#include "core/self_test/fact.h"
#include "viewer/picture/picture.h"

namespace rocinante {

/// The facts `context`, `key` and `frame`: the renderer, and whether a small frame of a built-in
/// model has the bits known for that renderer. Makes a context: call it once, after
/// pinRendererEnvironment(). `drawn`, when not null, receives the frame.
std::vector<SelfTestFact> drawingFacts(Picture* drawn = nullptr);

/// The fact `pictures`: whether files other than PNG can be read, by reading one. Loads the module,
/// which takes a third of a second.
SelfTestFact picturesFact();

/// The fact `cache`: whether the folder for coarser meshes is writable.
SelfTestFact cacheFact();

/// The fact `frame` for a picture drawn by the renderer with this key.
SelfTestFact judgeTestFrame(const Picture& drawn, const std::string& key);

}  // namespace rocinante
