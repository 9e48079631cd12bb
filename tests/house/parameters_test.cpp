// No function of contact/ has so many parameters that two of one type could be swapped unseen: read from the
// sources themselves.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

namespace fissure::parameters_test {

namespace {

namespace fs = std::filesystem;

constexpr int kMostParameters = 5;

/// A declaration or definition of a function in a namespace or class.
struct Declared {
  std::string name;
  int parameters = 0;
};

/// `code` without comments, preprocessor lines and what stands between quotes.
std::string bare(const std::string& code) {
  std::string text;
  for (std::size_t i = 0; i < code.size(); ++i) {
    if (code.compare(i, 2, "//") == 0) {
      i = code.find('\n', i);
    } else if (code.compare(i, 2, "/*") == 0) {
      i = code.find("*/", i) + 1;
    } else if (code[i] == '#' && (text.empty() || text.back() == '\n')) {
      i = code.find('\n', i);
    } else if (code[i] == '"' || (code[i] == '\'' && (text.empty() || !std::isalnum(text.back())))) {
      const char quote = code[i];
      for (++i; i < code.size() && code[i] != quote; ++i) i += code[i] == '\\' ? 1 : 0;
    } else {
      text += code[i];
    }
    if (i >= code.size()) break;
  }
  return text;
}

/// The declarations of namespaces and classes, one after the other; bodies of functions and initial values
/// are passed over.
class Declarations {
 public:
  explicit Declarations(const std::string& code) : text_(bare(code)) {
    while (at_ < text_.size()) readOne();
  }
  const std::vector<Declared>& found() const { return found_; }

 private:
  /// From `at_` to the end of a declaration, or into the braces of a namespace or class.
  void readOne() {
    const std::size_t begin = at_;
    bool is_function = false, in_initialisers = false;
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == ';' || c == '}') break;
      if (c == '=' && is_function) in_initialisers = true;  // = default, = 0
      if (c == ':' && text_[at_ + 1] == ':')
        ++at_;
      else if (c == ':' && is_function)
        in_initialisers = true;
      else if (c == '(' && !in_initialisers)
        is_function = readParameters() || is_function;
      else if (c == '(')
        skip();
      else if (c == '{' && opensScope(text_.substr(begin, at_ - begin), is_function))
        break;
      else if (c == '{') {
        const bool is_body = is_function && !(in_initialisers && isName(beforeBlanks(at_)));
        skip();
        if (is_body) break;
      }
    }
    ++at_;
  }

  /// At an opening bracket: counts what it holds up to the closing one. False: it follows no name.
  bool readParameters() {
    std::size_t name_end = at_;
    while (name_end > 0 && std::isspace(text_[name_end - 1])) --name_end;
    std::size_t name = name_end;
    while (name > 0 && isName(text_[name - 1])) --name;
    const std::size_t first = at_ + 1;
    int depth = 0, commas = 0;
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '(' || c == '[' || c == '{' || c == '<') ++depth;
      if ((c == ')' || c == ']' || c == '}' || c == '>') && --depth == 0) break;
      if (c == ',' && depth == 1) ++commas;
    }
    const std::string held = text_.substr(first, at_ - first);
    const bool is_empty =
        std::all_of(held.begin(), held.end(), [](unsigned char c) { return std::isspace(c); });
    if (name == name_end) return false;
    found_.push_back({text_.substr(name, name_end - name), is_empty ? 0 : commas + 1});
    return true;
  }

  /// From an opening bracket to the closing one.
  void skip() {
    int depth = 0;
    for (; at_ < text_.size(); ++at_) {
      depth += text_[at_] == '(' || text_[at_] == '{' ? 1 : 0;
      depth -= text_[at_] == ')' || text_[at_] == '}' ? 1 : 0;
      if (depth == 0) return;
    }
  }

  static bool opensScope(const std::string& head, bool is_function) {
    if (is_function) return false;
    const auto has = [&](const std::string& word) {
      const std::size_t at = head.find(word);
      return at != std::string::npos && (at == 0 || !isName(head[at - 1])) && !isName(head[at + word.size()]);
    };
    return !has("enum") && (has("namespace") || has("class") || has("struct"));
  }

  char beforeBlanks(std::size_t at) const {
    while (at > 0 && std::isspace(text_[at - 1])) --at;
    return at > 0 ? text_[at - 1] : ' ';
  }
  static bool isName(char c) { return std::isalnum(c) || c == '_' || c == '>'; }

  std::string text_;
  std::size_t at_ = 0;
  std::vector<Declared> found_;
};

