// What `compare --json` prints.
#include <nlohmann/json.hpp>

#include "main/comparison.h"

namespace fissure {

namespace {

using Json = nlohmann::ordered_json;

Json sideJson(const RunOfFile& side) {
  return {{"file", side.file.string()},
          {"name", side.run->name},
          {"status", nameOf(side.run->status.end)},
          {"reference", side.info->reference}};
}

Json placeJson(const std::optional<ValueIndex>& place, const std::string& name) {
  if (!place) return nullptr;
  return {{"row", place->row}, {"column", place->column}, {"name", name}};
}

Json quantityJson(const QuantityComparison& made) {
  const Difference& difference = made.difference;
  Json json = {{"quantity", made.quantity},
               {"units", made.units},
               {"agrees", made.agrees},
               {"equal", made.equal()},
               {"problem", made.problem}};
  if (made.text_a != made.text_b) json.update({{"text_a", made.text_a}, {"text_b", made.text_b}});
  if (made.scalar_a) json.update({{"value_a", *made.scalar_a}, {"value_b", *made.scalar_b}});
  if (difference.rows == 0) return json;
  json.update({{"largest_a", difference.largest_a},
               {"largest_b", difference.largest_b},
               {"largest_difference", difference.largest},
               {"allowed_absolute", made.tolerance.absolute},
               {"allowed_relative", made.tolerance.relative},
               {"allowed_time_shift_s", made.tolerance.time_shift_s},
               {"differing_values", difference.count},
               {"worst", placeJson(difference.worst, made.worst_at)},
               {"first", placeJson(difference.first, made.first_at)},
               {"first_row_beyond_tolerance", made.beyond_at}});
  if (made.shift)
    json.update({{"time_shift_s", made.shift_s}, {"largest_difference_shifted", made.shift->remaining}});
  return json;
}

Json runJson(const RunComparison& run) {
  Json quantities = Json::array();
  for (const QuantityComparison& made : run.quantities) quantities.push_back(quantityJson(made));
  return {{"a", sideJson(run.a)},
          {"b", sideJson(run.b)},
          {"agrees", run.agrees()},
          {"problems", run.problems},
          {"quantities", quantities}};
}

}  // namespace

Json comparisonJson(const ResultComparison& comparison) {
  Json runs = Json::array();
  for (const RunComparison& run : comparison.runs) runs.push_back(runJson(run));
  return {{"agrees", comparison.agrees()},
          {"problems", comparison.problems},
          {"notes", comparison.notes},
          {"runs", runs}};
}

}  // namespace fissure
