#include "store/root_attributes.h"

#include <array>
#include <ctime>

#include "base/hash.h"
#include "store/format.h"

namespace fissure {

namespace {

std::string nowUtc() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text.data();
}

}  // namespace

std::string valueOf(const Provenance& provenance, const std::string& name) {
  for (const auto& [key, value] : provenance) {
    if (key == name) return value;
  }
  return "";
}

void describeRoot(hid_t file, const std::string& title, const std::string& summary,
                  const Provenance& provenance, const std::string& content, const std::string& format) {
  const std::string date = nowUtc();
  const std::string version = valueOf(provenance, "version");
  const std::string command = valueOf(provenance, "command_line");
  h5::setAttribute(file, "Conventions", std::string("CF-1.10, ACDD-1.3"));
  h5::setAttribute(file, "title", title);
  h5::setAttribute(file, "summary", summary);
  h5::setAttribute(file, "source", "fissure" + (version.empty() ? "" : " " + version));
  h5::setAttribute(file, "history", date + " " + (command.empty() ? "fissure" : command));
  h5::setAttribute(file, "date_created", date);
  h5::setAttribute(file, "id", fnv1a64(content + date));
  h5::setAttribute(file, "format", format);
  h5::setAttribute(file, "format_version", format_version);
}

}  // namespace fissure
