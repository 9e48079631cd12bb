#include "main/command.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "text/did_you_mean.h"
#include "text/scalars.h"

namespace fissure {

namespace {

/// `description`: what the help says of values.
CLI::Validator checkOf(const std::function<std::string(const std::string&)>& problemOf,
                       const std::string& description) {
  return CLI::Validator([problemOf](const std::string& value) { return problemOf(value); }, description);
}

/// The commands that the command line names, down to the last: "fissure sweep status".
std::pair<const CLI::App*, std::string> lastOf(const CLI::App& app) {
  const std::vector<CLI::App*> given = app.get_subcommands();
  if (given.empty()) return {&app, app.get_name()};
  const auto [last, words] = lastOf(*given.front());
  return {last, app.get_name() + " " + words};
}

/// The long option that `given` begins, or is a slip of; else null.
const std::string* meantOption(const std::string& given, const std::vector<std::string>& known) {
  if (given.size() < 4 || !given.starts_with("--")) return nullptr;
  const auto begun = std::find_if(known.begin(), known.end(),
                                  [&](const std::string& name) { return name.starts_with(given); });
  return begun != known.end() ? &*begun : nearestName(given, known);
}

std::vector<std::string> longOptions(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

/// What is wrong with an argument that a command does not know: 'no option --forc, did you mean "--force"?'.
std::string unknownText(std::string given, const CLI::App& command) {
  given.resize(std::min(given.find('='), given.size()));
  std::vector<std::string> commands;
  for (const CLI::App* below : command.get_subcommands(nullptr)) commands.push_back(below->get_name());
  if (given.starts_with("-")) {
    const std::vector<std::string> options = longOptions(command);
    const std::string* meant = meantOption(given, options);
    return "no option " + given + (meant ? ", did you mean " + *meant + "?" : "");
  }
  if (commands.empty()) return "\"" + given + "\" was not expected";
  return "no command \"" + given + "\"" + didYouMean(given, commands);
}

}  // namespace

Option& Option::required() {
  option_->required();
  return *this;
}

Option& Option::notEmpty() {
  return check([](const std::string& value) { return value.empty() ? "names no file" : ""; });
}

Option& Option::check(const std::function<std::string(const std::string&)>& problemOf) {
  option_->check(checkOf(problemOf, ""));
  return *this;
}

Option& Option::between(int low, int high) {
  option_->check(CLI::Range(low, high));
  return *this;
}

// CLI::Range lets NaN pass.
Option& Option::between(double low, double high) {
  const std::string expected = ": expected a number from " + formatReal(low) + " to " + formatReal(high);
  const auto problemOf = [=](const std::string& given) {
    const std::optional<double> value = toReal(given);
    return value && *value >= low && *value <= high ? std::string() : given + expected;
  };
  // A range that nobody comes near only makes the help longer.
  option_->check(
      checkOf(problemOf, high > 1e6 ? "" : "in [" + formatReal(low) + " - " + formatReal(high) + "]"));
  return *this;
}

Option& Option::oneOf(const std::vector<std::string>& names) {
  const auto problemOf = [names](const std::string& given) {
    const bool known = std::find(names.begin(), names.end(), given) != names.end();
    return known ? std::string() : "\"" + given + "\" is no choice" + didYouMean(given, names);
  };
  option_->check(checkOf(problemOf, "{" + CLI::detail::join(names) + "}"));
  return *this;
}

Option& Option::showDefault() {
  option_->capture_default_str();
  return *this;
}

Option& Option::repeated() {
  option_->allow_extra_args(false);
  return *this;
}

Option& Option::count(int values) {
  option_->expected(values);
  return *this;
}

Option& Option::commas() {
  option_->delimiter(',');
  return *this;
}

Option& Option::without(const Option& other) {
  option_->excludes(other.option_);
  return *this;
}

Option& Option::without(const std::string& other) {
  option_->excludes(other);
  return *this;
}

Option& Option::needs(const Option& other) {
  option_->needs(other.option_);
  return *this;
}

Option& Option::called(const std::string& value) {
  option_->type_name(value);
  return *this;
}

Option Command::option(const std::string& name, std::string& value, const std::string& help) {
  return Option(app_->add_option(name, value, help));
}

Option Command::option(const std::string& name, int& value, const std::string& help) {
  return Option(app_->add_option(name, value, help));
}

Option Command::option(const std::string& name, std::size_t& value, const std::string& help) {
  return Option(app_->add_option(name, value, help));
}

Option Command::option(const std::string& name, double& value, const std::string& help) {
  return Option(app_->add_option(name, value, help));
}

Option Command::option(const std::string& name, std::optional<int>& value, const std::string& help) {
  return Option(app_->add_option(name, value, help));
}

Option Command::option(const std::string& name, std::optional<double>& value, const std::string& help) {
  return Option(app_->add_option(name, value, help));
}

Option Command::option(const std::string& name, std::vector<std::string>& values, const std::string& help) {
  return Option(app_->add_option(name, values, help));
}

Option Command::option(const std::string& name, std::vector<double>& values, const std::string& help) {
  return Option(app_->add_option(name, values, help));
}

Option Command::flag(const std::string& name, bool& value, const std::string& help) {
  return Option(app_->add_flag(name, value, help));
}

Command Command::command(const std::string& name, const std::string& help) {
  return Command(app_->add_subcommand(name, help));
}

void Command::example(const std::string& words) {
  app_->footer("Example: " + words);
}

bool Command::given() const {
  return app_->parsed();
}

CommandLine::CommandLine(const std::string& description, const std::string& name)
    : app_(std::make_unique<CLI::App>(description, name)) {}

CommandLine::~CommandLine() = default;

void CommandLine::setVersion(const std::string& text) {
  app_->set_version_flag("--version", text);
}

void CommandLine::setFooter(const std::string& text) {
  app_->footer(text);
}

void CommandLine::requireCommand() {
  app_->require_subcommand(1);
}

Command CommandLine::root() {
  return Command(app_.get());
}

std::string CommandLine::bashCompletion() const {
  const std::string program = app_->get_name();
  std::string commands, cases;
  for (const CLI::App* command : app_->get_subcommands(nullptr)) {
    commands += (commands.empty() ? "" : " ") + command->get_name();
    std::string words;
    std::vector<std::string> options = longOptions(*command);
    for (const CLI::App* below : command->get_subcommands(nullptr))
      for (const std::string& option : longOptions(*below))
        if (std::find(options.begin(), options.end(), option) == options.end()) options.push_back(option);
    for (const std::string& option : options) words += (words.empty() ? "" : " ") + option;
    cases += "    " + command->get_name() + ") words=\"" + words + "\" ;;\n";
  }
  return "# Type: eval \"$(" + program + " completion bash)\"\n_" + program +
         "() {\n  local word=${COMP_WORDS[COMP_CWORD]} words=\n  case ${COMP_WORDS[1]} in\n" + cases +
         "  esac\n  [ \"$COMP_CWORD\" = 1 ] && words=\"" + commands +
         "\"\n  COMPREPLY=()\n  # Names of files where neither a command nor an option is begun.\n"
         "  [[ $COMP_CWORD = 1 || $word = -* ]] && COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n}\n"
         "complete -o default -F _" +
         program + " " + program + "\n";
}

CommandLine::Outcome CommandLine::parse(int argc, const char* const* argv) {
  try {
    app_->parse(argc, argv);
    return {};
  } catch (const CLI::Success& help) {
    app_->exit(help);
    return {true, {}};
  } catch (const CLI::ParseError& error) {
    const auto [command, words] = lastOf(*app_);
    const std::string beginning = words.empty() ? "" : words + ": ";
    const std::string end = words.empty() ? "" : " (see " + words + " --help)";
    const std::vector<std::string> unknown = app_->remaining(true);
    const bool is_known = unknown.empty() || (error.get_exit_code() != int(CLI::ExitCodes::ExtrasError) &&
                                              error.get_exit_code() != int(CLI::ExitCodes::RequiredError));
    return {false, beginning + (is_known ? error.what() : unknownText(unknown.front(), *command)) + end};
  }
}

}  // namespace fissure
