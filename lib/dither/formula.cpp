#include "tristim/dither/formula.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "lib/core/math.h"
#include "lib/core/trigonometry.h"
#include "lib/dither/sine.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim {
namespace {

constexpr std::size_t kMostCharacters = 1000;
constexpr int kMostNesting = 100;
constexpr double kPi = 3.14159265358979323846;
constexpr double kE = 2.71828182845904523536;
constexpr double kDegrees = 180 / kPi;

double add(double a, double b) noexcept { return a + b; }
double subtract(double a, double b) noexcept { return a - b; }
double multiply(double a, double b) noexcept { return a * b; }
double divide(double a, double b) noexcept { return a / b; }
double power(double a, double b) noexcept { return detail::pow(a, b); }
double negate(double a, double) noexcept { return -a; }

double sine(double a, double) noexcept { return detail::sine(a); }
double cosine(double a, double) noexcept { return detail::cosine(a); }
double tangent(double a, double) noexcept { return detail::sine(a) / detail::cosine(a); }
// (-pi, pi]
double arc_tangent2(double y, double x) noexcept {
  const double degrees = detail::angle_deg(y, x);
  return (degrees > 180 ? degrees - 360 : degrees) / kDegrees;
}
double arc_tangent(double a, double) noexcept { return arc_tangent2(a, 1); }
double square_root(double a, double) noexcept { return std::sqrt(a); }
double absolute(double a, double) noexcept { return std::fabs(a); }
double exponential(double a, double) noexcept { return detail::exp(a); }
double logarithm(double a, double) noexcept { return detail::log(a); }
double hypotenuse(double a, double b) noexcept { return detail::hypotenuse(a, b); }
double smaller(double a, double b) noexcept { return b < a ? b : a; }
double larger(double a, double b) noexcept { return a < b ? b : a; }
double whole(double a, double) noexcept { return std::floor(a); }

constexpr std::array kConstants{std::pair{std::string_view("pi"), kPi},
                                std::pair{std::string_view("e"), kE}};

bool is_blank(char c) { return c == ' ' || c == '\t'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

// sum = product {(+|-) product}; product = signed {(*|/) signed}; signed = (+|-) signed | power;
// power = atom [^ signed]; atom = number | x | y | constant | function(sum, ...) | (sum)
class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  std::vector<Formula::Step> parse() {
    if (text_.size() > kMostCharacters) {
      throw std::invalid_argument("a formula of " + std::to_string(text_.size()) +
                                  " characters; at most " + std::to_string(kMostCharacters) +
                                  " are read");
    }
    sum();
    if (peek() != '\0') fail("unexpected '" + std::string(1, peek()) + "'");
    return std::move(steps_);
  }

 private:
  [[noreturn]] void fail(const std::string& wrong) const {
    throw std::invalid_argument(wrong + " at character " + std::to_string(at_ + 1) + " of '" +
                                std::string(text_) + "'");
  }

  char peek() {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }

  bool take(char c) {
    if (peek() != c) return false;
    ++at_;
    return true;
  }

  void call(double (*function)(double, double) noexcept, int arguments) {
    steps_.push_back({function, 0, 0, arguments});
  }

  void sum() {
    if (++nesting_ > kMostNesting) fail("too many levels");
    product();
    for (;;) {
      if (take('+')) {
        product();
        call(add, 2);
      } else if (take('-')) {
        product();
        call(subtract, 2);
      } else {
        break;
      }
    }
    --nesting_;
  }

  void product() {
    with_sign();
    for (;;) {
      if (take('*')) {
        with_sign();
        call(multiply, 2);
      } else if (take('/')) {
        with_sign();
        call(divide, 2);
      } else {
        return;
      }
    }
  }

  void with_sign() {
    if (++nesting_ > kMostNesting) fail("too many levels");
    if (take('-')) {
      with_sign();
      call(negate, 1);
    } else if (take('+')) {
      with_sign();
    } else {
      atom();
      if (take('^')) {
        with_sign();
        call(power, 2);
      }
    }
    --nesting_;
  }

  void atom() {
    const char c = peek();
    if (take('(')) {
      sum();
      if (!take(')')) fail("')' is missing");
    } else if (is_digit(c) || c == '.') {
      number();
    } else if (is_letter(c)) {
      name();
    } else {
      fail(c == '\0' ? "the formula ends" : "unexpected '" + std::string(1, c) + "'");
    }
  }

  void number() {
    const std::size_t start = at_;
    const auto digits = [this] {
      while (at_ < text_.size() && (is_digit(text_[at_]) || text_[at_] == '.')) ++at_;
    };
    digits();
    if (at_ < text_.size() && (text_[at_] == 'e' || text_[at_] == 'E')) {
      std::size_t sign = at_ + 1;
      if (sign < text_.size() && (text_[sign] == '+' || text_[sign] == '-')) ++sign;
      if (sign < text_.size() && is_digit(text_[sign])) {
        at_ = sign;
        digits();
      }
    }
    const auto value = parse_number(text_.substr(start, at_ - start));
    if (!value || !std::isfinite(*value)) {
      const std::string word(text_.substr(start, at_ - start));
      at_ = start;
      fail("'" + word + "' is no number");
    }
    steps_.push_back({nullptr, *value, 0, 0});
  }

  void name() {
    const std::size_t start = at_;
    while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) ++at_;
    const std::string word(text_.substr(start, at_ - start));
    if (word == "x" || word == "y") {
      steps_.push_back({nullptr, 0, word[0], 0});
      return;
    }
    for (const auto& [constant, value] : kConstants) {
      if (word != constant) continue;
      steps_.push_back({nullptr, value, 0, 0});
      return;
    }
    const FormulaFunction* function = find_by_name(formula_functions(), word);
    if (function == nullptr) {
      at_ = start;
      fail("unknown name '" + word + "' (there are x, y, pi, e, " +
           list_names(formula_functions()) + ")");
    }
    arguments_of(*function);
  }

