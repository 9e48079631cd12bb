// Takes files as a fuzzer does, without libFuzzer:
//   fuzz_replay TARGET LIST     LIST: a file of paths, with commas between them
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <string>

#include "target.h"

namespace {

std::string bytesOf(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

int main(int count, char** words) {
  if (count != 3) {
    std::cerr << "usage: fuzz_replay TARGET LIST\n";
    return 2;
  }
  const fissure::fuzz::Target& target = fissure::fuzz::targetNamed(words[1]);
  std::istringstream list(bytesOf(words[2]));
  std::size_t taken = 0;
  for (std::string file; std::getline(list, file, ','); ++taken) {
    std::cout << file << std::endl;  // flushed: the last line names the file that crashes
    target.take(bytesOf(file));
  }
  std::cout << taken << " inputs taken" << std::endl;
  return taken > 0 ? 0 : 1;
}
