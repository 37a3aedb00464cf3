#include "tools/halftone.h"
#include "tools/report.h"
#include "tristim/core/error.h"
#include "tristim/core/file.h"
#include "tristim/core/find.h"
#include "tristim/dither/growth.h"
#include "tristim/dither/io/matrix_file.h"
#include "tristim/dither/matrices.h"
#include "tristim/dither/matrix_text.h"

namespace tristim::tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kExamples =
    "  tristim halftone judge d3\n"
    "  tristim halftone judge clustered16 --json\n"
    "  printf '0 2\\n3 1\\n' > own.csv && tristim halftone judge own.csv\n"
    "  printf '00\\n00\\n\\n10\\n00\\n\\n11\\n00\\n' > list.txt && tristim halftone judge "
    "list.txt\n";

// A name, or a file of a matrix or of patterns.
PatternSequence sequence_of(const std::string& name, const MatrixOptions& options) {
  const bool is_text = !find_matrix_recipe(name) && name != "-" && !begins_as_picture(name);
  if (is_text) {
    try {
      if (auto list = parse_patterns(read_text_file(name), name)) return std::move(*list);
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::kSystem) throw;  // halftone_matrix() knows what to tell
    }
  }
  return pattern_sequence(halftone_matrix(name, options));
}

std::string verdict(const GrowthFinding& finding) { return finding.holds ? "holds" : "fails"; }

std::string findings_text(const PatternSequence& sequence) {
  std::string text = sequence.name + ": " + std::to_string(sequence.width) + " x " +
                     std::to_string(sequence.height) + ", " +
                     std::to_string(sequence.steps.size() + 1) + " levels [Shoaff 2.1.2]\n";
  for (const GrowthGuideline& guideline : growth_guidelines()) {
    const GrowthFinding finding = guideline.judge(sequence);
    text += "\n" + std::string(guideline.name) + ": " + std::string(guideline.text) + "\n   " +
            verdict(finding) + ": " + finding.text +
            "\n   measure: " + std::string(guideline.measure) + "\n";
  }
  return text;
}

Json findings_json(const PatternSequence& sequence) {
  Json findings = Json::array();
  for (const GrowthGuideline& guideline : growth_guidelines()) {
    const GrowthFinding finding = guideline.judge(sequence);
    Json measures = Json::object();
    for (const auto& [name, value] : finding.measures) measures[name] = number_json(value);
    findings.push_back({{"guideline", guideline.name},
                        {"text", guideline.text},
                        {"verdict", verdict(finding)},
                        {"finding", finding.text},
                        {"measure", guideline.measure},
                        {"measures", measures}});
  }
  return {{"name", sequence.name},
          {"width", sequence.width},
          {"height", sequence.height},
          {"levels", sequence.steps.size() + 1},
          {"guidelines", findings}};
}

}  // namespace

void run_halftone_judge(Arguments arguments) {
  std::vector<std::string> names;
  MatrixOptions options;
  bool json = false;
  CommandLine line(*halftone_job("judge"), kExamples);
  line.positional("NAME",
                  "a matrix, or a file: your own matrix, or patterns of 0 and 1 with empty lines "
                  "between them",
                  names, 1, 1);
  declare_matrix_options(line, options);
  line.flag("--json", "print the findings as JSON", json);
  if (!line.parse(arguments)) return;
  const PatternSequence sequence = sequence_of(names[0], options);
  print(json ? json_line(findings_json(sequence)) : findings_text(sequence));
}

}  // namespace tristim::tools
