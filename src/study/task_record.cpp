#include "study/task_record.h"

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>

#include "base/error.h"

namespace fissure {

namespace {

// CBOR (RFC 8949). Numbers go in as the bytes they have in memory: exact, NaN and all; a sweep stays on
// machines of one byte order.
using nlohmann::json;

json bytesOf(const std::vector<double>& numbers) {
  std::vector<std::uint8_t> bytes(numbers.size() * sizeof(double));
  if (!bytes.empty()) std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return json::binary(std::move(bytes));
}

std::vector<double> numbersIn(const json& binary) {
  const auto& bytes = binary.get_binary();
  std::vector<double> numbers(bytes.size() / sizeof(double));
  if (!numbers.empty()) std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(double));
  return numbers;
}

std::string cborOf(const json& value) {
  std::string bytes;
  json::to_cbor(value, bytes);
  return bytes;
}

template <class Read>
auto decode(const std::string& bytes, const Read& read) {
  try {
    return read(json::from_cbor(bytes));
  } catch (const json::exception& error) {
    throw RunError(std::string("no record of a sweep: ") + error.what());
  }
}

}  // namespace

std::string encodeNumbers(const TaskNumbers& numbers) {
  return cborOf({{"names", numbers.names},
                 {"rows", numbers.rows},
                 {"values", bytesOf(numbers.values)},
                 {"curves", bytesOf(numbers.curves)},
                 {"texts", numbers.texts}});
}

TaskNumbers decodeNumbers(const std::string& bytes) {
  return decode(bytes, [](const json& from) {
    TaskNumbers numbers{from.at("names"), from.at("rows"), numbersIn(from.at("values")),
                        numbersIn(from.at("curves")), from.at("texts")};
    if (numbers.values.size() != numbers.rows * numbers.names.size())
      throw RunError("no record of a sweep: values are missing");
    return numbers;
  });
}

std::string encodeRecord(const TaskRecord& record) {
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(record.numbers.data());
  return cborOf({{"task", record.task},
                 {"status", record.status.status},
                 {"detail", record.status.detail},
                 {"numbers", json::binary({bytes, bytes + record.numbers.size()})},
                 {"timing", record.timing},
                 {"file", record.file},
                 {"file_bytes", record.file_bytes},
                 {"file_time", record.file_time}});
}

TaskRecord decodeRecord(const std::string& bytes) {
  return decode(bytes, [](const json& from) {
    const auto& numbers = from.at("numbers").get_binary();
    TaskRecord record;
    record.task = from.at("task");
    record.status = {from.at("status"), from.at("detail")};
    record.numbers.assign(numbers.begin(), numbers.end());
    record.timing = from.at("timing").get<std::map<std::string, double>>();
    record.file = from.at("file");
    record.file_bytes = from.at("file_bytes");
    record.file_time = from.at("file_time");
    return record;
  });
}

}  // namespace fissure
