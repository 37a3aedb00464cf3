#include "tools/commands.h"
#include "tools/outputs.h"
#include "tools/report.h"
#include "tools/shade_csv.h"
#include "tools/shade_list.h"
#include "tools/shade_model.h"
#include "tools/shade_paper.h"
#include "tristim/core/error.h"
#include "tristim/core/file.h"
#include "tristim/core/find.h"

namespace tristim::tools {
namespace {

constexpr std::string_view kExamples =
    "  tristim shade --list\n"
    "  tristim shade fresnel_dielectric --help\n"
    "  tristim shade fresnel_dielectric --cos_i 0.5 --eta_i 1 --eta_t 1.5\n"
    "  printf 'id,cos_i\\n1,1\\n2,0.1\\n' | tristim shade fresnel_conductor - --eta 0.18 --k 3.42\n"
    "  tristim shade tables --paper fisher-woo\n"
    "  tristim shade figures -o figures\n";

/// What `tristim shade` does beside evaluating models.
struct Job {
  std::string_view name;
  void (*run)(Arguments arguments);
};
constexpr Job kJobs[] = {{"tables", run_shade_tables}, {"figures", run_shade_figures}};

struct Options {
  std::vector<std::string> words;  // MODEL IN OUT
  FixedColumns fixed;
  bool force = false, list = false, json = false;
};

// The first word that is a model: its columns are options of this run.
const ShadeModel* model_in(Arguments arguments) {
  for (const std::string& argument : arguments) {
    if (const ShadeModel* model = find_by_name(shade_models(), argument)) return model;
  }
  return nullptr;
}

void declare_columns(CommandLine& line, const ShadeModel& model, FixedColumns& fixed) {
  line.section("Columns of " + std::string(model.name) + ", once for all rows");
  for (const Column& column : model.inputs) {
    for (const std::string& name : column_names(column)) {
      line.option("--" + name, "VALUE", std::string(column.kind.range),
                  [&fixed, name](const std::string& v) { fixed[name] = v; });
    }
  }
}

// A value of an option is JSON, or else a text.
Json option_value(const std::string& text) {
  Json value = Json::parse(text, nullptr, /*allow_exceptions=*/false);
  return value.is_discarded() ? Json(text) : value;
}

Json read_rows(const std::string& input) {
  if (input.empty()) return Json::array({Json::object()});
  const std::string name = input == "-" ? "standard input" : input;
  Json rows = Json::parse(read_text_file(input), nullptr, /*allow_exceptions=*/false);
  if (rows.is_object()) rows = Json::array({rows});
  if (rows.is_array()) return rows;
  throw Error(ErrorKind::kContent, name, "is no JSON list of objects", "write [{ ... }, { ... }]");
}

void shade_json(const ShadeModel& model, const Options& options, const std::string& input,
                const std::string& output) {
  OutputFile file(output, options.force);
  Json rows = read_rows(input);
  const std::string name = input.empty() ? "options" : input == "-" ? "standard input" : input;
  file.write("[");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string place =
        name + ", object " + std::to_string(i + 1) + " (" + std::string(model.name) + ")";
    (void)JsonRow(rows[i], place);  // an object
    for (const auto& [key, text] : options.fixed) rows[i][key] = option_value(text);
    Json answer = Json::object();
    if (rows[i].contains("id")) answer["id"] = rows[i]["id"];
    answer.update(model.answer(JsonRow(rows[i], place)));
    std::string line = json_line(answer);
    line.pop_back();
    file.write((i == 0 ? "\n" : ",\n") + line);
  }
  file.write("\n]\n");
  file.commit();
}

void check_model(const Options& options, const ShadeModel* model) {
  if (options.words.empty()) {
    throw Error(ErrorKind::kMisuse, "shade", "MODEL is missing",
                "use: tristim shade MODEL in.csv out.csv, or --list");
  }
  if (model == nullptr || !same_name(model->name, options.words[0])) {
    throw Error(ErrorKind::kMisuse, options.words[0], "unknown model",
                name_hint(shade_models(), options.words[0]));
  }
}

}  // namespace

void run_shade(Arguments arguments) {
  if (!arguments.empty()) {
    if (const Job* job = find_by_name(kJobs, arguments[0])) return job->run(arguments.subspan(1));
  }
  Options options;
  const ShadeModel* model = model_in(arguments);
  std::string examples(kExamples);
  if (model != nullptr) examples += "\n" + model_text(*model);
  CommandLine line(*find_by_name(kCommands, "shade"), examples);
  line.positional("MODEL", "one of --list, or tables, or figures", options.words, 0, 3);
  line.flag("-f,--force", "replace an existing file", options.force);
  line.flag("--list", "print the models with their inputs, outputs, formula and source",
            options.list);
  line.flag("--json", "with --list: as JSON", options.json);
  if (model != nullptr) declare_columns(line, *model, options.fixed);
  if (!line.parse(arguments)) return;
  if (options.list) return list_shade_models(options.json);
  check_model(options, model);
  const std::string input = options.words.size() > 1 ? options.words[1] : "";
  const std::string output = options.words.size() > 2 ? options.words[2] : "-";
  refuse_inputs_as_outputs({input}, {output});
  if (model->evaluate != nullptr) {
    return shade_csv(*model, options.fixed, input, output, options.force);
  }
  shade_json(*model, options, input, output);
}

}  // namespace tristim::tools
