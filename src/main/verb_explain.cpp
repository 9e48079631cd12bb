#include <iostream>
#include <memory>

#include "keys/key_schema.h"
#include "keys/key_text.h"
#include "keys/templates.h"
#include "main/exit_codes.h"
#include "main/verbs.h"

namespace fissure {

namespace {

struct ExplainOptions {
  std::vector<std::string> keys;
  bool all = false;
  bool markdown = false;
};

int explain(const ExplainOptions& options) {
  if (options.markdown) {
    std::cout << keysAsMarkdown();
    return exit_good;
  }
  std::vector<KeyPlace> found = options.all ? allKeys() : std::vector<KeyPlace>();
  for (const std::string& key : options.keys)
    for (const KeyPlace& place : findKeys(key)) found.push_back(place);
  std::cout << (found.empty() ? topLevelText() : textOf(found));
  return exit_good;
}

template <class Table, class NameOf>
std::vector<std::string> namesIn(const Table& table, NameOf nameOf) {
  std::vector<std::string> names;
  for (const auto& entry : table) names.emplace_back(nameOf(entry));
  return names;
}

}  // namespace

Verb addExplain(Command app) {
  const auto options = std::make_shared<ExplainOptions>();
  Command command = app.command("explain", "what keys of scenario, sweep, study and tolerance files mean");
  command.option("KEY", options->keys,
                 "a key by its path or its name, or a word of what is said of keys; nothing: the top level");
  command.flag("--all", options->all, "every key");
  command.flag("--markdown", options->markdown, "every key as Markdown: configs/KEYS.md");
  command.example("fissure explain bodies.elastic.youngs_modulus_Pa");
  return {command, [options] { return explain(*options); }};
}

Verb addSchema(Command app) {
  const auto kind = std::make_shared<std::string>("scenario");
  Command command = app.command("schema", "a JSON Schema of such files, for editors");
  command.option("FILE_KIND", *kind, "what file").oneOf(keyFileNames()).showDefault();
  command.example(
      "fissure schema > scenario.schema.json, and in the first line of a scenario "
      "# yaml-language-server: $schema=scenario.schema.json");
  return {command, [kind] {
            for (const KeyNode& file : keyFiles())
              if (file.name == *kind) std::cout << schemaOf(file);
            return exit_good;
          }};
}

Verb addInit(Command app) {
  struct Options {
    std::string name, kind = "press";
  };
  const auto options = std::make_shared<Options>();
  std::string kinds;
  for (const CatalogEntry& entry : templates())
    kinds.append(kinds.empty() ? "" : "; ").append(entry.name).append(": ").append(entry.description);
  Command command = app.command("init", "write a commented scenario to start from");
  command.option("NAME", options->name, "writes NAME.yaml into the current folder").required();
  command.option("--template", options->kind, kinds)
      .oneOf(namesIn(templates(), [](const CatalogEntry& entry) { return entry.name; }))
      .showDefault();
  command.example("fissure init my_press --template press && fissure run my_press.yaml");
  return {command, [options] {
            for (const auto& file : writeTemplate(options->kind, options->name, ""))
              std::cout << file.string() << "\n";
            return exit_good;
          }};
}

}  // namespace fissure
