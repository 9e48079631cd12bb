// The entry of libFuzzer. The environment says which target it is, so that processes which libFuzzer starts
// know too.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const fissure::fuzz::Target& target = []() -> const fissure::fuzz::Target& {
    const char* name = std::getenv("FISSURE_FUZZ");
    return fissure::fuzz::targetNamed(name ? name : "");
  }();
  target.take(std::string(reinterpret_cast<const char*>(bytes), size));
  return 0;
}
