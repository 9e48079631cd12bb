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

/// One option of a command; the calls below add to what it demands and return it.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}

  Option& required();
  /// Its value must not be empty.
  Option& notEmpty();
  /// `problemOf` says what is wrong with a value, or nothing.
  Option& check(const std::function<std::string(const std::string&)>& problemOf);
  /// Both bounds included; NaN is outside.
  Option& between(int low, int high);
  Option& between(double low, double high);
  Option& oneOf(const std::vector<std::string>& names);
  /// The help says what it is when it is left out.
  Option& showDefault();
  /// A list grows by one value each time the option is given, instead of taking all values that follow it.
  Option& repeated();
  Option& count(int values);
  Option& commas();  ///< commas divide values too
  Option& without(const Option& other);
  Option& without(const std::string& other);
  Option& needs(const Option& other);
  /// What the help calls its value.
  Option& called(const std::string& value);

 private:
  CLI::Option* option_;
};

/// A command of a program: `fissure run`, `fissure sweep status`, or the program itself. Values that options
/// write to must outlive the parsing.
class Command {
 public:
  explicit Command(CLI::App* app) : app_(app) {}

  /// Names that begin with "-" are options, others stand for arguments by their position.
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

  void setVersion(const std::string& text);  ///< what --version prints
  void setFooter(const std::string& text);   ///< of the help
  void requireCommand();                     ///< one of its commands must be given
  Command root();

  /// What parsing came to.
  struct Outcome {
    bool done = false;  ///< help or version were printed
    std::string error;  ///< one line; empty: the command line is good
  };
  Outcome parse(int argc, const char* const* argv);

 private:
  std::unique_ptr<CLI::App> app_;
};

}  // namespace fissure
