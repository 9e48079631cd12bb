#include "main/command.h"

#include <CLI/CLI.hpp>

#include "text/scalars.h"

namespace fissure {

namespace {

/// `description`: what the help says of values.
CLI::Validator checkOf(const std::function<std::string(const std::string&)>& problemOf,
                       const std::string& description) {
  return CLI::Validator([problemOf](const std::string& value) { return problemOf(value); }, description);
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
  option_->check(CLI::IsMember(names));
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

CommandLine::Outcome CommandLine::parse(int argc, const char* const* argv) {
  try {
    app_->parse(argc, argv);
    return {};
  } catch (const CLI::Success& help) {
    app_->exit(help);
    return {true, {}};
  } catch (const CLI::ParseError& error) {
    return {false, error.what()};
  }
}

}  // namespace fissure
