#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

// What a program takes, declared in the words of this header alone: CLI11, which reads it, costs
// every file that includes it 8 s of compiling, so only core/cli does.

namespace rocinante::cli {

/// An option, a switch or a positional argument: a handle, to be passed by value, which is valid as
/// long as its Program. Each function returns the same handle, so that calls can follow each other.
class Option {
 public:
  explicit Option(CLI::Option& option) : option_(&option) {}

  // What --help shows.

  /// The word for its value: "TIME". The default follows it where it is shown.
  Option valueName(const std::string& word) const;
  /// All that stands behind its name: "TIME=2s", "[RUN=]FILE".
  Option valueText(const std::string& text) const;
  /// Shows as default what the value is now.
  Option showDefault() const;
  Option description(const std::string& text) const;
  /// Of a positional: the usage line shows it as required, though it is the program that asks for
  /// it, where an optional one stands before it and one word alone is meant for this.
  Option showRequired() const;
  /// The heading that it stands below.
  Option group(const std::string& heading) const;

  // How often, and with what.

  Option required() const;
  Option needs(Option other) const;
  Option needs(const std::string& name) const;
  Option excludes(Option other) const;
  Option excludes(const std::string& name) const;
  /// Of a list: each mention takes one value, so that a positional may follow it.
  Option oneEach() const;
  Option separatedBy(char sign) const;
  /// The value may be left out, and then is `text`.
  Option bareMeans(const std::string& text) const;
  /// Of a list: a mention may have no value, and then adds an empty one.
  Option mayBeBare() const;

  // Which values.

  Option oneOf(std::vector<std::string> values) const;
  Option oneOf(std::initializer_list<int> values) const;
  /// From `least` to `most`, both included; int or double.
  template <class T>
  Option within(T least, T most) const;
  Option positive() const;
  /// Calls `taken` with each value while the command line is read.
  Option each(const std::function<void(const std::string& value)>& taken) const;

  /// After parsing: whether it was mentioned.
  bool given() const;

 private:
  friend class CommandLine;
  CLI::Option* option_;
};

/// What a program or one of its subcommands takes: a handle, to be passed by value, which is valid
/// as long as its Program. Values that it refers to must outlive parsing. --help lists everything
/// in the order in which it was added. Names: "-o,--output", or "LOG" for a positional argument.
class CommandLine {
 public:
  explicit CommandLine(CLI::App& app) : app_(&app) {}

  /// T: a text, a path, a number, an optional number, or a list of texts or paths
  /// (core/cli/command_line.cpp names them).
  template <class T>
  Option addOption(const std::string& names, T& value, const std::string& does) const;
  /// One whose values only Option::each() sees.
  Option addOption(const std::string& names, const std::string& does) const;
  /// One that may be repeated, each of whose texts `read` takes; its error is one of the command
  /// line.
  Option addParsed(const std::string& names, std::function<Status(const std::string& text)> read,
                   const std::string& does) const;
  Option addFlag(const std::string& names, bool& value, const std::string& does) const;
  /// Takes values too, by `=` alone. `names` says what it adds without one: "--shadows{on}".
  Option addFlag(const std::string& names, std::vector<std::string>& values,
                 const std::string& does) const;
  /// An option of this name, which was added.
  Option option(const std::string& name) const;

  CommandLine addSubcommand(const std::string& name, const std::string& does) const;
  void requireSubcommand() const;
  /// Options of which exactly one must be given, below `heading`.
  CommandLine addOneOf(const std::string& name, const std::string& heading) const;

  /// After parsing: of a subcommand, whether it was asked for.
  bool isChosen() const;

 private:
  friend class Program;
  CLI::App* app_;
};

/// The command line of a program, for run().
class Program : public CommandLine {
 public:
  Program(const std::string& does, const std::string& name);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  CLI::App& app() const { return *app_; }
};

}  // namespace rocinante::cli
