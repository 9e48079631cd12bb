#pragma once

#include <string>
#include <vector>

#include "scenario/key_tree.h"

namespace fissure {

/// The names of the kinds of input files: "scenario", "sweep", "stability", "tradeoff", "tolerances".
const std::vector<std::string>& keyFileNames();

/// These files with all their keys, in the same order. The trees are built when this is first called.
const std::vector<KeyNode>& keyFiles();

/// A key and its place in a kind of file.
struct KeyPlace {
  /// Its path, with the types of alternatives as parts: "bodies.elastic.friction", "tools.shape.box.size_m";
  /// in a sweep file "sweep.axes.path", in a study "tradeoff.axes.path".
  std::string path;
  const KeyNode* node = nullptr;
  /// The nodes from the first key of the file to this one.
  std::vector<const KeyNode*> way;
};

/// All keys and alternatives of all kinds of files, each after the key that contains it.
const std::vector<KeyPlace>& allKeys();

/// The keys that `wanted` may stand for: the path of a key, the end of a path ("elastic.friction",
/// "youngs_modulus_Pa": all keys that end so), a path in a file, with names or numbers of list items and
/// without types of alternatives ("tools.spatula.shape.size_m"), or else the beginning of a word in the
/// names and descriptions of keys ("gravity", "stiff"). Throws InputError when there is none, with 'did you
/// mean' for a similar name.
std::vector<KeyPlace> findKeys(const std::string& wanted);

}  // namespace fissure