  void arguments_of(const FormulaFunction& function) {
    if (!take('(')) fail("'(' is missing behind " + std::string(function.name));
    for (int i = 0; i < function.arguments; ++i) {
      if (i > 0 && !take(',')) {
        fail(std::string(function.name) + " takes " + std::to_string(function.arguments) +
             " values: ',' is missing");
      }
      sum();
    }
    if (!take(')')) fail("')' is missing");
    call(function.value, function.arguments);
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int nesting_ = 0;
  std::vector<Formula::Step> steps_;
};

}  // namespace

const std::vector<FormulaFunction>& formula_functions() {
  static const std::vector<FormulaFunction> functions{
      {"sin", 1, sine},           {"cos", 1, cosine},       {"tan", 1, tangent},
      {"atan", 1, arc_tangent},   {"sqrt", 1, square_root}, {"abs", 1, absolute},
      {"exp", 1, exponential},    {"log", 1, logarithm},    {"floor", 1, whole},
      {"atan2", 2, arc_tangent2}, {"hypot", 2, hypotenuse}, {"min", 2, smaller},
      {"max", 2, larger}};
  return functions;
}

Formula::Formula(std::string_view text) : text_(text), steps_(Parser(text).parse()) {}

double Formula::operator()(double x, double y) const noexcept {
  // Every level of nesting holds three values at most: a sum, a product, a base.
  std::array<double, 3 * kMostNesting + 3> stack;
  std::size_t top = 0;
  for (const Step& step : steps_) {
    if (step.function == nullptr) {
      stack[top++] = step.variable == 0 ? step.value : step.variable == 'x' ? x : y;
    } else if (step.arguments == 1) {
      stack[top - 1] = step.function(stack[top - 1], 0);
    } else {
      --top;
      stack[top - 1] = step.function(stack[top - 1], stack[top]);
    }
  }
  return stack[0];
}

}  // namespace tristim
