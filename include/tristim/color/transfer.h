#pragma once

#include <string_view>

#include "tristim/color/rgb.h"

namespace tristim {

// Curves between linear light and code. Each is computed in 106 bits with the decimal constants of
// its publication and rounded once; only the joints are compared as double constants. NaN passes.
// "Odd" is f(-x) = -f(x). Where nothing else is said the formula goes on beyond 1, and +inf stays.

/// sRGB [IEC61966]: E = 12.92 L up to 0.0031308, else 1.055 L^(1/2.4) - 0.055; odd.
double srgb_encode(double linear) noexcept;
double srgb_decode(double encoded) noexcept;  ///< turns above 0.04045

/// HDTV camera [BT709 1.2]: E = 4.5 L below 0.018, else 1.099 L^0.45 - 0.099; odd. As printed it
/// leaves a gap of codes at the joint, 16 of the 65536.
double bt709_encode(double linear) noexcept;
double bt709_decode(double encoded) noexcept;  ///< turns at 0.081

/// UHDTV camera [BT2020 table 4]: E = 4.5 L below beta, else alpha L^0.45 - (alpha - 1), with alpha
/// and beta solved so that value and slope are continuous; odd.
double bt2020_encode(double linear) noexcept;
double bt2020_decode(double encoded) noexcept;  ///< turns at 4.5 beta

/// HDTV of 1988 [SMPTE240]: E = 4 L below 0.0228, else 1.1115 L^0.45 - 0.1115; odd. Its gap is 7
/// codes of 65536.
double smpte240m_encode(double linear) noexcept;
double smpte240m_decode(double encoded) noexcept;  ///< turns at 0.0913

/// ROMM RGB [ISO22028]: E = 16 L below 16^(1.8/(1-1.8)) = 1/512, else L^(1/1.8); odd.
double romm_encode(double linear) noexcept;
double romm_decode(double encoded) noexcept;  ///< turns at 1/32

/// A pure exponent: E = L^(1/gamma) with gamma > 0 read as a decimal (2.2 is 22/10); odd.
double gamma_encode(double linear, double gamma) noexcept;
double gamma_decode(double encoded, double gamma) noexcept;

/// Adobe RGB (1998) [AdobeRgb 4.3.4.2]: gamma 563/256; odd.
inline constexpr double kAdobeGamma = 563.0 / 256;
double adobe_encode(double linear) noexcept;
double adobe_decode(double encoded) noexcept;

/// CIE lightness [CIE15 8.2.1] as a curve, E = L*/100; its line goes on below 0.
double lstar_encode(double linear) noexcept;
double lstar_decode(double encoded) noexcept;

/// A studio monitor of gamma 2.4 [BT1886 annex 1]: L = max((Lw^(1/2.4) - Lb^(1/2.4)) V +
/// Lb^(1/2.4), 0)^2.4, which is the annex's a max(V + b, 0)^2.4. Luminances in cd/m2, or in any
/// unit; 0 <= black < white. Light below 0 counts as 0.
double bt1886_decode(double encoded, double white, double black) noexcept;
double bt1886_encode(double linear, double white, double black) noexcept;

/// The same relative to the white: `black` is the luminance of black over that of white.
double bt1886_decode(double encoded, double black) noexcept;
double bt1886_encode(double linear, double black) noexcept;

/// The same with a black of 0: max(V, 0)^2.4.
double bt1886_decode(double encoded) noexcept;
double bt1886_encode(double linear) noexcept;

/// The luminance of code 1 of PQ, cd/m2.
inline constexpr double kPqPeak = 10000;

/// Perceptual quantizer [ST2084], light relative to kPqPeak:
/// E = ((c1 + c2 L^m1)/(1 + c3 L^m1))^m2. Light below 0 counts as 0, which has code c1^m2 = 7.3e-7;
/// codes up to that decode to 0. Light without end encodes to (c2/c3)^m2 = 1.99; codes from there
/// on decode to +inf.
double pq_encode(double linear) noexcept;
double pq_decode(double encoded) noexcept;

/// Hybrid log-gamma [BT2100 table 5], scene light in [0, 1]: E = sqrt(3 L) up to 1/12, else
/// a ln(12 L - b) + c with b = 1 - 4a and c = 0.5 - a ln(4a); odd.
double hlg_encode(double linear) noexcept;
double hlg_decode(double encoded) noexcept;  ///< turns above 1/2

/// HLG's scene light to the light of a display of peak `white` cd/m2 and black 0 [BT2100 table 5]:
/// Fd = white Ys^(gamma - 1) E, gamma = 1.2 + 0.42 log10(white/1000), Ys = .2627 R + .6780 G +
/// .0593 B. Returns cd/m2. Odd in Ys; Ys = 0 gives black.
Rgb hlg_ootf(Rgb scene, double white) noexcept;

/// The inverse of hlg_ootf: light of the display in cd/m2 to scene light.
Rgb hlg_inverse_ootf(Rgb display, double white) noexcept;

/// ACEScc [AcesCc 4.4]: E = (log2 L + 9.72)/17.52 from 2^-15 on, (log2(2^-16 + L/2) + 9.72)/17.52
/// below, and the constant of L = 0 below 0. Decoding goes on beyond 65504.
double acescc_encode(double linear) noexcept;
double acescc_decode(double encoded) noexcept;

/// ACEScct [AcesCct 4.4]: as ACEScc above 0.0078125, below it 10.5402377416545 L +
/// 0.0729055341958355. Decoding goes on beyond 65504.
double acescct_encode(double linear) noexcept;
double acescct_decode(double encoded) noexcept;

/// Light itself as the code.
double linear_curve(double light) noexcept;

/// A curve without parameters.
struct TransferFunction {
  std::string_view name;
  double (*encode)(double linear) noexcept;
  double (*decode)(double encoded) noexcept;
  std::string_view formula;
  std::string_view source;
  std::string_view domain;  // what 1 is, and what happens below 0
};

inline constexpr TransferFunction kSrgbTransfer{
    "srgb",       srgb_encode,
    srgb_decode,  "E = 12.92 L up to .0031308, else 1.055 L^(1/2.4) - .055",
    "[IEC61966]", "0..1, odd"};

/// Every curve without parameters. The models, the rows, the command line and the tests read this
/// list.
inline constexpr TransferFunction kTransferFunctions[] = {
    {"linear", linear_curve, linear_curve, "E = L", "[CIE15]", "any"},
    kSrgbTransfer,
    {"bt709", bt709_encode, bt709_decode, "E = 4.5 L below .018, else 1.099 L^.45 - .099",
     "[BT709 1.2]", "0..1, odd"},
    {"bt2020", bt2020_encode, bt2020_decode,
     "E = 4.5 L below beta, else alpha L^.45 - (alpha - 1); alpha = 1 + 5.5 beta = 1.0992968, "
     "5.5 beta - 10 beta^.55 + 1 = 0",
     "[BT2020 table 4]", "0..1, odd"},
    {"bt1886", bt1886_encode, bt1886_decode,
     "L = max((1 - r) V + r, 0)^2.4, r = black^(1/2.4), black over white 0 unless named",
     "[BT1886 annex 1]", "0..1, below 0 as 0"},
    {"smpte240m", smpte240m_encode, smpte240m_decode,
     "E = 4 L below .0228, else 1.1115 L^.45 - .1115", "[SMPTE240]", "0..1, odd"},
    {"romm", romm_encode, romm_decode, "E = 16 L below 1/512, else L^(1/1.8)", "[ISO22028]",
     "0..1, odd"},
    {"adobe", adobe_encode, adobe_decode, "E = L^(256/563)", "[AdobeRgb 4.3.4.2]", "0..1, odd"},
    {"lstar", lstar_encode, lstar_decode,
     "E = (24389/27) L/100 up to 216/24389, else 1.16 L^(1/3) - .16", "[CIE15 8.2.1]",
     "0..1, straight below 0"},
    {"pq", pq_encode, pq_decode,
     "E = ((c1 + c2 L^m1)/(1 + c3 L^m1))^m2, m1 = 2610/16384, m2 = 2523/32, c1 = 3424/4096, "
     "c2 = 2413/128, c3 = 2392/128",
     "[ST2084]", "0..1, 1 is 10000 cd/m2; below 0 as 0"},
    {"hlg", hlg_encode, hlg_decode,
     "E = sqrt(3 L) up to 1/12, else a ln(12 L - b) + c, a = .17883277, b = 1 - 4a, "
     "c = .5 - a ln(4a)",
     "[BT2100 table 5]", "0..1, light of the scene, odd"},
    {"acescc", acescc_encode, acescc_decode,
     "E = (log2 L + 9.72)/17.52; (log2(2^-16 + L/2) + 9.72)/17.52 below 2^-15", "[AcesCc 4.4]",
     "0..65504; below 0 as 0, codes as low as -.3584 and on below it"},
    {"acescct", acescct_encode, acescct_decode,
     "E = (log2 L + 9.72)/17.52; 10.5402377416545 L + .0729055341958355 up to .0078125",
     "[AcesCct 4.4]", "0..65504, straight below 0"},
};

}  // namespace tristim
