#include "tristim/pipeline/plan.h"

#include <utility>

#include "lib/core/math.h"
#include "lib/pipeline/stage_rows.h"
#include "tristim/core/instruction_sets.h"
#include "tristim/core/text.h"

namespace tristim {
namespace {

// Of a stage that multiplies.
std::optional<Eigen::Matrix3d> matrix_of(const Stage& stage) {
  if (const auto* exposure = std::get_if<Exposure>(&stage)) {
    return Eigen::Matrix3d::Identity() * detail::pow(2, exposure->stops);
  }
  if (const auto* primaries = std::get_if<ConvertPrimaries>(&stage)) return primaries->matrix;
  return std::nullopt;
}

void add_name(std::string& names, const std::string& name) {
  if (name.empty()) return;
  names += (names.empty() ? "" : ", ") + name;
}

// Takes the last passes off the plan that the pass that makes the codes does first.
void take_lead(Plan& plan) {
  const auto last = [&]() -> Pass* { return plan.passes.empty() ? nullptr : &plan.passes.back(); };
  const auto* map = last() != nullptr ? std::get_if<GamutMap>(&last()->work) : nullptr;
  if (map != nullptr && map->method.map == gamut_clip) {
    plan.lead.clip = true;
    plan.lead.stages = last()->stages;
    plan.passes.pop_back();
  }
  const auto* multiply = last() != nullptr ? std::get_if<Multiply>(&last()->work) : nullptr;
  if (multiply == nullptr) return;
  plan.lead.multiply = *multiply;
  std::string names = last()->stages;
  add_name(names, plan.lead.stages);
  plan.lead.stages = names;
  plan.passes.pop_back();
}

void apply_pass(const Multiply& multiply, Band band, StageCounts&) {
  const detail::RowMatrix matrix(multiply);
  detail::stage_kernels().multiply(matrix, band.view.row(0).data(),
                                   static_cast<std::size_t>(band.view.width));
}

template <typename StageOfRows>
void apply_pass(const StageOfRows& stage, Band band, StageCounts& counts) {
  apply(Stage(stage), band, counts);
}

std::string matrix_text(const Eigen::Matrix3f& m) {
  std::string text;
  for (int i = 0; i < 9; ++i) {
    text += i == 0 ? "" : i % 3 == 0 ? "; " : " ";
    text += rounded(m(i / 3, i % 3), 7);
  }
  return text;
}

}  // namespace

Plan plan_chain(std::span<const Stage> stages, bool leads) {
  Plan plan;
  Eigen::Matrix3d product = Eigen::Matrix3d::Identity();
  std::string names;  // of the stages in the product
  const auto end_product = [&] {
    if (!product.isIdentity(0)) {
      plan.passes.push_back({Multiply{product.cast<float>()}, std::exchange(names, {})});
    }
    product.setIdentity();
    names.clear();
  };
  for (const Stage& stage : stages) {
    const std::string name = explain(stage).name;
    if (const auto matrix = matrix_of(stage)) {
      product = *matrix * product;
      add_name(names, name);
      continue;
    }
    end_product();
    if (const auto* tone = std::get_if<ToneMap>(&stage)) plan.passes.push_back({*tone, name});
    if (const auto* map = std::get_if<GamutMap>(&stage)) plan.passes.push_back({*map, name});
  }
  end_product();
  if (leads) take_lead(plan);
  return plan;
}

void apply(const Plan& plan, Band band, StageCounts& counts) {
  for (int row = 0; row < band.view.height; ++row) {
    const Band one{band.view.rows(row, 1), band.y0 + row, {}};
    for (const Pass& pass : plan.passes) {
      std::visit([&](const auto& work) { apply_pass(work, one, counts); }, pass.work);
    }
  }
}

StepReport explain(const Plan& plan, const std::string& codes) {
  StepReport step{"plan", "each pass over a row while it lies in the nearest cache", "", {}};
  int count = 0;
  const auto add = [&](const std::string& names, const Multiply* multiply) {
    const std::string number = std::to_string(++count);
    step.numbers.emplace_back("pass " + number, names);
    if (multiply == nullptr) return;
    step.numbers.emplace_back("matrix of " + number, matrix_text(multiply->matrix));
  };
  for (const Pass& pass : plan.passes) add(pass.stages, std::get_if<Multiply>(&pass.work));
  std::string names = plan.lead.stages;
  add_name(names, codes);
  add(names, plan.lead.multiply ? &*plan.lead.multiply : nullptr);
  step.numbers.emplace_back("instruction set", chosen_instruction_set().name);
  return step;
}

}  // namespace tristim
