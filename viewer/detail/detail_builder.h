#pragma once

#include <memory>
#include <vector>

#include "viewer/detail/detail_cache.h"
#include "viewer/detail/mesh_detail.h"

namespace rocinante {

/// The detail of the mesh that was input number `number`.
struct ReadyDetail {
  std::size_t number = 0;
  MeshDetail detail;
};

/// Makes the detail of many meshes in threads of its own, of low priority, so that no frame waits
/// for it: from the cache where it is there, else anew. Who draws asks now and then what is ready.
class DetailBuilder {
 public:
  /// Starts at once, the largest meshes first. What the inputs borrow must outlive the builder.
  DetailBuilder(std::vector<DetailInput> inputs, DetailCache cache, int threads);
  /// Waits for the meshes in work, and begins no other.
  ~DetailBuilder();
  DetailBuilder(const DetailBuilder&) = delete;
  DetailBuilder& operator=(const DetailBuilder&) = delete;

  /// What became ready since the last call; each mesh once. Does not wait. One caller.
  std::vector<ReadyDetail> takeReady();
  /// The same, when all the rest is ready.
  std::vector<ReadyDetail> waitForAll();
  /// All that there is has been taken.
  bool finished() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rocinante
