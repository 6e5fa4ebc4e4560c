#include "tools/common/command_line.h"

#include "libscene/base/error.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

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
  bool begins = true; // a line
  const auto end_line = [&] {
    text += "\n";
    column = 0;
    begins = true;
  };
  if (column + 2 > indent && !lead.empty()) end_line();
  std::istringstream words(paragraph);
  for (std::string word; words >> word; begins = false) {
    if (!begins && column + 1 + width_of(word) > width) end_line();
    const std::size_t spaces = !begins ? 1 : indent - std::min(indent, column);
    text += std::string(spaces, ' ') + word;
    column += spaces + width_of(word);
  }
  return text + "\n";
}

// Lines that begin with a space stand as they are.
std::string wrapped_lines(const std::string& text, std::size_t width) {
  std::string result;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    result += line.starts_with(' ') ? line + "\n" : wrapped("", line, 0, width);
  return result;
}

std::string line_of(const CLI::Option& option, std::size_t width) {
  std::string names = "  " + (option.get_positional() ? option.get_name() : option.get_name(false, true));
  // A flag that may have a value: CLI11 shows what it has without.
  if (const std::size_t brace = names.find('{'); brace != std::string::npos)
    names.replace(brace, names.find('}') + 1 - brace, "[=FILE]");
  // What CLI11 puts after an option's names: a type such as TEXT, or names of values; and after a colon what
  // a value is checked for, of which a range in [ ] is kept.
  const std::string all = option.get_type_name();
  const std::size_t colon = all.find(':'), from = all.find('['), to = all.find(']');
  std::string type = all.substr(0, colon), range;
  if (type == "INT" || type == "UINT") type = "N";
  if (type == "FLOAT") type = "X";
  if (!option.get_positional() && option.get_items_expected_max() != 0 && !type.empty()) names += " " + type;
  if (colon != std::string::npos && to != std::string::npos && from < to)
    range = all.substr(from + 1, to - from - 1);
  if (const std::size_t dash = range.find(" - "); dash != std::string::npos) range.replace(dash, 3, " to ");
  std::string notes;
  const auto note = [&](const std::string& text) { notes += (notes.empty() ? " (" : "; ") + text; };
  if (!range.empty()) note(range);
  const std::string usual = option.get_default_str();
  if (!usual.empty() && usual != "[]") note("default " + usual); // [] is an empty list
  std::set<std::string> excluded; // CLI11 has them by their addresses, which differ from run to run
  for (const CLI::Option* const other : option.get_excludes())
    excluded.insert(other->get_name());
  if (!excluded.empty()) note(fmt::format("not with {}", fmt::join(excluded, ", ")));
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

// The text of --help: description, usage, options by group, the footer and the man page's name. Lines are as
// wide as the terminal, or 80 columns where there is none; words aren't broken.
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

// Throws the error of the first option that was given and that neither `app` nor its subcommand has, with the
// nearest one that they have: "--thread: unknown option: did you mean --threads?". `command` is whose help
// lists them.
void refuse_unknown_option(const CLI::App& app, const std::string& command) {
  std::string unknown;
  for (const std::string& argument : app.remaining(true)) {
    if (unknown.empty() && argument.starts_with('-') && argument.size() > 1)
      unknown = argument.substr(0, argument.find('='));
  }
  if (unknown.empty()) return;
  std::string nearest;
  std::size_t least = std::max<std::size_t>(4, unknown.size() + 1) / 3;
  std::vector<const CLI::App*> apps{&app};
  for (const CLI::App* const subcommand : app.get_subcommands())
    apps.push_back(subcommand);
  for (const CLI::App* const with_options : apps) {
    for (const CLI::Option* const option : with_options->get_options()) {
      for (const std::string& name : option->get_lnames()) {
        const std::size_t distance = edit_distance(unknown, "--" + name);
        if (distance >= least) continue;
        least = distance;
        nearest = "--" + name;
      }
    }
  }
  throw Error(ErrorCode::usage, unknown,
              "unknown option: " +
                  (nearest.empty() ? "see " + command + " --help" : "did you mean " + nearest + "?"));
}

// An empty value would often be taken for none, and that option ignored; --option= even takes the next
// argument for its value.
void refuse_empty_values(const std::string& name, int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    const bool ends = argument.starts_with("--") && argument.find('=') == argument.size() - 1;
    if (!argument.empty() && !ends) continue;
    throw Error(ErrorCode::usage, "command line",
                fmt::format("the value {} {} is empty: give one, or leave it out: see {} --help",
                            ends ? "of" : "after", ends || i > 1 ? argv[ends ? i : i - 1] : name, name));
  }
}

} // namespace

