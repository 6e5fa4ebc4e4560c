// Which GPUs a rank traces on.
#pragma once

#include "tools/common/tracing_options.h"
#include "tools/jobs/ranks.h"

#include <vector>

namespace masu {

// The GPUs to trace on, or none for the CPU. Throws Error(usage) for what isn't a list of GPUs and for
// options that contradict each other, Error(device) for GPUs that are named and aren't there.
//
// Collective. Ranks of one machine share its GPUs out: by default all of them. Where they are chosen
// automatically, all ranks trace on GPUs, or all on CPUs.
std::vector<int> gpus_of(const DeviceChoice& choice, Ranks& ranks);

} // namespace masu
