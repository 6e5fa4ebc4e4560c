// Lists of rays from files and pipes: read, traced and written at the same time, however long they are.
#pragma once

#include "renderer/tracer/tracer.h"
#include "tools/jobs/parted_file.h"
#include "tools/jobs/tracing_report.h"
#include "tools/lists/hit_file.h"
#include "tools/lists/ray_file.h"

#include <string>
#include <vector>

namespace masu {

struct RayListJob {
  std::string rays{};     // a file, or - for standard input (ray_file.h)
  std::string hits{};     // a file, or - for standard output; empty: nothing is written (hit_file.h)
  RayFormat format{};     // of what is numbers alone
  std::string excluded{}; // a file of primitives; empty: nothing is
  std::vector<std::uint32_t> object_masks{}; // RayFilters; empty: every object is hit
  std::vector<HitField> fields{};
  RaysRequest request{};
  int repeat = 1; // of the tracing, whose seconds are the medians' sum
  Resume resume = Resume::off;
};

// Collective (tools/jobs/ranks.h). Shows the share of the list whose hits are written, where it is a file and
// unless `quiet`. With Resume::all hits that are there are kept, and nothing is traced. Throws what RayFile
// throws, Error(usage) where ranks share a list that isn't a file, Error(output), and what
// ResidentTracer::trace() throws.
TracingReport trace_ray_list(const ResidentTracer& tracer, const RayListJob& job, Ranks& ranks, bool quiet);

} // namespace masu
