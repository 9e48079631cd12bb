#include "scenario/yaml_document.h"

#include <fmt/core.h>
#include <yaml-cpp/depthguard.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

#include "text/scalars.h"
#include "text/text_file.h"

namespace fissure {

namespace {

/// No map of a scenario, a sweep or tolerances has a hundredth of it. Looking a key up takes a walk over
/// them.
constexpr std::size_t most_keys = 10000;

constexpr std::uintmax_t most_file_bytes = std::uintmax_t{4} << 20;

/// The origin `offset` lines below `first`.
Origin lineFrom(const Origin& first, int offset) {
  Origin below = first;
  if (first.kind == Origin::Kind::file) below.line += offset;
  return below;
}

/// Builds the tree from yaml-cpp's events: its own Node accepts duplicate keys and loses lines when cloned.
class TreeBuilder : public YAML::EventHandler {
 public:
  explicit TreeBuilder(Origin first) : first_(std::move(first)) {}

  std::optional<YamlNode> takeRoot() { return std::move(root_); }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (root_) failAt(at(mark), "a second document, expected a single one");
  }
  void OnDocumentEnd() override {}
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override { refuseAnchor(mark); }
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    if (anchor) refuseAnchor(mark);
    add(start(YamlNode::Kind::nothing, mark));
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    check(mark, tag, anchor);
    YamlNode node = start(YamlNode::Kind::scalar, mark);
    node.text = value;
    node.quoted = tag == "!";
    add(std::move(node));
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    check(mark, tag, anchor);
    open_.push_back({start(YamlNode::Kind::list, mark), std::nullopt, {}});
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    check(mark, tag, anchor);
    open_.push_back({start(YamlNode::Kind::map, mark), std::nullopt, {}});
  }
  void OnMapEnd() override { close(); }

 private:
  struct Open {
    YamlNode node;
    std::optional<YamlNode> key;       ///< of a map, while its value is awaited
    std::map<std::string, int> lines;  ///< of a map's keys so far
  };

  Origin at(const YAML::Mark& mark) const { return lineFrom(first_, mark.line); }

  YamlNode start(YamlNode::Kind kind, const YAML::Mark& mark) const {
    YamlNode node;
    node.kind = kind;
    node.origin = at(mark);
    return node;
  }

  [[noreturn]] void refuseAnchor(const YAML::Mark& mark) const {
    failAt(at(mark), "an anchor or alias, expected the value written out (files are composed with `base:`)");
  }

  void check(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor) const {
    if (anchor) refuseAnchor(mark);
    // yaml-cpp says "?" for a plain node and "!" for a quoted one.
    if (!tag.empty() && tag != "?" && tag != "!")
      failAt(at(mark), "a tag (" + tag + "), expected a plain value");
  }

  void close() {
    YamlNode node = std::move(open_.back().node);
    open_.pop_back();
    add(std::move(node));
  }

  void add(YamlNode node) {
    if (open_.empty()) {
      root_ = std::move(node);
      return;
    }
    auto& [parent, key, lines] = open_.back();
    if (parent.kind == YamlNode::Kind::map) {
      if (!key) {
        addKey(std::move(node));
        return;
      }
      node.key = key->text;
      node.origin = key->origin;
      key.reset();
    }
    parent.children.push_back(std::move(node));
  }

  void addKey(YamlNode key) {
    if (key.kind != YamlNode::Kind::scalar)
      failAt(key.origin, "a key that is not a word, expected `key: value`");
    Open& map = open_.back();
    const auto [first, fresh] = map.lines.emplace(key.text, key.origin.line);
    if (!fresh) {
      failAt(key.origin, fmt::format("duplicate key \"{}\", first written in line {}, expected it once",
                                     key.text, first->second));
    }
    if (map.lines.size() > most_keys)
      failAt(key.origin, fmt::format("more than {} keys in one map, expected fewer", most_keys));
    map.key = std::move(key);
  }

  Origin first_;
  std::vector<Open> open_;
  std::optional<YamlNode> root_;
};

void refuseTabs(const std::string& text, const Origin& first) {
  std::istringstream lines(text);
  std::string line;
  for (int offset = 0; std::getline(lines, line); ++offset) {
    const std::size_t start = line.find_first_not_of(' ');
    const bool tab = start != std::string::npos && line[start] == '\t';
    if (tab && line.find_first_not_of(" \t\r") != std::string::npos) {
      failAt(lineFrom(first, offset), "a tab in the indentation, expected spaces");
    }
  }
}

