#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/model_search.h"
#include "core/base/parallel_for.h"
#include "core/base/result.h"
#include "core/net/endpoint.h"
#include "viewer/serve/web_server.h"

namespace rocinante {

struct ServeRequest : ModelSearch {
  std::filesystem::path cell;  ///< or a log that carries one
  std::filesystem::path log;   ///< empty: live
  std::vector<Endpoint> live;  ///< empty: the log
  std::filesystem::path
      viewer;  ///< folder of what scripts/build_web made; empty: the installed one
  std::filesystem::path trust, decoders;  ///< of live sessions; may be empty
  double rate_hz = 60;
  WebServer::Options web;
  ParallelFor parallel;
};

struct ServeReport {
  WebServer::Counts web;
  std::uint64_t received = 0, lost = 0;  ///< datagrams
};

/// Says lines while it runs; asked whether to stop.
struct ServeSurroundings {
  std::function<void(std::string_view)> notify;  ///< also from another thread
  std::function<bool()> stop;
};

/// Serves a page until it is stopped (docs/programs/serve.md).
Result<ServeReport> serveUntilStopped(const ServeRequest& request,
                                      const ServeSurroundings& surroundings);

}  // namespace rocinante
