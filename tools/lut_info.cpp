#include <algorithm>
#include <cmath>
#include <limits>

#include "tools/lut.h"
#include "tools/report.h"
#include "tristim/core/text.h"
#include "tristim/lut/compose.h"

namespace tristim::tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kExamples =
    "  tristim lut bake --device crt-p22 -o crt.cube\n"
    "  tristim lut info crt.cube\n"
    "  tristim lut info crt.cube --json\n";

// What a step's entries are, beside what goes in.
struct Facts {
  std::string kind;
  std::vector<std::size_t> size;
  LutRange in;
  std::array<double, 3> low, high;  // of what comes out
  std::vector<std::string> shapes;  // of curves: "rises", "falls", "turns", "is level"
  double largest = 0, mean = 0;     // from the identity, of a channel
};

class Summary {
 public:
  void add(std::size_t channel, double in, double out) {
    low_[channel] = std::min(low_[channel], out);
    high_[channel] = std::max(high_[channel], out);
    const double off = std::fabs(out - in);
    largest_ = std::max(largest_, off);
    sum_ += off;
    ++count_;
  }
  void finish(Facts& facts) const {
    facts.low = low_;
    facts.high = high_;
    facts.largest = largest_;
    facts.mean = count_ > 0 ? sum_ / static_cast<double>(count_) : 0;
  }

 private:
  static constexpr double kInf = std::numeric_limits<double>::infinity();
  std::array<double, 3> low_{kInf, kInf, kInf}, high_{-kInf, -kInf, -kInf};
  double largest_ = 0, sum_ = 0;
  std::size_t count_ = 0;
};

std::string shape_of(const std::vector<float>& values) {
  bool up = false;
  bool down = false;
  bool level = false;
  for (std::size_t i = 1; i < values.size(); ++i) {
    up = up || values[i] > values[i - 1];
    down = down || values[i] < values[i - 1];
    level = level || values[i] == values[i - 1];
  }
  if (up && down) return "turns";
  if (!up && !down) return "is level";
  return std::string(up ? "rises" : "falls") + (level ? ", level in places" : "");
}

Facts facts_of(const LutPoints& points) {
  Facts facts{"points", {}, {}, {}, {}, {}};
  Summary summary;
  for (std::size_t c = 0; c < 3; ++c) {
    const LutCurve& curve = points.curves[c];
    facts.size.push_back(curve.in.size());
    facts.in.low[c] = curve.in.front();
    facts.in.high[c] = curve.in.back();
    facts.shapes.push_back(shape_of(curve.out));
    for (std::size_t i = 0; i < curve.in.size(); ++i) summary.add(c, curve.in[i], curve.out[i]);
  }
  summary.finish(facts);
  return facts;
}

Facts facts_of(const Lut1D& curves) {
  Facts facts = facts_of(points_of(curves));
  facts.kind = "curves";
  facts.size = {static_cast<std::size_t>(curves.size)};
  facts.in = curves.range;
  return facts;
}

Facts facts_of(const Lut3D& cube) {
  Facts facts{"cube", {static_cast<std::size_t>(cube.size)}, cube.range, {}, {}, {}};
  Summary summary;
  const auto n = static_cast<std::size_t>(cube.size);
  for (std::size_t i = 0; i < n * n * n; ++i) {
    const std::size_t at[] = {i % n, i / n % n, i / (n * n)};
    for (std::size_t c = 0; c < 3; ++c) {
      const double part = static_cast<double>(at[c]) / static_cast<double>(n - 1);
      const double in = cube.range.low[c] + (cube.range.high[c] - cube.range.low[c]) * part;
      summary.add(c, in, cube.rgb[3 * i + c]);
    }
  }
  summary.finish(facts);
  return facts;
}

// A matrix is described by the corners of the unit cube.
Facts facts_of(const LutMatrix& matrix) {
  Facts facts{"matrix", {3, 3}, {}, {}, {}, {}};
  Summary summary;
  for (int i = 0; i < 8; ++i) {
    const Rgb in{static_cast<double>(i & 1), static_cast<double>(i >> 1 & 1),
                 static_cast<double>(i >> 2)};
    const Rgb out = evaluate(LutStep(matrix), in);
    summary.add(0, in.r, out.r);
    summary.add(1, in.g, out.g);
    summary.add(2, in.b, out.b);
  }
  summary.finish(facts);
  return facts;
}

std::string triple(const std::array<double, 3>& x) {
  if (x[0] == x[1] && x[1] == x[2]) return rounded(x[0], 6);
  return rounded(x[0], 6) + " " + rounded(x[1], 6) + " " + rounded(x[2], 6);
}

std::string shapes_text(const Facts& facts) {
  if (facts.shapes.empty()) return "";
  const bool same = std::ranges::all_of(
      facts.shapes, [&](const std::string& shape) { return shape == facts.shapes[0]; });
  if (same) return "     each curve " + facts.shapes[0] + "\n";
  return "     red " + facts.shapes[0] + ", green " + facts.shapes[1] + ", blue " +
         facts.shapes[2] + "\n";
}

std::string info_text(const std::string& name, const Lut& lut) {
  std::string text = one_line(name) + ": " + lut_words(lut) + "\n";
  if (!lut.title.empty()) text += "  title: " + one_line(lut.title) + "\n";
  for (std::size_t i = 0; i < lut.steps.size(); ++i) {
    const Facts facts = std::visit([](const auto& s) { return facts_of(s); }, lut.steps[i]);
    text += "  " + std::to_string(i + 1) + ". " + facts.kind + ": in " + triple(facts.in.low) +
            " to " + triple(facts.in.high) + ", out " + triple(facts.low) + " to " +
            triple(facts.high) + "\n" + shapes_text(facts) + "     from the identity: largest " +
            rounded(facts.largest, 4) + ", mean " + rounded(facts.mean, 4) + "\n";
  }
  return text;
}

Json info_json(const std::string& name, const Lut& lut) {
  Json steps = Json::array();
  for (const LutStep& step : lut.steps) {
    const Facts facts = std::visit([](const auto& s) { return facts_of(s); }, step);
    Json entry{{"kind", facts.kind},       {"size", facts.size},   {"in_low", facts.in.low},
               {"in_high", facts.in.high}, {"out_low", facts.low}, {"out_high", facts.high}};
    if (!facts.shapes.empty()) {
      entry["monotone"] = std::ranges::none_of(
          facts.shapes, [](const std::string& shape) { return shape == "turns"; });
      entry["shapes"] = facts.shapes;
    }
    entry["identity_largest"] = facts.largest;
    entry["identity_mean"] = facts.mean;
    steps.push_back(entry);
  }
  return {{"file", name}, {"title", lut.title}, {"table", lut_words(lut)}, {"steps", steps}};
}

}  // namespace

void run_lut_info(Arguments arguments) {
  std::vector<std::string> names;
  bool json = false;
  CommandLine line(*lut_job("info"), kExamples);
  line.positional("LUT...", "tables; - is standard input", names, 1, 1 << 10);
  line.flag("--json", "print as JSON, a line a table", json);
  if (!line.parse(arguments)) return;
  for (const std::string& name : names) {
    const Lut lut = read_lut(name);
    print(json ? json_line(info_json(name, lut)) : info_text(name, lut));
  }
}

}  // namespace tristim::tools
