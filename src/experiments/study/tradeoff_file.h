#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scenario/key_tree.h"
#include "study/tradeoff_limits.h"
#include "sweep/sweep_axes.h"
#include "sweep/sweep_file.h"

namespace fissure {

enum class StudyDesign { star, grid };
/// Which number of a difference of curves counts as the error.
enum class ErrorMeasure { rms, worst, peak };

/// The names that study files can choose, in the order of their enums.
const std::vector<CatalogEntry>& studyDesigns();
const std::vector<CatalogEntry>& errorMeasures();

/// A quantity whose error is judged.
struct StudyError {
  ErrorQuantity quantity = ErrorQuantity::depth;
  std::optional<std::string> law;
  std::string tolerance;
  ErrorMeasure measure = ErrorMeasure::rms;
  ErrorSize size;  ///< `tolerance`, read
};

/// What errors are measured against.
struct StudyReference {
  std::optional<std::string> pipeline;
  AxisGroup ladder;
  std::vector<double> sizes;
};

/// The contents of a study file of the kind `tradeoff`.
struct TradeoffStudy {
  int format = 1;
  std::string name;
  std::string description;
  std::string base;
  std::vector<std::string> pipelines;
  std::vector<AxisGroup> axes;
  StudyDesign design = StudyDesign::star;
  StudyReference reference;
  std::vector<StudyError> errors;
  int repeats = 3;
  SweepLimits limits;
  std::string source;               ///< text of the file, verbatim
  std::filesystem::path file;       ///< the study file
  std::filesystem::path directory;  ///< its folder
};

/// Reads a study file as strictly as a scenario. Throws InputError with file and line, also for a ladder of
/// fewer than three rungs or whose sizes do not fall, and a quantity that is judged twice.
TradeoffStudy loadTradeoff(const std::filesystem::path& file);

/// The keys of such files.
KeyNode tradeoffKeys();

template <class Io>
void describe(Io& io, StudyReference& reference) {
  io.field("pipeline", reference.pipeline,
           Key("Name of the run that all others are compared with, refined by the ladder.")
               .otherwise("each run is compared with itself, refined"));
  io.field(
      "ladder", reference.ladder,
      Key("An axis, or zipped ones, from coarse to fine: at least three rungs. All other axes have their "
          "first values.")
          .required());
  io.field(
      "sizes", reference.sizes,
      Key("The size of each rung, as the width of a mesh, by which the order of convergence is observed; "
          "empty: the values of the ladder's first axis.")
          .unit("any, the same for all"));
}

template <class Io>
void describe(Io& io, StudyError& error) {
  io.field("quantity", error.quantity,
           Key("What the error is of, over the whole run.").oneOf(errorQuantities()).required());
  io.field("law", error.law,
           Key("Name of the scenario's force law; for the quantity `force`.").otherwise("the first law"));
  io.field(
      "tolerance", error.tolerance,
      Key("The error that counts as 1 where several are weighed: a size with its unit, or a share of the "
          "reference's peak, as 0.1mm, 0.05N, 2%.")
          .required());
  io.field("measure", error.measure, Key("Which number of the difference counts.").oneOf(errorMeasures()));
}

template <class Io>
void describe(Io& io, TradeoffStudy& study) {
  io.field("format", study.format, Key("Format of the file.").count(1, 1).required());
  io.field("name", study.name,
           Key("Name of the study and of its folder: 1 to 64 letters, digits, '_' and '-'.")
               .itemName()
               .required());
  io.field("description", study.description, Key("One line that says what the study is for.").mayBeEmpty());
  io.field("base", study.base,
           Key("Scenario file whose places the axes change, relative to the folder of the study file.")
               .required());
  io.field("pipelines", study.pipelines,
           Key("Names of the scenario's runs that are compared; empty for all."));
  io.field("axes", study.axes,
           Key("Places of the scenario and the values that they take; the first of each belongs to the "
               "setting that the others are varied about.")
               .items(1, any_number)
               .required());
  io.field("design", study.design, Key("Which settings of the axes are run.").oneOf(studyDesigns()));
  io.field("reference", study.reference, Key("What errors are measured against.").required());
  io.field("errors", study.errors, Key("The errors that settings are judged by.").items(1).required());
  io.field(
      "repeats", study.repeats,
      Key("How often every setting is run, in turns with the others, for the spread of its cost.").count(1));
  io.field("limits", study.limits, Key("What each simulation may take."));
}

}  // namespace fissure
