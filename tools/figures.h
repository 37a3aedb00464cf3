#pragma once

#include <array>
#include <string>
#include <string_view>

#include "tristim/color/rgb.h"
#include "tristim/image/view.h"

namespace tristim::tools {

// The figures of `tristim shade figures`, a file of functions for each subject.

std::string fisher_woo_figure1();  // SVG
Image fisher_woo_figure2();        // linear, one channel
Image fisher_woo_figure3_r_dot_e();
Image fisher_woo_figure3_n_dot_h();
std::string fisher_woo_figure4();
Image fisher_woo_figure5();  // errors on a scale of 255, one channel
std::string fisher_woo_figure5_surface();
std::string cosine_powers();
std::string highlight_spread();
std::string phong_grid();
std::string fresnel_curves();
std::string highlight_colors();
std::string directional_albedos();
std::string microfacet_sketch();
std::string microfacet_lobes();
Image gloss_spheres();  // linear, one channel

/// Light as it is: grey.
Rgb grey_tone(double value) noexcept;

/// Errors: blue below 0, white at 0, red above, the full colour at 64 of 255.
Rgb error_tone(double value) noexcept;

/// A figure: a drawing (SVG), or a picture (EXR, and PNG in the colours of `tone`).
struct Figure {
  std::string_view name;  // of its files, without extension
  std::string_view what;
  std::string (*drawing)() = nullptr;
  Image (*picture)() = nullptr;
  Rgb (*tone)(double value) noexcept = nullptr;  // linear sRGB
};

/// Every figure. The command, its help and the tests read this list.
inline constexpr std::array kFigures{
    Figure{"fisher-woo-1", "vectors of the two models, coplanar [FisherWoo, fig. 1]",
           fisher_woo_figure1},
    Figure{.name = "fisher-woo-2",
           .what = "spheres under R.E and N.H, f = 1, 2, 4, 6 [FisherWoo, fig. 2]",
           .picture = fisher_woo_figure2,
           .tone = grey_tone},
    Figure{.name = "fisher-woo-3-re",
           .what = "cap, cylinder, sphere under (R.E)^r [FisherWoo, fig. 3]",
           .picture = fisher_woo_figure3_r_dot_e,
           .tone = grey_tone},
    Figure{.name = "fisher-woo-3-nh",
           .what = "the same under (N.H)^(4r)",
           .picture = fisher_woo_figure3_n_dot_h,
           .tone = grey_tone},
    Figure{"fisher-woo-4", "the frame of theta, phi and [L,E] [FisherWoo, fig. 4]",
           fisher_woo_figure4},
    Figure{.name = "fisher-woo-5",
           .what = "pixel errors, [L,E] = 90, r = 10, f = 4 [FisherWoo, fig. 5]",
           .picture = fisher_woo_figure5,
           .tone = error_tone},
    Figure{"fisher-woo-5-surface", "the same as a surface", fisher_woo_figure5_surface},
    Figure{"cosine-powers", "cos^n for n = 1 to 200", cosine_powers},
    Figure{"highlight-spread", "(R.V)^n beside (N.H)^n", highlight_spread},
    Figure{"phong-grid", "ambient, diffuse, specular and total light by direction", phong_grid},
    Figure{"fresnel", "reflectance of glass, water, gold and copper", fresnel_curves},
    Figure{"highlight-colors", "the colour of a metal's highlight by angle", highlight_colors},
    Figure{"albedo", "directional albedo of both normalisations", directional_albedos},
    Figure{"microfacets", "mirrors of a rough surface, shadowed and masked", microfacet_sketch},
    Figure{"microfacet-lobes", "Beckmann's distribution by roughness", microfacet_lobes},
    Figure{.name = "gloss",
           .what = "spheres of roughness .1 to .8",
           .picture = gloss_spheres,
           .tone = grey_tone},
};

}  // namespace tristim::tools
