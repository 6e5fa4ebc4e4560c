#include "tools/common/help.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <utility>
#include <vector>

namespace masu {
namespace {

constexpr std::size_t names_width = 26; // columns before an option's description

std::size_t terminal_width() {
  winsize size{};
  std::size_t width = 0;
  if (const char* const columns = std::getenv("COLUMNS")) width = std::strtoul(columns, nullptr, 10);
  if (width == 0 && ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0) width = size.ws_col;
  return width == 0 ? 80 : std::clamp<std::size_t>(width, 40, 400);
}

// Columns of UTF-8.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xc0) != 0x80; }));
}

// One paragraph after `lead`, whose lines but the first are indented by `indent`.
std::string wrapped(const std::string& lead, const std::string& paragraph, std::size_t indent,
                    std::size_t width) {
  std::string text = lead;
  std::size_t column = width_of(lead);
  if (column + 2 > indent && !lead.empty()) {
    text += "\n";
    column = 0;
  }
  bool begins = true; // a line
  for (std::size_t next = 0; next < paragraph.size();) {
    const std::size_t end = std::min(paragraph.find(' ', next), paragraph.size());
    const std::string word = paragraph.substr(next, end - next);
    next = end + 1;
    if (!begins && column + 1 + width_of(word) > width) {
      text += "\n";
      column = 0;
      begins = true;
    }
    const std::size_t spaces = !begins ? 1 : indent - std::min(indent, column);
    text += std::string(spaces, ' ') + word;
    column += spaces + width_of(word);
    begins = false;
  }
  return text + "\n";
}

// Lines that begin with a space stand as they are.
std::string wrapped_lines(const std::string& lines, std::size_t width) {
  std::string text;
  for (std::size_t next = 0; next < lines.size();) {
    const std::size_t end = std::min(lines.find('\n', next), lines.size());
    const std::string line = lines.substr(next, end - next);
    text += line.starts_with(' ') ? line + "\n" : wrapped("", line, 0, width);
    next = end + 1;
  }
  return text;
}

// What CLI11 puts after an option's names: a type such as TEXT, or names of values; and after a colon what a
// value is checked for, of which a range in [ ] is kept.
struct Value {
  std::string type, range;
};
Value value_of(const CLI::Option& option) {
  const std::string all = option.get_type_name();
  const std::size_t colon = all.find(':'), from = all.find('['), to = all.find(']');
  Value value{all.substr(0, colon), {}};
  if (value.type == "INT" || value.type == "UINT") value.type = "N";
  if (value.type == "FLOAT") value.type = "X";
  if (colon == std::string::npos || to == std::string::npos || from > to) return value;
  value.range = all.substr(from + 1, to - from - 1);
  if (const std::size_t dash = value.range.find(" - "); dash != std::string::npos)
    value.range.replace(dash, 3, " to ");
  return value;
}

std::string line_of(const CLI::Option& option, std::size_t width) {
  std::string names = "  " + (option.get_positional() ? option.get_name() : option.get_name(false, true));
  // A flag that may have a value: CLI11 shows what it has without.
  if (const std::size_t brace = names.find('{'); brace != std::string::npos)
    names.replace(brace, names.find('}') + 1 - brace, "[=FILE]");
  const Value value = value_of(option);
  if (!option.get_positional() && option.get_items_expected_max() != 0 && !value.type.empty())
    names += " " + value.type;
  std::string notes;
  const auto note = [&](const std::string& text) { notes += (notes.empty() ? " (" : "; ") + text; };
  if (!value.range.empty()) note(value.range);
  if (!option.get_default_str().empty()) note("default " + option.get_default_str());
  std::string excluded;
  for (const CLI::Option* const other : option.get_excludes())
    excluded += (excluded.empty() ? "not with " : ", ") + other->get_name();
  if (!excluded.empty()) note(excluded);
  if (!notes.empty()) notes += ")";
  return wrapped(names, option.get_description() + notes, names_width, width);
}

// CLI11 calls the group of those without one Options or OPTIONS.
std::string heading_of(const CLI::App& app, const CLI::Option& option) {
  if (option.get_positional()) return "Positionals";
  if (&option == app.get_help_ptr() || &option == app.get_version_ptr()) return "General";
  return option.get_group() == "OPTIONS" ? "Options" : option.get_group();
}

std::string usage(const CLI::App& app, const std::string& name) {
  std::string text = "Usage: " + name;
  for (const CLI::Option* const option : app.get_options([](const auto* o) { return o->get_positional(); })) {
    std::string value = option->get_name();
    if (option->get_items_expected_max() > 1) value += "...";
    text += " " + (option->get_required() ? value : "[" + value + "]");
  }
  const bool has_subcommands = !app.get_subcommands([](const auto*) { return true; }).empty();
  return text + (has_subcommands ? " SUBCOMMAND" : "") + " [OPTIONS]\n";
}

std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t k = 0; k < b.size(); ++k) {
      const std::size_t replaced = diagonal + (a[i] != b[k] ? 1 : 0);
      diagonal = row[k + 1];
      row[k + 1] = std::min({replaced, row[k] + 1, diagonal + 1});
    }
  }
  return row.back();
}

} // namespace

