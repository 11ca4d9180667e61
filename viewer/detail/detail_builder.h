#pragma once

#include <memory>
#include <vector>

#include "viewer/detail/detail_cache.h"
#include "viewer/detail/mesh_detail.h"

namespace rocinante {

/// The detail of input mesh `number`.
struct ReadyDetail {
  std::size_t number = 0;
  MeshDetail detail;
};

/// Makes the detail of many meshes in low-priority threads, from the cache or anew, so that frames
/// do not wait for it. The drawing thread polls for results.
class DetailBuilder {
 public:
  /// Starts immediately with the largest meshes. The inputs' borrowed data must outlive the
  /// builder.
  DetailBuilder(std::vector<DetailInput> inputs, DetailCache cache, int threads);
  /// Waits for the meshes in progress and starts no others.
  ~DetailBuilder();
  DetailBuilder(const DetailBuilder&) = delete;
  DetailBuilder& operator=(const DetailBuilder&) = delete;

  /// Details that became ready since the last call, each mesh once. Does not wait. For one calling
  /// thread.
  std::vector<ReadyDetail> takeReady();
  /// Waits for all remaining details.
  std::vector<ReadyDetail> waitForAll();
  /// True when all details have been taken.
  bool finished() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rocinante
