// What gridrender and gridtrace share: a scene and its grid, where and how rays are traced, by which
// processes, and the reports of it.
#pragma once

#include "libgrid/file/structure_file.h"
#include "libscene/file/file_mapping.h"
#include "renderer/tracer/tracer.h"
#include "tools/common/tracing_options.h"
#include "tools/jobs/gpus.h"
#include "tools/jobs/kept_file.h"
#include "tools/jobs/ranks.h"
#include "tools/jobs/tracing_report.h"

#include <nlohmann/json_fwd.hpp>

#include <memory>
#include <vector>

namespace masu {

// The limit of --threads, else the cores that this process may use, or its share of the machine's where ranks
// may use all; in force while the result lives.
ThreadLimit limit_threads(const TracingOptions& options, const Ranks& ranks);

// The scene and the grid, and what traces rays through them.
class OpenedScene {
public:
  // gpus: none for the CPU. Throws as SceneFile, StructureFile and ResidentTracer do.
  OpenedScene(const char* tool, const TracingOptions& options, const std::vector<int>& gpus);

  const SceneFile& scene() const { return scene_; }
  const ResidentTracer& tracer() const { return tracer_; }
  const std::vector<int>& gpus() const { return gpus_; }
  nlohmann::ordered_json hashes() const; // {scene_hash, grid_hash}: null without a grid
  // Of both files together.
  double load_seconds(double LoadSeconds::*part) const {
    return scene_.load_seconds().*part + (grid_ ? grid_->load_seconds().*part : 0);
  }

private:
  const MappingFaults faults_;
  const std::vector<int> gpus_;
  const SceneFile scene_;
  const std::unique_ptr<const StructureFile> grid_; // none with --brute-force
  const ResidentTracer tracer_;
};

// What --resume keeps: Resume::all unless the file of --stats or --times is there and says that the last
// run's scene or command was another one. By any rank; rank 0's counts.
Resume resume_of(const TracingOptions& options, const OpenedScene& opened);

// Writes --stats and --times, and the lines that say what was kept and traced unless `quiet`. Where all was
// kept, a report of it that is there is kept, too. By rank 0.
void write_reports(const char* tool, const TracingOptions& options, const OpenedScene& opened,
                   const Ranks& ranks, const TracingReport& report, bool quiet);

} // namespace masu
