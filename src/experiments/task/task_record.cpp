#include "task/task_record.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>

#include "base/error.h"

namespace fissure {

namespace {

// A head in CBOR (RFC 8949), its length before it as 16 hexadecimal digits, and behind it the bytes that are
// many: single rows can be read without the rest. Numbers are the bytes they have in memory, exact, NaN and
// all; a sweep stays on machines of one byte order.
using nlohmann::json;

constexpr std::size_t length_digits = 16;

std::string withHead(const json& head, const std::string& behind) {
  std::string cbor;
  json::to_cbor(head, cbor);
  return fmt::format("{:0{}x}", cbor.size(), length_digits) + cbor + behind;
}

std::string bytesOf(const std::vector<double>& numbers) {
  std::string bytes(numbers.size() * sizeof(double), '\0');
  if (!bytes.empty()) std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

/// Reads the head, and says where it ends.
template <class Read>
auto readHead(const std::string& bytes, const Read& read) {
  try {
    const std::size_t length = std::strtoull(bytes.substr(0, length_digits).c_str(), nullptr, 16);
    if (bytes.size() < length_digits || bytes.size() - length_digits < length)
      throw RunError("no record of a sweep: its head is cut");
    return read(json::from_cbor(bytes.substr(length_digits, length)), length_digits + length);
  } catch (const json::exception& error) {
    throw RunError(std::string("no record of a sweep: ") + error.what());
  } catch (const InputError& error) {
    throw RunError(std::string("no record of a sweep: ") + error.what());
  }
}

/// An integer. A real number in its place is damage, and may not fit.
template <class Integer>
Integer integerAt(const json& from, const char* key) {
  const json& value = from.at(key);
  if (!value.is_number_integer()) throw RunError(fmt::format("no record of a sweep: {} is no integer", key));
  return value.get<Integer>();
}

/// A number of rows or of values in one, small enough that sizes in bytes do not overflow.
std::size_t countAt(const json& from, const char* key) {
  constexpr long long most = 1 << 30;
  const auto count = integerAt<long long>(from, key);
  if (count < 0 || count > most) throw RunError(fmt::format("no record of a sweep: {} is {}", key, count));
  return static_cast<std::size_t>(count);
}

}  // namespace

std::vector<double> numbersIn(const std::string& bytes) {
  std::vector<double> numbers(bytes.size() / sizeof(double));
  if (!numbers.empty()) std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(double));
  return numbers;
}

std::string encodeNumbers(const TaskNumbers& numbers) {
  return withHead({{"names", numbers.names},
                   {"rows", numbers.rows},
                   {"curves", numbers.curves.size() / std::max<std::size_t>(1, numbers.rows)},
                   {"texts", numbers.texts}},
                  bytesOf(numbers.values) + bytesOf(numbers.curves));
}

NumbersHead decodeNumbersHead(const std::string& bytes) {
  return readHead(bytes, [](const json& from, std::size_t end) {
    NumbersHead head{
        from.at("names"), from.at("texts"), countAt(from, "rows"), countAt(from, "curves"), end, 0};
    head.curves_at = end + head.rows * head.names.size() * sizeof(double);
    return head;
  });
}

TaskNumbers decodeNumbers(const std::string& bytes) {
  const NumbersHead head = decodeNumbersHead(bytes);
  if (bytes.size() != head.curves_at + head.rows * head.curve_values * sizeof(double))
    throw RunError("no record of a sweep: values are missing");
  return {head.names, head.rows, numbersIn(bytes.substr(head.values_at, head.curves_at - head.values_at)),
          numbersIn(bytes.substr(head.curves_at)), head.texts};
}

std::string encodeRecord(const TaskRecord& record) {
  return withHead({{"task", record.task},
                   {"status", nameOf(record.status.end)},
                   {"detail", record.status.detail},
                   {"timing", record.timing},
                   {"file", record.file},
                   {"file_bytes", record.file_bytes},
                   {"file_time", record.file_time},
                   {"recorded_s", record.recorded_s}},
                  record.numbers);
}

std::pair<TaskRecord, std::size_t> decodeRecordHead(const std::string& bytes) {
  return readHead(bytes, [](const json& from, std::size_t end) {
    TaskRecord record;
    record.task = from.at("task");
    record.status.end = runEndNamed(from.at("status"));
    record.status.detail = from.at("detail");
    record.timing = from.at("timing").get<std::map<std::string, double>>();
    record.file = from.at("file");
    record.file_bytes = integerAt<long long>(from, "file_bytes");
    record.file_time = integerAt<long long>(from, "file_time");
    record.recorded_s = integerAt<long long>(from, "recorded_s");
    return std::pair{record, end};
  });
}

TaskRecord decodeRecord(const std::string& bytes) {
  auto [record, end] = decodeRecordHead(bytes);
  record.numbers = bytes.substr(end);
  return record;
}

}  // namespace fissure
