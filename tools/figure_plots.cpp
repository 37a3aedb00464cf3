// Figures that are plots of the empirical models.
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "tools/figure_drawing.h"
#include "tools/figures.h"
#include "tristim/light/fisher_woo.h"
#include "tristim/light/phong.h"

namespace tristim::tools {
namespace {

using Eigen::Vector3d;

const Vector3d kUp(0, 0, 1);

Vector3d direction(double degrees) { return {sine_deg(degrees), 0, cosine_deg(degrees)}; }

// (R.V)^n `rho_deg` from the reflected light.
double phong_at(double rho_deg, double n) { return phong_lobe(kUp, kUp, direction(rho_deg), n); }

struct Surface {
  double ambient, diffuse, specular;  // parts of the light, as columns of the grid show them
};

// One cell: the light that leaves in each direction, as a distance from the point.
void draw_polar(SvgDrawing& svg, SvgPoint origin, double scale, double light_deg,
                const Surface& parts, std::string_view color) {
  constexpr double kExponent = 25;
  const Vector3d to_light = direction(-light_deg);
  std::vector<SvgPoint> outline;
  for (double eye_deg = -90; eye_deg <= 90; eye_deg += 0.5) {
    const double intensity =
        parts.ambient + parts.diffuse * lambert(kUp, to_light) +
        parts.specular * phong_lobe(kUp, to_light, direction(eye_deg), kExponent);
    outline.push_back(around(origin, scale * intensity, eye_deg));
  }
  svg.polygon(outline, {.fill = color, .stroke = {color, 1.6}, .opacity = 0.22});
  svg.line({origin.x - 62, origin.y}, {origin.x + 62, origin.y}, {kInk, 1.2});
  draw_arrow(svg, around(origin, 78, -light_deg), around(origin, 8, -light_deg), kGrey, 1.2);
}

// A mesh from back to front, so that near cells cover far ones.
class Mesh {
 public:
  explicit Mesh(SvgDrawing& svg) : svg_(svg) {}

  // theta runs to the left and near, phi to the right and near, errors up.
  SvgPoint at(double theta_deg, double phi_deg, double error) const {
    const double a = theta_deg / 180;
    const double b = phi_deg / 180;
    return {310 + 245 * (b - a), 150 + 120 * (a + b) - 2.1 * error};
  }

  void draw(int step) {
    for (int theta = 0; theta < 180; theta += step) {
      for (int phi = 0; phi < 180; phi += step) cell(theta, phi, step);
    }
  }

 private:
  void cell(int theta, int phi, int step) {
    const auto error = [](int t, int p) { return pixel_error(highlight_frame(t, p, 90), 10, 4); };
    const int t1 = theta + step;
    const int p1 = phi + step;
    const std::array errors{error(theta, phi), error(theta, p1), error(t1, p1), error(t1, phi)};
    const std::array<SvgPoint, 4> corners{{at(theta, phi, errors[0]), at(theta, p1, errors[1]),
                                           at(t1, p1, errors[2]), at(t1, phi, errors[3])}};
    const double mean = (errors[0] + errors[1] + errors[2] + errors[3]) / 4;
    const std::string color = hex_color(error_tone(mean));
    svg_.polygon(corners, {.fill = color, .stroke = {"#555", 0.4}});
  }

