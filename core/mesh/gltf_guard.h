#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace rocinante {

/// What is wrong with a glTF document, in a sentence without its place; empty when every index,
/// length and type that the reader follows is sound: bufferViews lie in buffers, accessors in
/// bufferViews, nodes form trees that are not too deep. Refuses other versions than 2 and required
/// extensions that are not read. `binary_bytes` is the size of a .glb's binary chunk.
std::string problemOfGltf(const nlohmann::json& root, std::size_t binary_bytes);

}  // namespace rocinante
