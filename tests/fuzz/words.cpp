// Writes libFuzzer's dictionary of kinds of files, as "scenario" or "sweep": their keys, choices and types.
//   fuzz_words KIND...
#include <iostream>
#include <set>
#include <string>

#include "keys/key_files.h"
#include "scenario/catalog.h"

namespace {

using namespace fissure;

void addBelow(const KeyNode& node, std::set<std::string>& words) {
  for (const CatalogEntry& choice : node.choices) words.insert(std::string(choice.name));
  for (const KeyNode& child : node.children) {
    words.insert(child.kind == KeyNode::Kind::alternative ? child.name : child.name + ": ");
    addBelow(child, words);
  }
}

}  // namespace

int main(int count, char** arguments) {
  std::set<std::string> words;
  for (int i = 1; i < count; ++i)
    for (const KeyNode& file : keyFiles())
      if (file.name == arguments[i]) addBelow(file, words);
  for (const std::string& word : words) std::cout << '"' << word << "\"\n";
  return 0;
}