Option Option::required() const {
  return Option(option_->required());
}
Option Option::needs(Option other) const {
  return Option(option_->needs(other.option_));
}
Option Option::excludes(std::initializer_list<Option> others) const {
  for (const Option other : others)
    option_->excludes(other.option_);
  return *this;
}
Option Option::type_name(const std::string& name) const {
  return Option(option_->type_name(name));
}
Option Option::shows_default() const {
  return Option(option_->capture_default_str());
}
Option Option::comma_separated() const {
  return Option(option_->delimiter(','));
}
Option Option::values(int least, int most) const {
  return Option(option_->expected(least, most));
}
template <class Number>
Option Option::range(Number least, std::type_identity_t<Number> most) const {
  return Option(option_->check(CLI::Range(least, most)));
}
template Option Option::range(int, int) const;
template Option Option::range(std::uint32_t, std::uint32_t) const;
template Option Option::range(std::uint64_t, std::uint64_t) const;
template Option Option::range(double, double) const;
Option Option::among(const std::set<std::string>& values) const {
  return Option(option_->check(CLI::IsMember(values)));
}
Option Option::check(const std::function<std::string(const std::string&)>& fault,
                     const std::string& what) const {
  return Option(
      option_->check(CLI::Validator([fault](const std::string& text) { return fault(text); }, what)));
}
Option Option::under(const std::string& heading) const {
  return Option(option_->group(heading));
}

CommandLine::CommandLine(const char* name, const char* description, const std::string& version_text)
    : app_(std::make_shared<CLI::App>(description, name)) {
  app_->set_version_flag("--version", version_text);
  app_->formatter_fn(help_text);
}

void CommandLine::parse(int argc, char** argv, const std::function<bool()>& prints_help) const {
  refuse_empty_values(app_->get_name(), argc, argv);
  try {
    app_->parse(argc, argv);
  } catch (const CLI::Success& success) { // --help, --version
    if (prints_help()) app_->exit(success);
    throw HelpGiven{};
  } catch (const CLI::ParseError& error) {
    std::string command = app_->get_name(); // with the subcommand whose help lists the options
    for (const CLI::App* const subcommand : app_->get_subcommands())
      command += " " + subcommand->get_name();
    refuse_unknown_option(*app_, command);
    throw Error(ErrorCode::usage, "command line", fmt::format("{}: see {} --help", error.what(), command));
  }
}

template <class Value>
Option CommandLine::add_option(const std::string& names, Value& value, const std::string& help) const {
  return Option(app_->add_option(names, value, help));
}
template Option CommandLine::add_option(const std::string&, int&, const std::string&) const;
template Option CommandLine::add_option(const std::string&, std::uint32_t&, const std::string&) const;
template Option CommandLine::add_option(const std::string&, std::uint64_t&, const std::string&) const;
template Option CommandLine::add_option(const std::string&, double&, const std::string&) const;
template Option CommandLine::add_option(const std::string&, std::string&, const std::string&) const;
template Option CommandLine::add_option(const std::string&, std::optional<int>&, const std::string&) const;
template Option CommandLine::add_option(const std::string&, std::optional<double>&, const std::string&) const;
template Option CommandLine::add_option(const std::string&, std::vector<int>&, const std::string&) const;
template Option CommandLine::add_option(const std::string&, std::vector<double>&, const std::string&) const;
template Option CommandLine::add_option(const std::string&, std::vector<std::string>&,
                                        const std::string&) const;

Option CommandLine::add_named(const std::string& names, int value, const std::map<std::string, int>& choices,
                              const std::function<void(int)>& choose, const std::string& help) const {
  std::string all, chosen;
  for (const auto& [name, number] : choices) {
    all += (all.empty() ? "" : "|") + name;
    if (number == value) chosen = name;
  }
  const auto to_number = [choices, all](std::string& text) {
    const auto found = choices.find(text);
    if (found == choices.end()) return fmt::format("'{}' isn't one of {}", text, all);
    text = std::to_string(found->second);
    return std::string();
  };
  return Option(app_->add_option_function<int>(names, choose, help)
                    ->transform(CLI::Validator(to_number, "", "choice"))
                    ->type_name(all)
                    ->default_str(chosen));
}

Option CommandLine::add_flag(const std::string& names, bool& is_set, const std::string& help) const {
  return Option(app_->add_flag(names, is_set, help));
}
Option CommandLine::add_flag(const std::string& names, const std::function<void()>& set,
                             const std::string& help) const {
  return Option(app_->add_flag_callback(names, set, help));
}
Option CommandLine::add_json(std::string& path) const {
  return Option(app_->add_flag("--json{-}", path, "print JSON; --json=FILE writes it to a file"));
}

void CommandLine::group(const std::string& heading) const {
  app_->option_defaults()->group(heading);
}
void CommandLine::group_needs(const std::string& heading, Option needed) const {
  for (CLI::Option* const option : app_->get_options([](const CLI::Option*) { return true; }))
    if (option != needed.option_ && option->get_group() == heading) option->needs(needed.option_);
}
void CommandLine::footer(const std::string& text) const {
  app_->footer(text);
}
std::vector<std::pair<std::string, std::string>> CommandLine::given_options() const {
  std::vector<std::pair<std::string, std::string>> given;
  for (const CLI::Option* const option :
       app_->get_options([](const CLI::Option* o) { return o->count() > 0; }))
    given.emplace_back(option->get_name(), option->get_group());
  return given;
}
void CommandLine::refuse(std::initializer_list<Useless> options) const {
  for (const auto& [name, is_useless, why] : options)
    if (is_useless && app_->count(name) > 0) throw Error(ErrorCode::usage, name, why);
}
CommandLine CommandLine::add_subcommand(const std::string& name, const std::string& description) const {
  app_->require_subcommand(1);
  return CommandLine(std::shared_ptr<CLI::App>(app_, app_->add_subcommand(name, description)));
}
void CommandLine::calls(const std::function<void()>& run) const {
  app_->callback(run);
}

} // namespace masu
