#pragma once

#include <vector>

#include "core/self_test/fact.h"
#include "viewer/picture/picture.h"

namespace rocinante {

/// The facts `context`, `key` and `frame`: what draws here, and whether a small frame of a model
/// that is built in has the bits that are known of its renderer. Makes a context: to be called
/// after pinRendererEnvironment(), once. `drawn`, when not null, becomes that frame.
std::vector<SelfTestFact> drawingFacts(Picture* drawn = nullptr);

/// The fact `pictures`: whether files other than PNG can be read, by reading one. Loads the module,
/// which takes a third of a second.
SelfTestFact picturesFact();

/// The fact `cache`: whether the folder for coarser meshes can be written to.
SelfTestFact cacheFact();

/// The decision of `frame`: `drawn` by the renderer with this key.
SelfTestFact judgeTestFrame(const Picture& drawn, const std::string& key);

}  // namespace rocinante