std::vector<Declared> declaredIn(const std::string& code) {
  return Declarations(code).found();
}

/// "name: number of parameters" of those with too many.
std::vector<std::string> tooMany(const std::string& code) {
  std::vector<std::string> names;
  for (const Declared& function : declaredIn(code))
    if (function.parameters > kMostParameters)
      names.push_back(function.name + ": " + std::to_string(function.parameters));
  return names;
}

using Names = std::vector<std::string>;

TEST(Parameters, SixAreFoundInEveryKindOfDeclaration) {
  EXPECT_EQ(tooMany("void f(int a, int b, int c, int d, int e, int g);"), Names{"f: 6"});
  EXPECT_EQ(tooMany("namespace { bool f(int, int, int, int, int, int) { return g(1); } }"), Names{"f: 6"});
  EXPECT_EQ(
      tooMany(
          "namespace n { class C : public B {\n public:\n  C(int a, int b, int c, int d, int e, int f = 1)\n"
          "      : a_(a), b_{b} {}\n private:\n  int a_ = 0, b_ = 0;\n"
          "  void p(int, int, int, int, int, int, int) const;\n};\n}"),
      (Names{"C: 6", "p: 7"}));
  EXPECT_EQ(
      tooMany("struct S { int a = 0; std::vector<int> b = {}; void f(int, int, int, int, int, int); };"),
      Names{"f: 6"});
  EXPECT_EQ(
      tooMany(
          "N::C::C(int a, int b, int c, int d, int e, int f)\n    : a_(a), b_{b, {c}}, d_(d) {\n  g();\n}\n"
          "void after(int, int, int, int, int, int);"),
      (Names{"C: 6", "after: 6"}));
  EXPECT_EQ(tooMany("template <class T>\nstd::optional<T> N::f(\n    int a, std::array<int, 3> b, T c,  // "
                    "why, so, many\n"
                    "    int d, int e, std::function<void(int, int)> g) const {\n}"),
            Names{"f: 6"});
}

TEST(Parameters, FiveAreNotTooManyAndOnlyParametersCount) {
  EXPECT_EQ(tooMany("void f(std::map<int, std::pair<int, int>> a, std::array<int, 3> b = {1, 2, 3}, int c, "
                    "int d, int e);"),
            Names{});
  EXPECT_EQ(
      tooMany("void f() {\n  g(1, 2, 3, 4, 5, 6);\n  const auto h = [](int, int, int, int, int, int) {};\n}"),
      Names{});
  EXPECT_EQ(tooMany("C::C(int a) : a_(1, 2, 3, 4, 5, 6), b_{1, 2, 3, 4, 5, 6} {}"), Names{});
  EXPECT_EQ(
      tooMany(
          "// void f(int, int, int, int, int, int);\n/* g(1, 2, 3, 4, 5, 6) */\n#define F(a, b, c, d, e, f)\n"
          "const char* text = \"h(1, 2, 3, 4, 5, 6)\";\nenum class E { a, b, c, d, e, f };\n"),
      Names{});
}

TEST(Parameters, FunctionsOfContactHaveFiveAtMost) {
  std::set<std::string> names;
  for (const auto& file : fs::directory_iterator(fs::path(FISSURE_SOURCE_DIR) / "src/simulation/contact")) {
    std::ifstream stream(file.path());
    const std::string code{std::istreambuf_iterator<char>(stream), {}};
    EXPECT_EQ(tooMany(code), Names{}) << file.path();
    for (const Declared& function : declaredIn(code)) names.insert(function.name);
  }
  for (const char* known : {"NodeContact", "step", "cast", "hitOnPath", "find", "apply", "rub", "move",
                            "boxEntryFace", "makeCentroidNodes", "intersect", "extentOf"})
    EXPECT_TRUE(names.contains(known)) << known << " was not seen";
  EXPECT_GT(names.size(), 80u) << "the sources were not understood";
}

}  // namespace

}  // namespace fissure::parameters_test
