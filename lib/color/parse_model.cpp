#include <algorithm>
#include <stdexcept>
#include <vector>

#include "tristim/color/models.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim {
namespace {

constexpr std::string_view kNumbersHint =
    "give x,y of red, green, blue and the white, or of the three and Yr,Yg,Yb";

struct Name {
  std::string_view name;
};

std::string quoted(std::string_view text) { return "'" + std::string(text) + "'"; }

[[noreturn]] void refuse(std::string_view thing, const std::string& what, const std::string& hint) {
  throw Error(ErrorKind::kMisuse, thing, what, hint);
}

std::string_view family(const ColorModel& model) {
  return model.name.substr(0, model.name.find(':'));
}

std::string_view variant(const ColorModel& model) {
  const std::size_t colon = model.name.find(':');
  return colon == std::string_view::npos ? "" : model.name.substr(colon + 1);
}

// "yiq" of all its rows once.
std::vector<Name> families() {
  std::vector<Name> names;
  for (const ColorModel& model : color_models()) {
    if (names.empty() || names.back().name != family(model)) names.push_back({family(model)});
  }
  return names;
}

std::vector<Name> variants(std::string_view name) {
  std::vector<Name> names;
  for (const ColorModel& model : color_models()) {
    if (same_name(family(model), name) && !variant(model).empty())
      names.push_back({variant(model)});
  }
  return names;
}

const ColorModel* find_model(std::string_view name, std::string_view wanted_variant) {
  for (const ColorModel& model : color_models()) {
    const bool named =
        same_name(family(model), name) || (!model.alias.empty() && same_name(model.alias, name));
    if (!named) continue;
    if (wanted_variant.empty() || same_name(variant(model), wanted_variant)) return &model;
  }
  return nullptr;
}

// Numbers "0.64,0.33,..."; nothing where one is none.
std::optional<std::vector<double>> numbers_of(std::string_view text) {
  std::vector<double> numbers;
  for (const std::string_view part : split(text, ',')) {
    const auto number = parse_number(part);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

Primaries primaries_of(const std::vector<double>& n, std::string_view thing) {
  if (n.size() != 8 && n.size() != 9) {
    refuse(thing, std::to_string(n.size()) + " numbers are no primaries",
           std::string(kNumbersHint));
  }
  try {
    Primaries primaries{{n[0], n[1]}, {n[2], n[3]}, {n[4], n[5]}, {n[6], n[7]}};
    if (n.size() == 9) primaries.white = white_from_luminances(primaries, n[6], n[7], n[8]);
    (void)xyz_from_rgb(primaries);
    return primaries;
  } catch (const std::invalid_argument& error) {
    refuse(thing, error.what(),
           "give three chromaticities that span a triangle, and a white in it");
  }
}

RgbCurve curve_of(std::string_view text, std::string_view thing) {
  if (const auto curve = parse_rgb_curve(text)) return *curve;
  const std::string hint = name_hint(kTransferFunctions, text);
  refuse(thing, "unknown curve " + quoted(text),
         hint.starts_with("use") ? hint + ", gamma2.2" : hint);
}

Chromaticity white_of(std::string_view text, std::string_view thing) {
  if (const WhitePoint* known = find_by_name(kWhitePoints, text)) return known->chromaticity;
  const auto xy = numbers_of(text);
  if (!xy) refuse(thing, "unknown white " + quoted(text), name_hint(kWhitePoints, text));
  const bool good =
      xy->size() == 2 && (*xy)[1] > 0 && (*xy)[1] <= 1 && (*xy)[0] >= 0 && (*xy)[0] + (*xy)[1] <= 1;
  if (!good) {
    refuse(thing, quoted(text) + " is no chromaticity", "give x,y such as 0.3127,0.329");
  }
  return {(*xy)[0], (*xy)[1]};
}

// "srgb", "bt2020/pq", "0.64,0.33,...".
void read_primaries(ModelReference& reference, std::string_view text, std::string_view thing) {
  const std::size_t slash = text.find('/');
  const std::string_view set = text.substr(0, slash);
  if (const auto numbers = numbers_of(set)) {
    reference.primaries = primaries_of(*numbers, thing);
    reference.curve = RgbCurve{};
  } else {
    const NamedPrimaries* known = find_by_name(primaries_list(), set);
    if (known == nullptr && set.find(',') != std::string_view::npos) {
      refuse(thing, quoted(set) + " are no numbers", std::string(kNumbersHint));
    }
    if (known == nullptr) {
      refuse(thing, "unknown primaries " + quoted(set), name_hint(primaries_list(), set));
    }
    reference.primaries = known->primaries;
    reference.curve = parse_rgb_curve(known->transfer).value_or(RgbCurve{});
  }
  if (slash == std::string_view::npos) return;
  if (!takes_curve(*reference.model)) {
    refuse(thing, std::string(reference.model->name) + " has no curve",
           "leave out " + quoted(text.substr(slash)));
  }
  reference.curve = curve_of(text.substr(slash + 1), thing);
}

void read_parameter(ModelReference& reference, std::string_view text, std::string_view thing) {
  const std::size_t equals = text.find('=');
  const std::span<const ModelParameter> known = reference.model->parameters;
  const ModelParameter* parameter = find_by_name(known, text.substr(0, equals));
  if (parameter == nullptr) {
    refuse(thing, "unknown parameter " + quoted(text.substr(0, equals)),
           known.empty() ? std::string(reference.model->name) + " has none"
                         : name_hint(known, text.substr(0, equals)));
  }
  const auto value = parse_number(text.substr(equals + 1));
  if (!value || !(*value >= parameter->least && *value <= parameter->most)) {
    refuse(thing, std::string(parameter->name) + " cannot be " + quoted(text.substr(equals + 1)),
           "give a number from " + shortest(parameter->least) + " to " + shortest(parameter->most));
  }
  reference.parameters[static_cast<std::size_t>(parameter - known.data())] = *value;
}

// What stands between two colons, behind the model and its variant.
void read_detail(ModelReference& reference, std::string_view text, std::string_view family_name,
                 std::string_view thing) {
  if (text.find('=') != std::string_view::npos) return read_parameter(reference, text, thing);
  if (takes_primaries(*reference.model) && !reference.primaries) {
    // What is no set but near a variant is a slip in the variant.
    const std::vector<Name> choices = variants(family_name);
    const bool variant_meant = name_hint(choices, text).starts_with("did you mean") &&
                               !name_hint(primaries_list(), text).starts_with("did you mean") &&
                               find_by_name(primaries_list(), text) == nullptr;
    if (variant_meant) refuse(thing, "unknown variant " + quoted(text), name_hint(choices, text));
    return read_primaries(reference, text, thing);
  }
  if (const std::vector<Name> choices = variants(family_name); !choices.empty()) {
    refuse(thing, "unknown variant " + quoted(text), name_hint(choices, text));
  }
  refuse(thing, quoted(text) + " does not go with " + std::string(reference.model->name),
         takes_white(*reference.model)
             ? "a white can be named: " + std::string(reference.model->name) + "@d50"
             : "leave it out");
}

}  // namespace

ModelReference parse_model(std::string_view text, std::string_view thing) {
  const std::size_t at = text.find('@');
  const std::vector<std::string_view> parts = split(text.substr(0, at), ':');
  ModelReference reference;
  std::size_t read = 1;
  if (parts.size() > 1 && !parts[1].empty()) reference.model = find_model(parts[0], parts[1]);
  if (reference.model != nullptr) {
    read = 2;
  } else {
    reference.model = find_model(parts[0], "");
  }
  if (reference.model == nullptr) {
    refuse(thing, "unknown model " + quoted(parts[0]), name_hint(families(), parts[0]));
  }
  for (std::size_t i = 0; i < reference.model->parameters.size(); ++i) {
    reference.parameters[i] = reference.model->parameters[i].value;
  }
  for (; read < parts.size(); ++read) read_detail(reference, parts[read], parts[0], thing);
  if (at != std::string_view::npos) {
    if (!takes_white(*reference.model)) {
      refuse(thing, std::string(reference.model->name) + " has a white of its own",
             "leave out " + quoted(text.substr(at)));
    }
    reference.white = white_of(text.substr(at + 1), thing);
  }
  return reference;
}

}  // namespace tristim
