// gridbench's subcommands: each adds itself with its options to the command line, and a callback that runs
// it.
#pragma once

#include <CLI/CLI.hpp>

namespace masu {

void add_frame(CLI::App& app);
void add_rays(CLI::App& app);
void add_lists(CLI::App& app);
void add_scale(CLI::App& app);
void add_load(CLI::App& app);
void add_refit(CLI::App& app);
void add_tradeoff(CLI::App& app);
void add_stability(CLI::App& app);
void add_oracle(CLI::App& app);
void add_crossings(CLI::App& app);
void add_difference(CLI::App& app);

} // namespace masu
