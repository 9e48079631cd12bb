#include "scenario/yaml_document.h"

#include <yaml-cpp/depthguard.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>
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
      failAt(key.origin, "duplicate key \"" + key.text + "\", first written in line " +
                             std::to_string(first->second) + ", expected it once");
    }
    if (map.lines.size() > most_keys)
      failAt(key.origin, "more than " + std::to_string(most_keys) + " keys in one map, expected fewer");
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

/// What a file says goes into messages, and messages go to terminals.
std::string oneLine(std::string message) {
  for (char& c : message) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  }
  return message;
}

}  // namespace

void failAt(const Origin& origin, const std::string& message) {
  throw InputError({origin.kind, oneLine(origin.file), origin.line, oneLine(origin.path)}, oneLine(message));
}

std::string readYamlFile(const std::filesystem::path& file) {
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
    failAt(lineFrom(first, std::max(0, error.mark.line)), error.msg + ", expected YAML");
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