std::string help_text(const CLI::App* app, const std::string& name, CLI::AppFormatMode) {
  const std::size_t width = terminal_width();
  std::string text = wrapped_lines(app->get_description(), width) + "\n" + usage(*app, name);
  std::vector<std::string> headings;
  const std::vector<const CLI::Option*> options = app->get_options();
  for (const CLI::Option* const option : options) {
    const std::string heading = heading_of(*app, *option);
    if (std::ranges::find(headings, heading) == headings.end()) headings.push_back(heading);
  }
  std::ranges::stable_partition(headings, [](const std::string& h) { return h == "Positionals"; });
  std::ranges::stable_partition(headings, [](const std::string& h) { return h != "General"; });
  for (const std::string& heading : headings) {
    text += "\n" + heading + ":\n";
    for (const CLI::Option* const option : options) {
      if (heading_of(*app, *option) == heading) text += line_of(*option, width);
    }
  }
  const auto subcommands = app->get_subcommands([](const auto*) { return true; });
  if (!subcommands.empty()) text += "\nSubcommands:\n";
  for (const CLI::App* const subcommand : subcommands)
    text += wrapped("  " + subcommand->get_name(), subcommand->get_description(), names_width, width);
  if (!app->get_footer().empty()) text += "\n" + wrapped_lines(app->get_footer(), width);
  const CLI::App* const tool = app->get_parent() != nullptr ? app->get_parent() : app;
  return text + "\nMan page: " + tool->get_name() + "(1)\n";
}

std::string unknown_option(const CLI::App& app, const std::string& command) {
  std::string unknown;
  for (const std::string& argument : app.remaining(true)) {
    if (unknown.empty() && argument.starts_with('-') && argument.size() > 1)
      unknown = argument.substr(0, argument.find('='));
  }
  if (unknown.empty()) return {};
  std::string nearest;
  std::size_t least = std::max<std::size_t>(4, unknown.size() + 1) / 3;
  const auto compare = [&](const CLI::App& with_options) {
    for (const CLI::Option* const option : with_options.get_options()) {
      for (const std::string& long_name : option->get_lnames()) {
        const std::string name = "--" + long_name;
        const std::size_t distance = edit_distance(unknown, name);
        if (distance >= least) continue;
        least = distance;
        nearest = name;
      }
    }
  };
  compare(app);
  for (const CLI::App* const subcommand : app.get_subcommands())
    compare(*subcommand);
  return unknown + ": unknown option: " +
         (nearest.empty() ? "see " + command + " --help" : "did you mean " + nearest + "?");
}

} // namespace masu
