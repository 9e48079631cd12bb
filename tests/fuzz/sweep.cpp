#include "sweep/sweep_file.h"
#include "sweep/sweep_manifest.h"
#include "sweep/sweep_points.h"
#include "target.h"

namespace fissure::fuzz {

/// The points of a sweep that is accepted, and all else of it, read back from a manifest.
void takeSweep(const std::string& bytes) {
  const std::filesystem::path file = put("fuzzed.yaml", bytes);
  SweepManifest manifest;
  SweepSettings& settings = manifest.settings;
  if (!accepts(file, ofYaml(bytes), [&] { settings = loadSweep(file); })) return;
  require(settings.source == bytes, "the source is the file");
  const double designed = SweepPoints::designed(settings);
  require(designed >= 1, "a sweep has points");
  constexpr double most_points = 2000;
  if (designed > most_points) return;
  manifest.points = SweepPoints(settings);
  require(static_cast<double>(manifest.points.size()) <= designed, "no point is added to the design");
  if (manifest.points.size() == 0) return;
  manifest.pipelines = {"swept"};
  const std::string text = manifestText(manifest);
  put("sweep/manifest.json", text);
  require(manifestText(readManifest(scratch() / "sweep")) == text, "a manifest reads back");
}

}  // namespace fissure::fuzz
