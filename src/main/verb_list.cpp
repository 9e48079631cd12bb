#include <unistd.h>

#include <array>
#include <iomanip>
#include <iostream>
#include <string_view>
#include <utility>

#include "law/force_law.h"
#include "main/exit_codes.h"
#include "main/verbs.h"
#include "process/progress_display.h"
#include "scenario/catalog.h"
#include "text/scalars.h"
#include "text/wrapped.h"

namespace fissure {

namespace {

constexpr std::string_view tissues_title =
    "tissues (fits F = k d^n to the depth d of a whole probe with a round tip of 4 mm radius in liver, 3.16 "
    "mm else: github.com/vu-arma-dev/robot-palpation-data. A law sums over triangles, so its exponent is "
    "then "
    "the tissue's, the size of its force is not. lambda = k x 0.5 s/m is an assumption)";

/// "k 200 N/m^n, lambda 50 N s/m^(n+1), n 1.3": what a scenario that leaves them out gets.
std::string defaultsOf(const ForceLawEntry& law) {
  std::string text;
  for (const LawCoefficient& of : law.coefficients) {
    text.append(text.empty() ? "" : ", ").append(of.name).append(" ").append(formatReal(of.default_value));
    if (of.unit != "1") text.append(" ").append(of.unit);
  }
  return text;
}

int listCatalog() {
  const Catalog& tables = catalog();
  using Table = std::pair<std::string_view, const std::vector<CatalogEntry>&>;
  const std::array<Table, 27> named = {{{"pipelines", tables.pipelines},
                                        {"force laws", tables.force_laws},
                                        {tissues_title, tables.tissues},
                                        {"body models", tables.body_models},
                                        {"elastic materials", tables.elastic_materials},
                                        {"elastic presets", tables.elastic_presets},
                                        {"body shapes", tables.body_shapes},
                                        {"tool shapes", tables.tool_shapes},
                                        {"node placements", tables.node_placements},
                                        {"clamp openings", tables.clamp_openings},
                                        {"motions", tables.motions},
                                        {"timings", tables.timings},
                                        {"interpolations", tables.interpolations},
                                        {"log layouts", tables.log_layouts},
                                        {"device frames", tables.device_frames},
                                        {"settings", tables.settings},
                                        {"deformable contacts", tables.deformable_contacts},
                                        {"responses", tables.responses},
                                        {"ground contacts", tables.ground_contacts},
                                        {"precisions", tables.precisions},
                                        {"rates", tables.rates},
                                        {"deformations", tables.deformations},
                                        {"aero models", tables.aero_models},
                                        {"soft contacts", tables.soft_contacts},
                                        {"length units", tables.length_units},
                                        {"time units", tables.time_units},
                                        {"mesh repairs", tables.mesh_repairs}}};
  const std::size_t columns = terminalColumns(STDOUT_FILENO).value_or(std::string::npos);
  for (const auto& [title, entries] : named) {
    std::cout << wrapped(std::string(title), 2, columns);
    for (const CatalogEntry& entry : entries) {
      std::string text(entry.description);
      if (&entries == &tables.force_laws)
        text += " (default: " + defaultsOf(entryOf(*modelNamed(entry.name))) + ")";
      std::cout << "  " << std::left << std::setw(20) << entry.name << "  " << wrapped(text, 24, columns);
    }
  }
  return exit_good;
}

}  // namespace

Verb addList(Command app) {
  Command command = app.command("list", "what a scenario can choose from");
  command.example("fissure list | less");
  return {command, [] { return listCatalog(); }};
}

}  // namespace fissure
