// What --help prints, and what a tool says of an option that it doesn't have.
#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace masu {

// Options that follow are under this heading of --help.
inline void group_options(CLI::App& app, const std::string& heading) {
  app.option_defaults()->group(heading);
}

// The text of --help: description, usage, options by group, the footer and the man page's name. Lines are as
// wide as the terminal, or 80 columns where there is none; words aren't broken. For CLI::App::formatter_fn().
std::string help_text(const CLI::App* app, const std::string& name, CLI::AppFormatMode mode);

// The error of the first option that was given and that neither `app` nor its subcommand has, with the
// nearest one that they have: "--thread: unknown option: did you mean --threads?". `command` is whose help
// lists them. Empty where all are known.
std::string unknown_option(const CLI::App& app, const std::string& command);

} // namespace masu
