// What gridrender and gridtrace share: a scene and its grid, where and how rays are traced, by which
// processes, and the reports of it.
#pragma once

#include "libgrid/file/structure_file.h"
#include "libscene/file/file_mapping.h"
#include "renderer/tracer/tracer.h"
#include "tools/common/tracing_options.h"
#include "tools/jobs/parted_file.h"
#include "tools/jobs/ranks.h"
#include "tools/jobs/tracing_report.h"

#include <nlohmann/json_fwd.hpp>

#include <memory>
#include <vector>

namespace masu {

// The limit of --threads, else the cores that this process may use, or its share of the machine's where ranks
// may use all; in force while the result lives.
ThreadLimit limit_threads(const TracingOptions& options, const Ranks& ranks);

// The GPUs to trace on, or none for the CPU. Throws Error(usage) for what isn't a list of GPUs and for
// options that contradict each other, Error(device) for GPUs that are named and aren't there.
//
// Collective. Ranks of one machine share its GPUs out: by default all of them. Where they are chosen
// automatically, all ranks trace on GPUs, or all on CPUs.
std::vector<int> gpus_of(const TracingOptions& options, Ranks& ranks);

// The scene and the grid, and what traces rays through them.
struct OpenedScene {
  // wanted_gpus: none for the CPU. Throws as SceneFile, StructureFile and ResidentTracer do.
  OpenedScene(const char* tool, const TracingOptions& options, const std::vector<int>& wanted_gpus);

  nlohmann::ordered_json hashes() const; // {scene_hash, grid_hash}: null without a grid
  // Of both files together.
  double load_seconds(double LoadSeconds::*part) const {
    return scene.load_seconds().*part + (grid ? grid->load_seconds().*part : 0);
  }

  const MappingFaults faults;
  const std::vector<int> gpus;
  const SceneFile scene;
  const std::unique_ptr<const StructureFile> grid; // none with --brute-force
  const ResidentTracer tracer;
};

// What --resume keeps: Resume::all unless the file of --stats or --times is there and says that the last
// run's scene or command was another one. By any rank; rank 0's counts.
Resume resume_of(const TracingOptions& options, const OpenedScene& opened);

// Writes --stats and --times, and the lines that say what was kept and traced unless `quiet`. Where all was
// kept, a report of it that is there is kept, too. By rank 0.
void write_reports(const char* tool, const TracingOptions& options, const OpenedScene& opened,
                   const Ranks& ranks, const TracingReport& report, bool quiet);

} // namespace masu
