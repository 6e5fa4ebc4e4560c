// gridbench's subcommands: each adds its options, and does its work when it is the one named.
#pragma once

#include <CLI/CLI.hpp>

namespace masu {

void add_frame(CLI::App& app);
void add_rays(CLI::App& app);
void add_load(CLI::App& app);
void add_tradeoff(CLI::App& app);
void add_stability(CLI::App& app);
void add_oracle(CLI::App& app);

} // namespace masu
