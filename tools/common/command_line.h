// The command line of a tool or a subcommand, by CLI11, whose headers command_line.cpp alone compiles: they
// take longer than most of what includes this.
#pragma once

#include <functional>
#include <initializer_list>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace masu {

// An option or a positional of a command line.
class Option {
public:
  explicit Option(CLI::Option* option) : option_(option) {}

  Option required() const;
  Option needs(Option other) const;
  Option excludes(std::initializer_list<Option> others) const;
  // What --help calls its value.
  Option type_name(const std::string& name) const;
  // --help shows the default: what its variable holds now.
  Option shows_default() const;
  // Of lists: elements between commas, so many of them.
  Option comma_separated() const;
  Option values(int least, int most) const;
  // What a value is checked for. `fault`: its error message, empty for one that is right.
  template <class Number>
  Option range(Number least, std::type_identity_t<Number> most) const;
  Option among(const std::set<std::string>& values) const;
  Option check(const std::function<std::string(const std::string&)>& fault, const std::string& what) const;

  // The heading of --help that it is under, instead of group()'s.
  Option under(const std::string& heading) const;

private:
  friend class CommandLine;
  CLI::Option* option_;
};

class CommandLine {
public:
  // What parse() throws instead of returning: the tool has nothing else to do.
  struct HelpGiven {};

  CommandLine(const char* name, const char* description, const std::string& version_text);

  // When all options are added. Prints what --help or --version ask for where prints_help() says so. Throws
  // Error(usage, …) for a command line that isn't right.
  void parse(int argc, char** argv, const std::function<bool()>& prints_help) const;

  // A variable gets the option's value: a number, a text, an optional number, or a list of them. Its initial
  // value is the default.
  template <class Value>
  Option add_option(const std::string& names, Value& value, const std::string& help) const;
  // `type`: what --help calls its value.
  template <class Value>
  Option add_option(const std::string& names, Value& value, const std::string& help, const char* type) const {
    return add_option(names, value, help).type_name(type);
  }
  // A number from `least` to `most`, whose default --help shows.
  template <class Number>
  Option add_number(const std::string& names, Number& number, std::type_identity_t<Number> least,
                    std::type_identity_t<Number> most, const std::string& help) const {
    return add_option(names, number, help).range(least, most).shows_default();
  }
  Option add_file(const std::string& names, std::string& path, const std::string& help) const {
    return add_option(names, path, help, "FILE");
  }
  // An option whose values have names. The initial `value` is its default, and must be among them.
  template <class Value>
  Option add_choice(const std::string& names, Value& value,
                    const std::map<std::string, std::type_identity_t<Value>>& choices,
                    const std::string& help) const {
    std::map<std::string, int> numbers;
    for (const auto& [name, choice] : choices)
      numbers.emplace(name, static_cast<int>(choice));
    return add_named(
        names, static_cast<int>(value), numbers, [&value](int number) { value = static_cast<Value>(number); },
        help);
  }
  Option add_flag(const std::string& names, bool& is_set, const std::string& help) const;
  Option add_flag(const std::string& names, const std::function<void()>& set, const std::string& help) const;
  // --json; --json=FILE writes to a file. `path`: - without one.
  Option add_json(std::string& path) const;
  // -q, among the general options.
  Option add_quiet(bool& quiet, const std::string& help) const {
    return add_flag("-q,--quiet", quiet, help).under("General");
  }

  // Options that follow are under this heading of --help.
  void group(const std::string& heading) const;
  // All options of the heading but `needed` itself need it.
  void group_needs(const std::string& heading, Option needed) const;
  void footer(const std::string& text) const;
  // Names and headings of the options that were given.
  std::vector<std::pair<std::string, std::string>> given_options() const;

  // An option that has no effect beside the others.
  struct Useless {
    const char* name;
    bool is_useless;
    const char* why;
  };
  // Throws Error(usage, name, why) where one was given.
  void refuse(std::initializer_list<Useless> options) const;

  // run() is called where the subcommand is given. One of them is, where a command line has any.
  CommandLine add_subcommand(const std::string& name, const std::string& description) const;
  void calls(const std::function<void()>& run) const;

private:
  explicit CommandLine(std::shared_ptr<CLI::App> app) : app_(std::move(app)) {}
  Option add_named(const std::string& names, int value, const std::map<std::string, int>& choices,
                   const std::function<void(int)>& choose, const std::string& help) const;

  std::shared_ptr<CLI::App> app_;
};

// Adds options and an example, the footer, to the command line, calls parse(), and runs the tool.
using ToolBody = std::function<void(const CommandLine& command, const std::function<void()>& parse)>;

} // namespace masu
