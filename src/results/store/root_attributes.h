#pragma once

#include <string>

#include "hdf5/h5.h"
#include "store/result_file.h"

namespace fissure {

/// The value of an entry of the provenance; "" where there is none of that name.
std::string valueOf(const Provenance& provenance, const std::string& name);

/// Sets the root attributes of every finished file: Conventions, title, summary, source, history,
/// date_created, id (a hash of `content` and the date), `format` and format_version.
void describeRoot(hid_t file, const std::string& title, const std::string& summary,
                  const Provenance& provenance, const std::string& content, const std::string& format);

}  // namespace fissure
