#include "tools/shade_csv.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "tools/csv_lines.h"
#include "tristim/core/error.h"
#include "tristim/core/file.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim::tools {
namespace {

struct HeaderName {
  std::string name;
};

// One column of the model: where its values come from.
struct Source {
  std::string name;
  ColumnKind kind;
  std::optional<std::size_t> cell;  // of the file; else the option's value is set already
};

std::vector<Source> sources_of(const ShadeModel& model) {
  std::vector<Source> sources;
  for (const Column& column : model.inputs) {
    for (std::string& name : column_names(column)) {
      sources.push_back({std::move(name), column.kind, std::nullopt});
    }
  }
  return sources;
}

std::string_view plain_name(std::string_view name) {
  constexpr std::string_view kPrefix = "in_";
  if (name.starts_with(kPrefix)) name.remove_prefix(kPrefix.size());
  return name;
}

std::optional<std::size_t> position(const std::vector<std::string>& header, std::string_view name) {
  const auto same = [&](const std::string& cell) { return plain_name(cell) == name; };
  const auto found = std::find_if(header.begin(), header.end(), same);
  if (found == header.end()) return std::nullopt;
  return static_cast<std::size_t>(found - header.begin());
}

// Puts a cell or an option's text where the model reads it; `place` is for messages.
void set_value(ShadeRow& row, std::size_t column, const Source& source, const std::string& text,
               const std::string& place) {
  const std::string thing = place + ", column " + source.name;
  if (source.kind.is_text) {
    row.word_at(column) = text;
    return;
  }
  const auto value = parse_number(text);
  if (!value) {
    throw Error(ErrorKind::kContent, thing,
                text.empty() ? "is empty" : "'" + text + "' is no number",
                "give " + std::string(source.kind.range));
  }
  if (source.kind.allows != nullptr && !source.kind.allows(*value)) {
    throw Error(ErrorKind::kContent, thing, text + " is out of range",
                "give " + std::string(source.kind.range));
  }
  row.at(column) = *value;
}

class CsvShader {
 public:
  CsvShader(const ShadeModel& model, const FixedColumns& fixed, OutputFile& file)
      : model_(model),
        file_(file),
        sources_(sources_of(model)),
        in_(model.inputs),
        out_(model.outputs) {
    for (std::size_t i = 0; i < sources_.size(); ++i) {
      const auto option = fixed.find(sources_[i].name);
      if (option == fixed.end()) {
        missing_.push_back(i);
      } else {
        set_value(in_, i, sources_[i], option->second, "options");
      }
    }
  }

  /// Finds the columns that no option gives.
  void read_header(const std::vector<std::string>& header, const std::string& place) {
    cells_ = header.size();
    id_ = position(header, "id");
    for (const std::size_t i : missing_) {
      sources_[i].cell = position(header, sources_[i].name);
      if (!sources_[i].cell) refuse_missing(sources_[i].name, header, place);
    }
    write_header();
  }

  void evaluate(const std::vector<std::string>& cells, const std::string& place) {
    if (cells.size() != cells_) {
      throw Error(ErrorKind::kContent, place,
                  "has " + std::to_string(cells.size()) + " values, the header names " +
                      std::to_string(cells_),
                  "give each column a value");
    }
    for (const std::size_t i : missing_) {
      set_value(in_, i, sources_[i], cells[*sources_[i].cell], place);
    }
    try {
      model_.evaluate(in_, out_);
    } catch (const Error& error) {
      throw Error(ErrorKind::kContent, place, error.what());
    } catch (const std::invalid_argument& error) {
      throw Error(ErrorKind::kContent, place, error.what());
    }
    write_row(id_ ? &cells[*id_] : nullptr);
  }

  /// The one row that the options make.
  void evaluate_options() {
    if (!missing_.empty()) {
      throw Error(ErrorKind::kMisuse, model_.name,
                  "column " + sources_[missing_.front()].name + " is missing",
                  "give a CSV file, or --" + sources_[missing_.front()].name);
    }
    write_header();
    evaluate({}, "options");
  }

 private:
  [[noreturn]] void refuse_missing(const std::string& name, const std::vector<std::string>& header,
                                   const std::string& place) const {
    std::vector<HeaderName> names;
    for (const std::string& cell : header) {
      const std::string own(plain_name(cell));
      const auto same = [&](const Source& source) { return source.name == own; };
      if (std::none_of(sources_.begin(), sources_.end(), same)) names.push_back({own});
    }
    const std::string hint = name_hint(names, name);
    const bool near = hint.starts_with("did you mean");
    throw Error(ErrorKind::kContent, place,
                "column " + name + " is missing for " + std::string(model_.name),
                "add it or give --" + name +
                    (near ? " (the header has" + hint.substr(12, hint.size() - 13) + ")" : ""));
  }

  void write_header() {
    std::string line = id_ ? "id" : "";
    for (const std::string& name : column_names(model_.outputs)) {
      line += (line.empty() ? "" : ",") + name;
    }
    file_.write(line + "\n");
  }

  void write_row(const std::string* id) {
    std::string line = id == nullptr ? "" : csv_cell(*id) + ",";
    for (const double value : out_.numbers()) line += shortest(value) + ",";
    line.back() = '\n';
    file_.write(line);
  }

  const ShadeModel& model_;
  OutputFile& file_;
  std::vector<Source> sources_;
  ShadeRow in_, out_;
  std::vector<std::size_t> missing_;  // columns that no option gives
  std::optional<std::size_t> id_;
  std::size_t cells_ = 0;
};

bool is_skipped(std::string_view line) {
  return line.starts_with('#') || line.find_first_not_of(" \t") == std::string_view::npos;
}

}  // namespace

void shade_csv(const ShadeModel& model, const FixedColumns& fixed, const std::string& input,
               const std::string& output, bool replace) {
  OutputFile file(output, replace);
  CsvShader shader(model, fixed, file);
  if (input.empty()) {
    shader.evaluate_options();
    return file.commit();
  }
  const std::string name = input == "-" ? "standard input" : input;
  TextLines lines(input);
  std::string line;
  std::size_t row = 0;
  bool header = true;
  while (lines.next(line)) {
    if (is_skipped(line)) continue;
    if (header) {
      shader.read_header(csv_cells(line), name);
      header = false;
      continue;
    }
    shader.evaluate(csv_cells(line), name + ", row " + std::to_string(++row) + " (line " +
                                         std::to_string(lines.number()) + ")");
  }
  if (header) {
    throw Error(ErrorKind::kContent, name, "has no header row",
                "name the columns in the first row");
  }
  file.commit();
}

}  // namespace tristim::tools
