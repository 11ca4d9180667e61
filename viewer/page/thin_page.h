#pragma once

#include <cstddef>
#include <string>

#include "core/cell/cell.h"
#include "viewer/page/page_file.h"
#include "viewer/page/page_job.h"

namespace rocinante {

/// The page of these parts with a smaller cell, the largest of a few steps with which it has at
/// most `job.most_bytes`: pictures of half the size, and half of the triangles, by turns. The last
/// step's page when none is small enough. Sets the cell of `parts`, and what it lacks;
/// `whole_bytes` is the size of the page with the whole cell.
std::string thinPage(const Cell& cell, const PageJob& job, std::size_t whole_bytes,
                     PageParts& parts);

}  // namespace rocinante
