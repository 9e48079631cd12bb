#include "main/page_file.h"

#include "base/error.h"
#include "files/temporary_file.h"
#include "process/apart.h"

namespace fissure {

void writePageApart(const std::filesystem::path& target, const std::function<std::string()>& make,
                    const Allowance& allowance) {
  TemporaryFile temporary(target);
  const auto named = [&](const auto& writing) {
    try {
      writing();
    } catch (const RunError& error) {
      throw RunError(target.string() + ": " + error.what());
    }
  };
  doApart(
      [&] {
        const std::string page = make();
        named([&] { temporary.write(page); });
      },
      allowance);
  named([&] { temporary.commit(); });
}

}  // namespace fissure