  SvgDrawing& svg_;
};

void mesh_numbers(SvgDrawing& svg, const Mesh& mesh) {
  const SvgFont font{.size = 11, .anchor = SvgAnchor::kMiddle};
  for (int angle = 0; angle <= 180; angle += 45) {
    const SvgPoint theta = mesh.at(angle, 180, 0);
    const SvgPoint phi = mesh.at(180, angle, 0);
    svg.text({theta.x + 18, theta.y + 12}, std::to_string(angle), font);
    svg.text({phi.x - 18, phi.y + 12}, std::to_string(angle), font);
  }
  const SvgPoint theta_title = mesh.at(90, 180, 0);
  const SvgPoint phi_title = mesh.at(180, 90, 0);
  const SvgFont title{.size = 15, .anchor = SvgAnchor::kMiddle, .italic = true};
  svg.text({theta_title.x + 46, theta_title.y + 34}, "θ (degrees)", title);
  svg.text({phi_title.x - 46, phi_title.y + 34}, "φ (degrees)", title);
}

}  // namespace

std::string cosine_powers() {
  SvgDrawing svg(560, 400, "Fall-off of the specular term",
                 "cos^n of the angle for n from 1 to 200");
  const PlotAxes axes(
      svg, {70, 46}, 450, 290,
      {.from = 0, .to = 90, .title = "angle α between R and V (degrees)", .step = 15},
      {.from = 0, .to = 1, .title = "cosⁿ α", .step = 0.2});
  svg.text({295, 28}, "Fall-off of the highlight with the exponent n",
           {.size = 15, .anchor = SvgAnchor::kMiddle, .bold = true});
  axes.grid();
  constexpr double kExponents[] = {1, 2, 5, 10, 20, 64, 200};
  std::vector<PlotKey> keys;
  static constexpr std::string_view kNames[] = {"n = 1",  "n = 2",  "n = 5",  "n = 10",
                                                "n = 20", "n = 64", "n = 200"};
  for (std::size_t i = 0; i < std::size(kExponents); ++i) {
    const SvgStroke stroke{kFamily[i], 2};
    axes.curve(curve_points(0, 90, 180, [&](double a) { return phong_at(a, kExponents[i]); }),
               stroke);
    keys.push_back({.text = kNames[i], .stroke = stroke});
  }
  axes.frame();
  axes.legend(keys, PlotCorner::kTopRight);
  return svg.document();
}

std::string highlight_spread() {
  SvgDrawing svg(560, 400, "R.V and N.H with the same exponent",
                 "N.H spreads the highlight; four times the exponent narrows it again");
  const PlotAxes axes(svg, {70, 46}, 450, 290,
                      {.from = -90, .to = 90, .title = "angle ρ from R to V (degrees)", .step = 30},
                      {.from = 0, .to = 1, .title = "specular intensity", .step = 0.2});
  svg.text({295, 28}, "Spread of the highlight, n = 10, L, N and V coplanar",
           {.size = 15, .anchor = SvgAnchor::kMiddle, .bold = true});
  axes.grid();
  // With the light at the normal H is half way to the eye.
  const auto blinn = [](double exponent) {
    return curve_points(-90, 90, 360, [=](double rho) { return phong_at(rho / 2, exponent); });
  };
  const std::array<PlotKey, 3> keys{{{.text = "(R·V)ⁿ", .stroke = {kBlue, 2.2}},
                                     {.text = "(N·H)ⁿ", .stroke = {kOrange, 2.2}},
                                     {.text = "(N·H)⁴ⁿ", .stroke = {kOrange, 1.8, "6 4"}}}};
  axes.curve(blinn(10), keys[1].stroke);
  axes.curve(curve_points(-90, 90, 360, [](double rho) { return phong_at(rho, 10); }),
             keys[0].stroke);
  axes.curve(blinn(40), keys[2].stroke);
  axes.frame();
  axes.legend(keys, PlotCorner::kTopRight);
  return svg.document();
}

std::string phong_grid() {
  SvgDrawing svg(
      760, 430, "Phong's model by direction",
      "Light that leaves in each direction, for light that comes from 60, 25 and 0 degrees");
  struct Column {
    std::string_view name;
    Surface parts;
    std::string_view color;
  };
  constexpr double kAmbient = 0.15;
  constexpr double kDiffuse = 0.4;
  constexpr double kSpecular = 0.6;
  const Column columns[] = {{"ambient", {kAmbient, 0, 0}, kGrey},
                            {"diffuse", {0, kDiffuse, 0}, kGreen},
                            {"specular", {0, 0, kSpecular}, kOrange},
                            {"total", {kAmbient, kDiffuse, kSpecular}, kBlue}};
  struct Row {
    double light_deg;
    std::string_view name;
  };
  constexpr Row kRows[] = {{60, "φᵢ = 60°"}, {25, "φᵢ = 25°"}, {0, "φᵢ = 0°"}};
  for (std::size_t j = 0; j < std::size(kRows); ++j) {
    const double y = 140 + 130 * double(j);
    svg.text({24, y - 34}, kRows[j].name, {.size = 15});
    for (std::size_t i = 0; i < std::size(columns); ++i) {
      const double x = 180 + 160 * double(i);
      if (j == 0) {
        svg.text({x, 30}, columns[i].name,
                 {.size = 15, .anchor = SvgAnchor::kMiddle, .bold = true});
      }
      draw_polar(svg, {x, y}, 82, kRows[j].light_deg, columns[i].parts, columns[i].color);
    }
  }
  return svg.document();
}

std::string fisher_woo_figure5_surface() {
  SvgDrawing svg(620, 440, "Pixel errors of N.H against R.E",
                 "255 ((R.E)^10 - (N.H)^40) over the normals, [L,E] = 90 degrees");
  svg.text({310, 28}, "255 ((R·E)¹⁰ − (N·H)⁴⁰),  [L,E] = 90°",
           {.size = 15, .anchor = SvgAnchor::kMiddle, .bold = true});
  Mesh mesh(svg);
  mesh.draw(4);
  mesh_numbers(svg, mesh);
  for (const double error : {0.0, 20.0, 40.0, 60.0}) {
    const SvgPoint p = mesh.at(180, 0, error);
    svg.line({p.x - 5, p.y}, p, {kInk, 1});
    svg.text({p.x - 9, p.y + 4}, fixed_text(error, 0), {.size = 11, .anchor = SvgAnchor::kEnd});
  }
  svg.line(mesh.at(180, 0, 0), mesh.at(180, 0, 64), {kInk, 1});
  return svg.document();
}

}  // namespace tristim::tools
