#include "tristim/core/error.h"

#include <system_error>

namespace tristim {
namespace {

std::string one_line(std::string_view thing, std::string_view wrong, std::string_view remedy) {
  std::string text(thing);
  text += ": ";
  text += wrong;
  if (!remedy.empty()) {
    text += "; ";
    text += remedy;
  }
  for (char& c : text) {
    const bool control = static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
    if (control) c = '?';
  }
  return text;
}

}  // namespace

Error::Error(ErrorKind kind, std::string_view thing, std::string_view wrong,
             std::string_view remedy)
    : std::runtime_error(one_line(thing, wrong, remedy)), kind_(kind) {}

std::string system_message(int error_number) {
  std::string text = std::generic_category().message(error_number);
  if (!text.empty() && text[0] >= 'A' && text[0] <= 'Z') text[0] = static_cast<char>(text[0] + 32);
  return text;
}

}  // namespace tristim
