#include <nlohmann/json.hpp>

#include "lib/lut/io/formats.h"
#include "lib/lut/io/tables.h"
#include "tristim/core/error.h"
#include "tristim/core/text.h"

namespace tristim::detail {
namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void fail(const std::string& where, std::string_view wrong,
                       std::string_view remedy = {}) {
  throw Error(ErrorKind::kContent, where, wrong, remedy);
}

template <typename Number>
std::vector<Number> numbers(const Json& json, const char* key, const std::string& where) {
  const auto found = json.find(key);
  if (found == json.end() || !found->is_array()) {
    fail(where, std::string("has no list '") + key + "'");
  }
  std::vector<Number> values;
  values.reserve(found->size());
  for (const Json& item : *found) {
    if (!item.is_number()) {
      fail(where + ", '" + key + "' " + std::to_string(values.size()), "is no number");
    }
    values.push_back(static_cast<Number>(item.get<double>()));
  }
  return values;
}

std::array<double, 3> triple(const Json& json, const char* key, const std::string& where,
                             const std::array<double, 3>& absent) {
  if (!json.contains(key)) return absent;
  const std::vector<double> values = numbers<double>(json, key, where);
  if (values.size() != 3) fail(where, std::string("'") + key + "' has not three numbers");
  return {values[0], values[1], values[2]};
}

template <typename Table>
Table read_table(const Json& json, int most, const std::string& where) {
  Table table;
  const Json size = json.value("size", Json());
  if (!size.is_number_integer() || size.get<double>() < 2 || size.get<double>() > most) {
    fail(where, "has no size", "it is an integer from 2 to " + std::to_string(most));
  }
  table.size = size.get<int>();
  table.range.low = triple(json, "low", where, table.range.low);
  table.range.high = triple(json, "high", where, table.range.high);
  table.rgb = numbers<float>(json, "rgb", where);
  return table;
}

LutPoints read_points(const Json& json, const std::string& where) {
  const Json curves = json.value("curves", Json());
  if (!curves.is_array() || curves.size() != 3) fail(where, "has no three 'curves'");
  LutPoints points;
  for (std::size_t c = 0; c < 3; ++c) {
    if (!curves[c].is_object()) fail(where, "has a curve that is no object");
    points.curves[c] = {numbers<float>(curves[c], "in", where),
                        numbers<float>(curves[c], "out", where)};
  }
  return points;
}

LutMatrix read_matrix(const Json& json, const std::string& where) {
  const std::vector<double> values = numbers<double>(json, "matrix", where);
  if (values.size() != 9) fail(where, "has no matrix of nine numbers");
  const std::array<double, 3> offset = triple(json, "offset", where, {0, 0, 0});
  LutMatrix step;
  for (int i = 0; i < 9; ++i) step.matrix(i / 3, i % 3) = values[static_cast<std::size_t>(i)];
  for (int i = 0; i < 3; ++i) step.offset(i) = offset[static_cast<std::size_t>(i)];
  return step;
}

LutStep read_step(const Json& json, const std::string& where) {
  const Json kind = json.is_object() ? json.value("kind", Json()) : Json();
  if (kind == "curves") return read_table<Lut1D>(json, kMostCurveSize, where);
  if (kind == "cube") return read_table<Lut3D>(json, kMostCubeSize, where);
  if (kind == "points") return read_points(json, where);
  if (kind == "matrix") return read_matrix(json, where);
  fail(where, "has no kind", "it is \"curves\", \"cube\", \"points\" or \"matrix\"");
}

Json parsed(std::string_view bytes, const std::string& file) {
  try {
    return Json::parse(without_utf8_mark(bytes));
  } catch (const Json::parse_error& error) {
    fail(file + ", byte " + std::to_string(error.byte), "is not valid JSON");
  } catch (const Json::exception&) {
    fail(file, "has a number that is too large");
  }
}

std::string quoted(const std::string& text) {
  return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

template <typename List>
std::string list_text(const List& list) {
  std::string text = "[";
  for (const double value : list) text += (text.size() > 1 ? ", " : "") + shortest(value);
  return text + "]";
}

void append_floats(std::string& text, const std::vector<float>& values, std::size_t a_line) {
  text += '[';
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) text += i % a_line == 0 ? ",\n    " : ", ";
    append_float(text, values[i]);
  }
  text += ']';
}

template <typename Table>
void append_table(std::string& text, const char* kind, const Table& table) {
  text += std::string("{\"kind\": \"") + kind + "\", \"size\": " + std::to_string(table.size) +
          ", \"low\": " + list_text(table.range.low) +
          ", \"high\": " + list_text(table.range.high) + ",\n   \"rgb\": ";
  append_floats(text, table.rgb, 3);
  text += '}';
}

void append(std::string& text, const Lut1D& step) { append_table(text, "curves", step); }
void append(std::string& text, const Lut3D& step) { append_table(text, "cube", step); }

void append(std::string& text, const LutPoints& step) {
  text += "{\"kind\": \"points\", \"curves\": [";
  for (std::size_t c = 0; c < 3; ++c) {
    text += c > 0 ? ",\n   {\"in\": " : "\n   {\"in\": ";
    append_floats(text, step.curves[c].in, 12);
    text += ",\n    \"out\": ";
    append_floats(text, step.curves[c].out, 12);
    text += '}';
  }
  text += "]}";
}

void append(std::string& text, const LutMatrix& step) {
  std::array<double, 9> rows{};
  for (int i = 0; i < 9; ++i) rows[static_cast<std::size_t>(i)] = step.matrix(i / 3, i % 3);
  const std::array<double, 3> offset{step.offset(0), step.offset(1), step.offset(2)};
  text += "{\"kind\": \"matrix\", \"matrix\": " + list_text(rows) +
          ", \"offset\": " + list_text(offset) + "}";
}

}  // namespace

// {"title": ..., "steps": [{"kind": "curves", "size": ..., "low": ..., "high": ..., "rgb": [...]}]}
Lut read_json_lut(std::string_view bytes, const std::string& file,
                  const LutFileOptions& /*options*/) {
  const Json json = parsed(bytes, file);
  if (!json.is_object() || !json.contains("steps") || !json["steps"].is_array()) {
    fail(file, "has no list of steps", "write {\"title\": \"...\", \"steps\": [...]}");
  }
  Lut lut;
  if (json.contains("title") && json["title"].is_string()) {
    lut.title = json["title"].get<std::string>();
  }
  for (const Json& step : json["steps"]) {
    lut.steps.push_back(read_step(step, file + ", step " + std::to_string(lut.steps.size() + 1)));
  }
  return lut;
}

std::string write_json_lut(const Lut& lut, const LutFileOptions& /*options*/) {
  std::string text = "{\"title\": " + quoted(lut.title) + ",\n \"steps\": [";
  for (std::size_t i = 0; i < lut.steps.size(); ++i) {
    text += i > 0 ? ",\n  " : "\n  ";
    std::visit([&](const auto& step) { append(text, step); }, lut.steps[i]);
  }
  return text + "]}\n";
}

}  // namespace tristim::detail
