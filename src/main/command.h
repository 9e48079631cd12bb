#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {  // command.cpp alone includes CLI11
class App;
class Option;
}  // namespace CLI

namespace fissure {

/// One option of a command. The functions add requirements and return the option itself.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}

  Option& required();
  /// Its value must not be empty.
  Option& notEmpty();
  /// `problemOf` returns what is wrong with a value; empty: nothing.
  Option& check(const std::function<std::string(const std::string&)>& problemOf);
  /// Its value must be in this range, bounds included; NaN is not.
  Option& between(int low, int high);
  Option& between(double low, double high);
  Option& oneOf(const std::vector<std::string>& names);
  /// The help shows its default.
  Option& showDefault();
  /// Each use of the option takes only one value and appends it to the list, instead of taking all values
  /// that follow.
  Option& repeated();
  Option& count(int values);
  Option& commas();  ///< values may be separated by commas too
  Option& without(const Option& other);
  Option& without(const std::string& other);
  Option& needs(const Option& other);
  /// Sets the name of its value in the help.
  Option& called(const std::string& value);

 private:
  CLI::Option* option_;
};

/// A command of a program: `fissure run`, `fissure sweep status`, or the program itself. The variables that
/// options set must outlive the parsing.
class Command {
 public:
  explicit Command(CLI::App* app) : app_(app) {}

  /// Adds an option that sets `value`. A name that begins with "-" is that of an option, any other that of a
  /// positional argument.
  Option option(const std::string& name, std::string& value, const std::string& help);
  Option option(const std::string& name, int& value, const std::string& help);
  Option option(const std::string& name, std::size_t& value, const std::string& help);
  Option option(const std::string& name, double& value, const std::string& help);
  Option option(const std::string& name, std::optional<int>& value, const std::string& help);
  Option option(const std::string& name, std::optional<double>& value, const std::string& help);
  Option option(const std::string& name, std::vector<std::string>& values, const std::string& help);
  Option option(const std::string& name, std::vector<double>& values, const std::string& help);
  Option flag(const std::string& name, bool& value, const std::string& help);
  Command command(const std::string& name, const std::string& help);
  /// Adds an example to the end of the help.
  void example(const std::string& words);
  /// Whether the command line names this command.
  bool given() const;

 private:
  CLI::App* app_;
};

/// A program's command line.
class CommandLine {
 public:
  explicit CommandLine(const std::string& description, const std::string& name = "");
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  void setVersion(const std::string& text);  ///< sets the output of --version
  void setFooter(const std::string& text);   ///< sets the end of the help
  void requireCommand();                     ///< makes one of its commands mandatory
  Command root();

  /// The outcome of parsing.
  struct Outcome {
    bool done = false;  ///< help or version was printed
    /// The error in one line; for a program with a name, the command comes before it and a hint to its help
    /// behind. Empty: the command line is valid.
    std::string error;
  };
  /// A bash script that completes the program's commands and their options.
  std::string bashCompletion() const;

  Outcome parse(int argc, const char* const* argv);

 private:
  std::unique_ptr<CLI::App> app_;
};

}  // namespace fissure
