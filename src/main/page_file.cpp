#include "main/page_file.h"

#include "process/apart.h"
#include "store/temporary_file.h"

namespace fissure {

void writePageApart(const std::filesystem::path& target, const std::function<std::string()>& make,
                    unsigned long most_s) {
  TemporaryFile temporary(target);
  doApart([&] { temporary.write(make()); }, most_s);
  temporary.commit();
}

}  // namespace fissure
