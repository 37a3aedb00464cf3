#pragma once

#include <string_view>

namespace tristim {

/// Luminance factor of a Munsell value [ASTMD1535]: Y/100 = 1.1914 V - 0.22533 V^2 + 0.23352 V^3 -
/// 0.020484 V^4 + 0.00081939 V^5. V in [0, 10] to [0, 1], the perfect diffuser at 1; outside there
/// is no value: NaN.
double luminance_from_munsell_value(double value) noexcept;

/// The inverse of luminance_from_munsell_value, within 1e-13. A luminance that rounding left above
/// 1, by 1e-12 at the most, is white: 10. Outside of [0, 1] there is no value: NaN.
double munsell_value_from_luminance(double luminance) noexcept;

/// A formula that makes a Munsell value of a luminance factor in [0, 1]; the older ones are closed
/// forms. They go on outside as the formula does, with NaN where it has no value.
struct MunsellValueFunction {
  std::string_view name;
  double (*value_from_luminance)(double luminance) noexcept;
  std::string_view formula;  // of Y in percent
  std::string_view source;
};

double priest1920_value(double luminance) noexcept;
double munsell1933_value(double luminance) noexcept;
double moon1943_value(double luminance) noexcept;
double saunderson1944_value(double luminance) noexcept;
double ladd1955_value(double luminance) noexcept;
double mccamy1987_value(double luminance) noexcept;

/// Every value function. The command line, the help and the tests read this list.
inline constexpr MunsellValueFunction kMunsellValueFunctions[] = {
    {"astm-d1535", munsell_value_from_luminance,
     "Y = 1.1914 V - .22533 V^2 + .23352 V^3 - .020484 V^4 + .00081939 V^5, solved for V",
     "[ASTMD1535]"},
    {"priest1920", priest1920_value, "10 sqrt(Y/100)", "[Priest20]"},
    {"munsell1933", munsell1933_value, "sqrt(1.4742 Y - .004743 Y^2)", "[Munsell33]"},
    {"moon1943", moon1943_value, "1.4 Y^.426", "[Moon43]"},
    {"saunderson1944", saunderson1944_value, "2.357 Y^.343 - 1.52", "[Saunderson44]"},
    {"ladd1955", ladd1955_value, "2.468 Y^(1/3) - 1.636", "[Ladd55]"},
    {"mccamy1987", mccamy1987_value,
     ".87445 Y^.9967 up to .9; 2.49268 Y^(1/3) - 1.5614 - .985/((.1073 Y - 3.084)^2 + 7.54) + "
     ".0133/Y^2.3 + .0084 sin(4.1 Y^(1/3) + 1) + (.0221/Y) sin(.39 (Y - 2)) - (.0037/(.44 Y)) "
     "sin(1.28 (Y - .53))",
     "[McCamy92]"},
};

}  // namespace tristim
