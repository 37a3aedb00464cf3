#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tristim {

/// A formula in x and y, read from text: numbers, x, y, pi, e, + - * / ^, parentheses and functions
/// of formula_functions(), in radians. ^ binds tightest and to the right, -x^2 is -(x^2).
///
/// Values are the same on every machine.
class Formula {
 public:
  /// Throws std::invalid_argument "<what is wrong> at character N of '<text>'" where `text` is no
  /// formula, counted from 1; texts beyond 1000 characters or 100 levels of nesting are refused.
  explicit Formula(std::string_view text);

  /// NaN or infinite where the formula is.
  double operator()(double x, double y) const noexcept;

  const std::string& text() const noexcept { return text_; }

  /// A step of the compiled formula, for a machine with a stack.
  struct Step {
    double (*function)(double, double) noexcept;  // nullptr: puts a value or a variable
    double value;
    char variable;  // 'x' or 'y'; 0: `value`
    int arguments;  // 1 or 2; a function of one ignores its second
  };

 private:
  std::string text_;
  std::vector<Step> steps_;
};

struct FormulaFunction {
  std::string_view name;
  int arguments;
  double (*value)(double, double) noexcept;
};

/// Every function. The parser and its messages read this list.
const std::vector<FormulaFunction>& formula_functions();

}  // namespace tristim