/// What yaml-cpp says, and the same for people: what stands there and what was expected.
const std::array<std::pair<std::string_view, std::string_view>, 11> syntax_errors = {{
    {YAML::ErrorMsg::END_OF_SEQ_FLOW, "a list that [ has begun is not closed, expected \",\" or \"]\""},
    {YAML::ErrorMsg::END_OF_MAP_FLOW, "a map that { has begun is not closed, expected \",\" or \"}\""},
    {YAML::ErrorMsg::FLOW_END, "a bracket that closes none, expected \"]\" for each [ and \"}\" for each {"},
    {YAML::ErrorMsg::END_OF_MAP,
     "this does not go on with the map above it, expected `key: value` lines that begin below each other, or "
     "the end of a text where its second quote stands"},
    {YAML::ErrorMsg::END_OF_SEQ,
     "this does not go on with the list above it, expected `- item` lines that begin below each other"},
    {YAML::ErrorMsg::MAP_VALUE,
     "a \":\" that follows no key, expected one `key: value` in a line, the keys of a map below each other, "
     "and texts with \": \" in quotes"},
    {YAML::ErrorMsg::BLOCK_ENTRY, "\"- \" where no item can stand, expected items in lines below their key"},
    {YAML::ErrorMsg::EOF_IN_SCALAR, "a text in quotes is not closed, expected its second quote"},
    {YAML::ErrorMsg::DOC_IN_SCALAR, "a text in quotes is not closed, expected its second quote"},
    {YAML::ErrorMsg::INVALID_ESCAPE,
     "a backslash before what it cannot change, expected \\\\ or a text in single quotes"},
    {YAML::ErrorMsg::UNKNOWN_TOKEN,
     "a value that begins with a character which YAML keeps for itself, expected it in quotes"},
}};

/// "column 5: a list that [ has begun is not closed, expected ...".
std::string syntaxText(const YAML::Exception& error) {
  const int column = std::max(0, error.mark.column) + 1;
  for (const auto& [message, text] : syntax_errors)
    if (error.msg.starts_with(message)) return fmt::format("column {}: {}", column, text);
  return fmt::format("column {}: {}, expected YAML", column, error.msg);
}

bool isHdf5(const std::filesystem::path& file) {
  constexpr std::string_view signature = "\x89HDF\r\n\x1a\n";
  std::string start(signature.size(), '\0');
  std::error_code ignored;  // no pipes: they would wait
  if (!std::filesystem::is_regular_file(file, ignored)) return false;
  std::ifstream(file, std::ios::binary).read(start.data(), static_cast<std::streamsize>(start.size()));
  return start == signature;
}

}  // namespace

void failAt(const Origin& origin, const std::string& message) {
  throw InputError(origin, message);
}

std::string readYamlFile(const std::filesystem::path& file) {
  if (isHdf5(file))
    failAt(inFile(file),
           "is an HDF5 file, as results are, expected YAML; type: fissure info " + file.string());
  std::string text = readTextFile(file, most_file_bytes);
  if (text.empty()) failAt(inFile(file), "has size 0, expected a text file");
  return text;
}

const YamlNode* YamlNode::find(const std::string& key_wanted) const {
  if (kind != Kind::map) return nullptr;
  for (const YamlNode& child : children) {
    if (child.key == key_wanted) return &child;
  }
  return nullptr;
}

YamlNode* YamlNode::find(const std::string& key_wanted) {
  return const_cast<YamlNode*>(std::as_const(*this).find(key_wanted));
}

YamlNode parseYaml(const std::string& text, const Origin& first) {
  if (const int line = firstLineNotText(text)) {
    failAt(lineFrom(first, line - 1), "binary data or not UTF-8, expected UTF-8 text");
  }
  refuseTabs(text, first);
  TreeBuilder builder(first);
  try {
    // yaml-cpp takes the line end before the end of the file for the end of an unfinished quoted text.
    std::istringstream in(text.substr(0, text.find_last_not_of(" \t\r\n") + 1));
    YAML::Parser parser(in);
    while (parser.HandleNextDocument(builder)) {
    }
  } catch (const YAML::DeepRecursion& error) {
    failAt(lineFrom(first, std::max(0, error.mark.line)), "nested too deeply, expected a scenario");
  } catch (const YAML::Exception& error) {
    failAt(lineFrom(first, std::max(0, error.mark.line)), syntaxText(error));
  }
  std::optional<YamlNode> root = builder.takeRoot();
  if (root) return std::move(*root);
  YamlNode empty;
  empty.origin = first;
  return empty;
}

std::string flowText(const YamlNode& node) {
  std::string text;
  const auto add = [&](const std::string& item) { text += (text.empty() ? "" : ", ") + item; };
  switch (node.kind) {
    case YamlNode::Kind::nothing:
      return "null";
    case YamlNode::Kind::scalar:
      // A plain text may hold what ends a scalar in flow style.
      return node.quoted || scalarKind(node.text) == ScalarKind::text ? formatText(node.text) : node.text;
    case YamlNode::Kind::list:
      for (const YamlNode& item : node.children) add(flowText(item));
      return "[" + text + "]";
    case YamlNode::Kind::map:
      for (const YamlNode& entry : node.children) add(formatText(entry.key) + ": " + flowText(entry));
      return "{" + text + "}";
  }
  return text;
}

}  // namespace fissure
