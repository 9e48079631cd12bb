#include <array>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "scenario/key.h"
#include "scenario/load.h"
#include "text/scalars.h"

namespace fissure {

namespace {

std::string inlineText(double value) {
  return formatReal(value);
}
std::string inlineText(int value) {
  return std::to_string(value);
}
std::string inlineText(bool value) {
  return value ? "true" : "false";
}
std::string inlineText(const std::string& value) {
  return formatText(value);
}

template <class T, std::size_t N>
std::string inlineText(const std::array<T, N>& values) {
  std::string text = "[";
  for (std::size_t i = 0; i < N; ++i) text += (i ? ", " : "") + inlineText(values[i]);
  return text + "]";
}

std::string inlineText(const Vec3& v) {
  return inlineText(std::array<double, 3>{v.x(), v.y(), v.z()});
}
std::string inlineText(const Quat& q) {
  return inlineText(std::array<double, 4>{q.x(), q.y(), q.z(), q.w()});
}

template <class T>
concept Inline = requires(const T& value) {
  inlineText(value);
};

/// Writes one map in block style: an Io (scenario/key.h).
class MapWriter {
 public:
  explicit MapWriter(int indent) : indent_(indent) {}

  const std::string& lines() const { return lines_; }

  template <class T>
  void field(const char* name, T& value, const Key& key) {
    if (key.applies()) write(name, value, key);
  }
  template <class... Ts>
  void tagged(const char* name, std::variant<Ts...>& value, const Key& key) {
    MapWriter io(indent_ + 2);
    io.line("type", formatText(std::string((*key.table())[value.index()].name)));
    std::visit([&](auto& alternative) { describe(io, alternative); }, value);
    lines_ += pad(indent_) + name + ":\n" + io.lines_;
  }
  template <class Fill>
  void whileReading(Fill) {}  // what is written has every value

 private:
  template <class T>
  void write(const char* name, T& value, const Key& key) {
    if constexpr (std::is_enum_v<T>) {
      line(name, formatText(nameIn(*key.table(), value)));
    } else if constexpr (Inline<T>) {
      line(name, inlineText(value));
    } else {
      block(name, value);
    }
  }
  template <class T>
  void write(const char* name, std::optional<T>& value, const Key& key) {
    if (value) write(name, *value, key);
  }
  template <class T>
  void write(const char* name, std::vector<T>& values, const Key& key) {
    if (values.empty()) return line(name, "[]");
    lines_ += pad(indent_) + name + ":\n";
    for (T& value : values) item(value, key);
  }

  static std::string pad(int indent) { return std::string(static_cast<std::size_t>(indent), ' '); }

  void line(const char* key, const std::string& value) { lines_ += pad(indent_) + key + ": " + value + "\n"; }

  template <class T>
  void block(const char* key, T& value) {
    MapWriter io(indent_ + 2);
    describe(io, value);
    if (io.lines_.empty()) return line(key, "{}");
    lines_ += pad(indent_) + key + ":\n" + io.lines_;
  }

  template <class T>
  void item(T& value, const Key& key) {
    if constexpr (std::is_enum_v<T>) {
      lines_ += pad(indent_) + "  - " + formatText(nameIn(*key.table(), value)) + "\n";
    } else if constexpr (Inline<T>) {
      lines_ += pad(indent_) + "  - " + inlineText(value) + "\n";
    } else {
      MapWriter io(indent_ + 4);
      describe(io, value);
      // Every item has at least one line; its indentation makes room for the dash.
      lines_ += pad(indent_) + "  - " + io.lines_.substr(static_cast<std::size_t>(indent_) + 4);
    }
  }

  int indent_;
  std::string lines_;
};

}  // namespace

std::string toYaml(const Scenario& scenario) {
  Scenario copy = scenario;  // one describe() serves reading and writing, so it takes no const
  MapWriter io(0);
  describe(io, copy);
  return io.lines();
}

}  // namespace fissure
