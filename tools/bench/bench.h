// gridbench's subcommands: each adds itself with its options to the command line, and a callback that runs
// it.
#pragma once

#include "tools/common/command_line.h"

namespace masu {

void add_frame(const CommandLine& command);
void add_rays(const CommandLine& command);
void add_tradeoff(const CommandLine& command);
void add_stability(const CommandLine& command);
void add_oracle(const CommandLine& command);
void add_crossings(const CommandLine& command);
void add_difference(const CommandLine& command);

} // namespace masu
