#include "tristim/color/conversion.h"

#include <algorithm>

#include "lib/color/direct_edges.h"
#include "lib/color/matrix_text.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"

namespace tristim {
namespace {

// From the root to a model.
using Chain = std::vector<const ColorModel*>;

Chain chain_of(const ColorModel& model) {
  Chain chain;
  for (const ColorModel* m = &model; m != nullptr; m = base_of(*m)) chain.push_back(m);
  std::reverse(chain.begin(), chain.end());
  return chain;
}

bool has_rgb(const Chain& chain) {
  return std::any_of(chain.begin(), chain.end(),
                     [](const ColorModel* m) { return m->reads_primaries; });
}

// One side of a conversion, and the white that its model or its name fixes.
struct Side {
  Chain chain;
  ModelContext context;
  std::optional<Chromaticity> white;
};

void use_set(ModelContext& context, std::string_view name) {
  const NamedPrimaries* set = find_by_name(primaries_list(), name);
  context.primaries = set->primaries;
  context.curve = parse_rgb_curve(set->transfer).value_or(RgbCurve{});
}

Side side_of(const ModelReference& own, const ModelReference& other) {
  Side side{chain_of(*own.model), {}, own.white};
  const ModelReference& named = own.primaries ? own : other;
  side.context.primaries = named.primaries.value_or(Primaries{});
  side.context.curve = named.curve.value_or(RgbCurve{});
  side.context.parameters = own.parameters;
  for (const ColorModel* model : side.chain) {
    if (!model->fixed_primaries.empty()) use_set(side.context, model->fixed_primaries);
    if (!model->fixed_white.empty()) {
      side.white = find_by_name(kWhitePoints, model->fixed_white)->chromaticity;
    }
  }
  if (has_rgb(side.chain)) side.white = side.context.primaries.white;
  return side;
}

// Whether the edge between a model and its base is the same on both sides.
bool same_edge(const ColorModel& model, const ModelContext& a, const ModelContext& b) {
  return (!model.base.empty() || a.white == b.white) &&
         (!model.reads_primaries || a.primaries == b.primaries) &&
         (!model.reads_curve || a.curve == b.curve) &&
         (model.parameters.empty() || a.parameters == b.parameters);
}

// How many models from the root on the two sides have in common.
std::size_t common_length(const Side& from, const Side& to) {
  std::size_t n = 0;
  while (n < from.chain.size() && n < to.chain.size() && from.chain[n] == to.chain[n] &&
         same_edge(*from.chain[n], from.context, to.context)) {
    ++n;
  }
  return n;
}

ConversionStep step_up(const ColorModel& model, const ModelContext& context) {
  ConversionStep step{&model,        base_of(model), model.to_base, context, model.reads_primaries,
                      model.formula, model.source};
  if (model.reads_primaries) step.context.matrix = xyz_from_rgb(context.primaries);
  if (step.apply != nullptr) return step;
  throw Error(ErrorKind::kMisuse, model.name, "no way leads from it", "it can only be a target");
}

ConversionStep step_down(const ColorModel& model, const ModelContext& context) {
  ConversionStep step{base_of(model),        &model,        model.from_base, context,
                      model.reads_primaries, model.formula, model.source};
  if (model.reads_primaries) step.context.matrix = rgb_from_xyz(context.primaries);
  if (step.apply != nullptr) return step;
  throw Error(ErrorKind::kMisuse, model.name, "no way leads to it", "it can only be a source");
}

}  // namespace

ColorConversion::ColorConversion(const ModelReference& from, const ModelReference& to,
                                 Adaptation adaptation)
    : from_(from.model), to_reference_(to), adaptation_(adaptation) {
  Side source = side_of(from, to);
  Side target = side_of(to, from);
  source.context.white = source.white.value_or(target.white.value_or(kD65));
  target.context.white = target.white.value_or(source.context.white);
  from_white_ = source.context.white;
  to_white_ = target.context.white;
  to_reference_.primaries = target.context.primaries;
  to_reference_.curve = target.context.curve;
  to_reference_.white = to_white_;
  const std::size_t common = common_length(source, target);
  for (std::size_t i = source.chain.size(); i > std::max<std::size_t>(common, 1); --i) {
    steps_.push_back(step_up(*source.chain[i - 1], source.context));
  }
  if (common == 0 && adaptation != Adaptation::kNone) {
    steps_.push_back(detail::adaptation_step(source.context, to_white_, adaptation));
  }
  for (std::size_t i = std::max<std::size_t>(common, 1); i < target.chain.size(); ++i) {
    steps_.push_back(step_down(*target.chain[i], target.context));
  }
  detail::use_direct_edges(steps_, adaptation);
}

Components ColorConversion::operator()(const Components& c) const {
  Components color = c;
  for (const ConversionStep& step : steps_) color = step.apply(color, step.context);
  return color;
}

std::string ColorConversion::explain_whites() const {
  std::string text =
      "white " + detail::white_text(from_white_) + " to " + detail::white_text(to_white_) + ": ";
  for (const AdaptationMethod& known : kAdaptations) {
    if (known.method == adaptation_) {
      text += std::string(known.name) + " " + std::string(known.source);
    }
  }
  return text;
}

std::vector<std::string> ColorConversion::explain() const {
  std::vector<std::string> lines;
  for (const ConversionStep& step : steps_) {
    const bool up = base_of(*step.from) == step.to;
    const bool down = base_of(*step.to) == step.from;
    const bool between_whites = !up && !down && from_white_ != to_white_;
    const bool adapts = between_whites && step.from == step.to && step.from->base.empty();
    std::string line = std::string(step.from->name) + " to " + std::string(step.to->name) + ": " +
                       std::string(step.formula) + " " + std::string(step.source);
    if (adapts) line = explain_whites();
    if (step.has_matrix) line += "; matrix " + detail::matrix_text(step.context.matrix);
    if (between_whites && !adapts) line += "; in it " + explain_whites();
    const ColorModel& model = down ? *step.to : *step.from;
    if (model.numbers != nullptr) line += "; " + model.numbers(step.context);
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace tristim
