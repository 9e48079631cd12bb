#pragma once

#include <string>

#include "hdf5/h5.h"
#include "store/result_file.h"

namespace fissure {

/// The value of that name; "" where there is none.
std::string valueOf(const Provenance& provenance, const std::string& name);

/// What opens every finished file of ours, up to `format` and format_version: Conventions, title, summary,
/// source, history, date_created and id (of `content` and the date).
void describeRoot(hid_t file, const std::string& title, const std::string& summary,
                  const Provenance& provenance, const std::string& content, const std::string& format);

}  // namespace fissure
