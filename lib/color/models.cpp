#include "tristim/color/models.h"

#include <algorithm>

#include "lib/color/edges.h"
#include "lib/color/light_edges.h"
#include "lib/color/matrix_text.h"
#include "lib/color/name_edges.h"
#include "tristim/color/cmyk.h"
#include "tristim/color/cns.h"
#include "tristim/color/hsv.h"
#include "tristim/color/ictcp.h"
#include "tristim/color/lch.h"
#include "tristim/color/munsell.h"
#include "tristim/color/munsell_value.h"
#include "tristim/color/oklab.h"
#include "tristim/color/parse.h"
#include "tristim/color/planckian.h"
#include "tristim/color/transfer.h"
#include "tristim/color/uv.h"
#include "tristim/color/yiq.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim {
namespace {

using detail::edge;
using detail::white_edge;

constexpr ModelParameter kBlackGeneration[] = {
    {"gcr", 1, 0, 1, "of the grey component becomes black"},
    {"limit", 4, 0, 4, "of the inks' sum; 3 is 300 %"},
};

BlackGeneration black_generation(const ModelContext& context) {
  return {context.parameters[0], context.parameters[1]};
}

template <auto function>
Components black_edge(const Components& c, const ModelContext& context) {
  return detail::components_of(function(detail::color_of<Cmy>(c), black_generation(context)));
}

template <std::size_t system>
Components to_yiq(const Components& c, const ModelContext& /*context*/) {
  return detail::components_of(rgb_to_yiq(detail::color_of<EncodedRgb>(c), kYiqSystems[system]));
}
template <std::size_t system>
Components from_yiq(const Components& c, const ModelContext& /*context*/) {
  return detail::components_of(yiq_to_rgb(detail::color_of<Yiq>(c), kYiqSystems[system]));
}
template <std::size_t system>
std::string yiq_numbers(const ModelContext& /*context*/) {
  return "matrix " + detail::matrix_text(yiq_from_rgb(kYiqSystems[system])) + ", inverse " +
         detail::matrix_text(rgb_from_yiq(kYiqSystems[system]));
}

template <std::size_t system>
constexpr ColorModel yiq_model(std::string_view name) {
  return {.name = name,
          .components = "Y I Q",
          .ranges = "Y 0..1, I and Q within .6 of 0",
          .base = "rgb",
          .to_base = from_yiq<system>,
          .from_base = to_yiq<system>,
          .formula = kYiqSystems[system].definition,
          .source = kYiqSystems[system].source,
          .numbers = yiq_numbers<system>};
}

constexpr ModelParameter kPqWhite[] = {
    {"white", 1, 1e-6, 1e6, "cd/m2 of linear RGB 1; 203 for diffuse white"}};

Components to_ictcp_pq(const Components& c, const ModelContext& context) {
  const double white = context.parameters[0];
  return detail::components_of(bt2020_to_ictcp_pq({c[0] * white, c[1] * white, c[2] * white}));
}
Components from_ictcp_pq(const Components& c, const ModelContext& context) {
  const double white = context.parameters[0];
  const Rgb light = ictcp_pq_to_bt2020(detail::color_of<Ictcp>(c));
  return {light.r / white, light.g / white, light.b / white, 0};
}
constexpr ModelParameter kHlgWhite[] = {{"white", 1000, 1, 1e5, "cd/m2 of the display's white"}};

Components to_hlg_display(const Components& c, const ModelContext& context) {
  return detail::components_of(hlg_ootf(detail::color_of<Rgb>(c), context.parameters[0]));
}
Components from_hlg_display(const Components& c, const ModelContext& context) {
  return detail::components_of(hlg_inverse_ootf(detail::color_of<Rgb>(c), context.parameters[0]));
}
std::string hlg_numbers(const ModelContext& context) {
  return "white " + shortest(context.parameters[0]) + " cd/m2";
}

std::string pq_numbers(const ModelContext& context) {
  return "RGB 1 is " + shortest(context.parameters[0]) + " cd/m2";
}

std::string curve_numbers(const ModelContext& context) {
  return "curve " + curve_name(context.curve) + ": " + curve_formula(context.curve);
}

std::string black_numbers(const ModelContext& context) {
  return "gcr " + shortest(context.parameters[0]) + ", limit " + shortest(context.parameters[1]);
}

std::string white_numbers(const ModelContext& context) {
  const Xyz white = white_xyz(context.white);
  return "white " + detail::white_text(context.white) + ": Xn " + shortest(white.x) +
         ", Yn 1, Zn " + shortest(white.z);
}

constexpr ModelParameter kRadiation[] = {
    {"c2", kC2, 1.4e-2, 1.5e-2, "m K; CODATA 2018 has 0.014387768775039338"},
};

std::string radiation_numbers(const ModelContext& context) {
  return "c2 = " + shortest(context.parameters[0]) + " m K";
}

Components same_edge(const Components& c, const ModelContext& /*context*/) { return c; }

template <typename Color>
std::string why_no_munsell(const Components& c) {
  return munsell_refusal(detail::color_of<Color>(c));
}

template <std::size_t function>
Components to_munsell_value(const Components& c, const ModelContext& /*context*/) {
  return {kMunsellValueFunctions[function].value_from_luminance(c[1])};
}

template <std::size_t function>
constexpr ColorModel munsell_value_model(std::string_view name) {
  return {.name = name,
          .components = "V",
          .ranges = "0..10",
          .base = "xyz",
          .from_base = to_munsell_value<function>,
          .formula = kMunsellValueFunctions[function].formula,
          .source = kMunsellValueFunctions[function].source};
}

constexpr ColorModel kModels[] = {
    {.name = "xyz",
     .components = "X Y Z",
     .ranges = "Y of the white is 1",
     .base = "",
     .formula = "the root",
     .source = "[CIE15 7.1]"},
    {.name = "linear",
     .components = "R G B",
     .ranges = "0..1, light",
     .base = "xyz",
     .to_base = detail::matrix_edge,
     .from_base = detail::matrix_edge,
     .formula = "XYZ = M RGB, M = columns (x, y, 1-x-y) C, C from the white",
     .source = "[Shoaff 2.2.4]",
     .reads_primaries = true},
    {.name = "rgb",
     .components = "R G B",
     .ranges = "0..1, encoded by the set's curve (where it is none of ours: srgb)",
     .base = "linear",
     .to_base = detail::decode_edge,
     .from_base = detail::encode_edge,
     .formula = "each component by the curve",
     .source = "[IEC61966]",
     .reads_curve = true,
     .numbers = curve_numbers},
    {.name = "cmy",
     .components = "C M Y",
     .ranges = "0..1",
     .base = "rgb",
     .to_base = edge<cmy_to_rgb>,
     .from_base = edge<rgb_to_cmy>,
     .formula = "1 - RGB",
     .source = "[Shoaff 2.2.5]"},
    {.name = "cmyk:subtract",
     .components = "C M Y K",
     .ranges = "0..1",
     .base = "cmy",
     .to_base = edge<cmyk_subtract_to_cmy>,
     .from_base = black_edge<cmy_to_cmyk_subtract>,
     .formula = "K = gcr min(C, M, Y); C-K, M-K, Y-K",
     .source = "[Shoaff 2.2.5]",
     .parameters = kBlackGeneration,
     .numbers = black_numbers},
    {.name = "cmyk:normalised",
     .components = "C M Y K",
     .ranges = "0..1",
     .base = "cmy",
     .to_base = edge<cmyk_normalised_to_cmy>,
     .from_base = black_edge<cmy_to_cmyk_normalised>,
     .formula = "K = gcr min(C, M, Y); (C-K)/(1-K), (M-K)/(1-K), (Y-K)/(1-K)",
     .source = "[CSS4 10]",
     .parameters = kBlackGeneration,
     .numbers = black_numbers},
    {.name = "hsv",
     .components = "H S V",
     .ranges = "hue 0..360, none for greys; S and V 0..1",
     .base = "rgb",
     .to_base = edge<hsv_to_rgb>,
     .from_base = edge<rgb_to_hsv>,
     .formula = "V = max, S = (max-min)/max, H = 60 (G-B)/(max-min) from red, likewise from green "
                "at 120 and blue at 240",
     .source = "[Smith78]",
     .hue = 0},
    {.name = "hls",
     .components = "H L S",
     .ranges = "hue 0..360, none for greys; L and S 0..1",
     .base = "rgb",
     .to_base = edge<hls_to_rgb>,
     .from_base = edge<rgb_to_hls>,
     .formula = "L = (max+min)/2, S = (max-min)/(max+min) up to L = 1/2, else "
                "(max-min)/((1-max)+(1-min)); H as HSV",
     .source = "[Shoaff 2.2.7]",
     .hue = 0},
    {.name = "hsl",
     .components = "H S L",
     .ranges = "hue 0..360, none for greys; S and L 0..1",
     .base = "rgb",
     .to_base = edge<hsl_to_rgb>,
     .from_base = edge<rgb_to_hsl>,
     .formula = "hls in another order",
     .source = "[CSS4 7]",
     .hue = 0},
    yiq_model<0>("yiq:smpte170m"),
    yiq_model<1>("yiq:fcc1953"),
    yiq_model<2>("yiq:notes"),
    yiq_model<3>("yiq:ntsc-phosphor"),
    {.name = "xyy",
     .components = "x y Y",
     .ranges = "Y of the white is 1; black has no x and y",
     .base = "xyz",
     .to_base = edge<xyy_to_xyz>,
     .from_base = edge<xyz_to_xyy>,
     .formula = "x = X/(X+Y+Z), y = Y/(X+Y+Z)",
     .source = "[CIE15 7.3]"},
    {.name = "cct",
     .components = "T Duv Y",
     .ranges = "kelvins from 200 to inf; Duv -.1..+.1, above 0 on the green side, else none",
     .base = "xyy",
     .to_base = detail::cct_to_xyy_edge,
     .from_base = detail::xyy_to_cct_edge,
     .formula =
         "nearest point of the Planckian locus in CIE 1960 u, v, the true minimum; the locus "
         "by the CIE 1931 observer, sum at 1 nm from 360 to 830",
     .source = "[CIE15 9.4]",
     .parameters = kRadiation,
     .numbers = radiation_numbers},
    {.name = "planckian",
     .components = "T",
     .ranges = "kelvins above 0, inf as well; Y is 1",
     .base = "xyy",
     .to_base = detail::planckian_to_xyy_edge,
     .formula = "power as lambda^-5/(exp(c2/(lambda T)) - 1), CIE 1931 observer, sum at 1 nm from "
                "360 to 830",
     .source = "[CIE15 4.1.1]",
     .parameters = kRadiation,
     .numbers = radiation_numbers},
    {.name = "daylight",
     .components = "T",
     .ranges = "kelvins 4000..25000; Y is 1",
     .base = "xyy",
     .to_base = detail::daylight_to_xyy_edge,
     .formula = "x a polynomial of 1/T, another above 7000 K; y = -3 x^2 + 2.870 x - 0.275",
     .source = "[CIE15 4.1.2]"},
    {.name = "wavelength",
     .components = "lambda_d lambda_c p_e p_c",
     .ranges = "nm 380..700, lambda_d of purples minus the complementary one; none for the white",
     .base = "xyy",
     .from_base = detail::xyy_to_wavelength_edge,
     .formula =
         "the ray from the white through the colour meets the spectral locus (CIE 1931, 1 nm) "
         "or the purple line in G: p_e = CF/CG, p_c = p_e yG/yF",
     .source = "[Shoaff 2.2.3]",
     .numbers = white_numbers},
    {.name = "helmholtz",
     .components = "lambda_d p_e Y",
     .ranges = "as wavelength; Y of the white is 1",
     .base = "xyy",
     .to_base = detail::helmholtz_to_xyy_edge,
     .from_base = detail::xyy_to_helmholtz_edge,
     .formula = "as wavelength, and the luminance, which make the colour again",
     .source = "[Shoaff 2.2.3]",
     .numbers = white_numbers},
    {.name = "uv",
     .components = "u v Y",
     .ranges = "CIE 1960; Y of the white is 1; black has no u and v",
     .base = "xyz",
     .to_base = edge<uv_to_xyz>,
     .from_base = edge<xyz_to_uv>,
     .formula = "u = 4X/(X+15Y+3Z), v = 6Y/(X+15Y+3Z)",
     .source = "[CIE15 8.1]"},
    {.name = "uv76",
     .components = "u' v' Y",
     .ranges = "CIE 1976; Y of the white is 1; black has no u' and v'",
     .base = "xyz",
     .to_base = edge<uv_prime_to_xyz>,
     .from_base = edge<xyz_to_uv_prime>,
     .formula = "u' = 4X/(X+15Y+3Z), v' = 9Y/(X+15Y+3Z)",
     .source = "[CIE15 8.1]",
     .alias = "u'v'"},
    {.name = "lab",
     .components = "L* a* b*",
     .ranges = "L* 0..100",
     .base = "xyz",
     .to_base = white_edge<lab_to_xyz>,
     .from_base = white_edge<xyz_to_lab>,
     .formula = "L* = 116 f(Y/Yn) - 16, a* = 500 (f(X/Xn) - f(Y/Yn)), b* = 200 (f(Y/Yn) - "
                "f(Z/Zn)); f(t) = t^(1/3) above 216/24389, else (24389/27 t + 16)/116",
     .source = "[CIE15 8.2.1]",
     .numbers = white_numbers},
    {.name = "lch",
     .components = "L* C h",
     .ranges = "L* 0..100; hue 0..360, none where C is 0",
     .base = "lab",
     .to_base = edge<lch_to_lab>,
     .from_base = edge<lab_to_lch>,
     .formula = "C = sqrt(a*^2 + b*^2), h = atan2(b*, a*)",
     .source = "[CIE15 8.2.1]",
     .alias = "lchab",
     .hue = 2},
    {.name = "luv",
     .components = "L* u* v*",
     .ranges = "L* 0..100",
     .base = "xyz",
     .to_base = white_edge<luv_to_xyz>,
     .from_base = white_edge<xyz_to_luv>,
     .formula = "L* as lab, u* = 13 L* (u' - u'n), v* = 13 L* (v' - v'n)",
     .source = "[CIE15 8.2.2]",
     .numbers = white_numbers},
    {.name = "lchuv",
     .components = "L* C h",
     .ranges = "L* 0..100; hue 0..360, none where C is 0",
     .base = "luv",
     .to_base = edge<lch_to_luv>,
     .from_base = edge<luv_to_lch>,
     .formula = "C = sqrt(u*^2 + v*^2), h = atan2(v*, u*)",
     .source = "[CIE15 8.2.2]",
     .hue = 2},
    {.name = "oklab",
     .components = "L a b",
     .ranges = "L 0..1",
     .base = "linear",
     .to_base = edge<oklab_to_linear_srgb>,
     .from_base = edge<linear_srgb_to_oklab>,
     .formula = "cube roots of cone responses between two matrices",
     .source = "[Ottosson20]",
     .fixed_primaries = "srgb"},
    {.name = "oklch",
     .components = "L C h",
     .ranges = "L 0..1; hue 0..360, none where C is below 1e-6",
     .base = "oklab",
     .to_base = edge<oklch_to_oklab>,
     .from_base = edge<oklab_to_oklch>,
     .formula = "C = sqrt(a^2 + b^2), h = atan2(b, a)",
     .source = "[Ottosson20]",
     .hue = 2},
    {.name = "ictcp:pq",
     .components = "I Ct Cp",
     .ranges = "I 0..1 up to 10000 cd/m2; linear BT.2020 RGB counts cd/m2 unless white is given",
     .base = "linear",
     .to_base = from_ictcp_pq,
     .from_base = to_ictcp_pq,
     .formula = "cone responses by PQ between two matrices of 4096ths",
     .source = "[BT2100 table 7]",
     .fixed_primaries = "bt2020",
     .parameters = kPqWhite,
     .numbers = pq_numbers},
    {.name = "ictcp:hlg",
     .components = "I Ct Cp",
     .ranges = "I 0..1; linear BT.2020 RGB is light of the scene, 0..1",
     .base = "linear",
     .to_base = edge<ictcp_hlg_to_bt2020>,
     .from_base = edge<bt2020_to_ictcp_hlg>,
     .formula = "cone responses by HLG between two matrices of 4096ths",
     .source = "[BT2100 table 7]",
     .fixed_primaries = "bt2020"},
    {.name = "munsell",
     .components = "H V C",
     .ranges = "hue 0..100 (5R is 5, 10RP is 100), none for neutrals; V 0..10; C 0..50; reads "
               "'7.5YR 5/12' as well",
     .base = "xyy",
     .to_base = edge<munsell_to_xyy>,
     .from_base = edge<xyy_to_munsell>,
     .formula = "V by Y = 1.1914 V - .22533 V^2 + .23352 V^3 - .020484 V^4 + .00081939 V^5 percent "
                "[ASTMD1535]; x and y of the renotation, linear in chroma, linear or radial in hue "
                "as charted, linear in Y from value to value [Centore12]",
     .source = "[Newhall43], [Judd56]",
     .hue = 0,
     .hue_turn = 100,
     .fixed_white = "c",
     .from_text = detail::munsell_from_text,
     .text_hint = munsell_hint,
     .why_none_to_base = why_no_munsell<Munsell>,
     .why_none_from_base = why_no_munsell<Xyy>},
    {.name = "munsell-notation",
     .components = "notation",
     .ranges = "7.5YR 5/12, N 5/",
     .base = "munsell",
     .to_base = same_edge,
     .from_base = same_edge,
     .formula = "hue in its family, value/chroma",
     .source = "[ASTMD1535]",
     .to_text = detail::munsell_to_text,
     .from_text = detail::munsell_from_text,
     .text_hint = munsell_hint},
    {.name = "iscc-nbs",
     .components = "name",
     .ranges = "267 names: strong greenish blue",
     .base = "munsell",
     .to_base = detail::iscc_nbs_to_munsell,
     .from_base = detail::munsell_to_iscc_nbs,
     .formula = "932 boxes of hue, value, chroma, begin <= number < end; a name's central colour "
                "[Kelly58]",
     .source = "[Kelly76]",
     .to_text = detail::iscc_nbs_to_text,
     .from_text = detail::iscc_nbs_from_text,
     .text_hint = detail::iscc_nbs_hint},
    {.name = "cns",
     .components = "name",
     .ranges = "627 names: light vivid purplish red",
     .base = "munsell",
     .to_base = detail::cns_to_munsell,
     .from_base = detail::munsell_to_cns,
     .formula =
         "steps of value, of chroma relative to what sRGB can show, of hue between red 7.5R, "
         "orange 5YR, yellow 10Y, green 10GY, blue 7.5PB, purple 7.5P; docs/color-names.md",
     .source = "[Berk82]",
     .to_text = detail::cns_to_text,
     .from_text = detail::cns_from_text,
     .text_hint = cns_hint},
    {.name = "css",
     .components = "name",
     .ranges = "148 names: rebeccapurple",
     .base = "rgb",
     .to_base = detail::css_to_rgb,
     .from_base = detail::rgb_to_css,
     .formula = "the nearest in Oklab",
     .source = "[CSS4 6.1]",
     .fixed_primaries = "srgb",
     .to_text = detail::css_to_text,
     .from_text = detail::css_from_text,
     .text_hint = color_hint},
    munsell_value_model<0>("munsell-value:astm-d1535"),
    munsell_value_model<1>("munsell-value:priest1920"),
    munsell_value_model<2>("munsell-value:munsell1933"),
    munsell_value_model<3>("munsell-value:moon1943"),
    munsell_value_model<4>("munsell-value:saunderson1944"),
    munsell_value_model<5>("munsell-value:ladd1955"),
    munsell_value_model<6>("munsell-value:mccamy1987"),
    {.name = "hlg-display",
     .components = "R G B",
     .ranges = "cd/m2, 0..white; linear BT.2020 RGB is light of the scene, 0..1",
     .base = "linear",
     .to_base = from_hlg_display,
     .from_base = to_hlg_display,
     .formula =
         "the OOTF of HLG: Fd = white Ys^(gamma - 1) E, gamma = 1.2 + .42 log10(white/1000), "
         "Ys = .2627 R + .6780 G + .0593 B",
     .source = "[BT2100 table 5]",
     .fixed_primaries = "bt2020",
     .parameters = kHlgWhite,
     .numbers = hlg_numbers},
};

// Whether `holds` for the model or one that it comes from.
template <typename Predicate>
bool on_the_way(const ColorModel& model, Predicate&& holds) {
  for (const ColorModel* m = &model; m != nullptr; m = base_of(*m)) {
    if (holds(*m)) return true;
  }
  return false;
}

bool is_fixed(const ColorModel& m) { return !m.fixed_primaries.empty() || !m.fixed_white.empty(); }

}  // namespace

std::span<const ColorModel> color_models() noexcept { return kModels; }

std::size_t component_count(const ColorModel& model) noexcept {
  return 1 + static_cast<std::size_t>(
                 std::count(model.components.begin(), model.components.end(), ' '));
}

const ColorModel* base_of(const ColorModel& model) noexcept {
  return find_by_name(kModels, model.base);
}

bool takes_primaries(const ColorModel& model) noexcept {
  return on_the_way(model, [](const ColorModel& m) { return m.reads_primaries; }) &&
         !on_the_way(model, is_fixed);
}

bool takes_white(const ColorModel& model) noexcept {
  return !on_the_way(model, [](const ColorModel& m) { return m.reads_primaries || is_fixed(m); });
}

bool takes_curve(const ColorModel& model) noexcept {
  return takes_primaries(model) &&
         on_the_way(model, [](const ColorModel& m) { return m.reads_curve; });
}

}  // namespace tristim
