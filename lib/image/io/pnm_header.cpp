#include "lib/image/io/pnm_header.h"

#include <span>
#include <string_view>

#include "tristim/core/error.h"

namespace tristim::detail {
namespace {

constexpr std::int64_t kMostNumber = std::int64_t{1} << 40;
constexpr std::size_t kMostWord = 64;

bool is_space(int c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

// The first character that is neither white space nor in a comment.
int skip_space(CharacterReader& characters) {
  int c = characters.next();
  while (is_space(c) || c == '#') {
    if (c == '#') {
      while (c != '\n' && c >= 0) c = characters.next();
    } else {
      c = characters.next();
    }
  }
  return c;
}

// Up to the white space that ends it, which is read too.
std::string read_word(CharacterReader& characters) {
  std::string word;
  for (int c = skip_space(characters); c >= 0 && !is_space(c) && word.size() < kMostWord;
       c = characters.next()) {
    word += static_cast<char>(c);
  }
  return word;
}

// Ends after the one character of white space behind the number, where the samples begin.
std::int64_t read_last_number(CharacterReader& characters) {
  const std::int64_t number = read_number(characters);
  characters.next();
  return number;
}

void read_pam_header(CharacterReader& characters, PnmHeader& header) {
  std::string type;
  for (;;) {
    const std::string key = read_word(characters);
    if (key == "ENDHDR") break;
    if (key == "WIDTH") {
      header.width = read_number(characters);
    } else if (key == "HEIGHT") {
      header.height = read_number(characters);
    } else if (key == "DEPTH") {
      header.samples = static_cast<int>(read_number(characters));
    } else if (key == "MAXVAL") {
      header.maximum = read_number(characters);
    } else if (key == "TUPLTYPE") {
      type = read_word(characters);
    } else {
      header.width = -1;  // no such key, or the end
      return;
    }
  }
  header.alpha = std::string_view(type).ends_with("_ALPHA") || header.samples % 2 == 0;
}

void read_size(CharacterReader& characters, PnmHeader& header) {
  header.width = read_number(characters);
  header.height = read_number(characters);
}

}  // namespace

int CharacterReader::next() {
  if (at_ == size_) {
    size_ = file_.read_at(position_, block_);
    position_ += size_;
    at_ = 0;
    if (size_ == 0) return -1;
  }
  return static_cast<int>(block_[at_++]);
}

std::int64_t read_number(CharacterReader& characters) {
  int c = skip_space(characters);
  if (c < '0' || c > '9') return -1;
  std::int64_t number = 0;
  for (; c >= '0' && c <= '9'; c = characters.next()) {
    if (number > kMostNumber) return -1;
    number = number * 10 + (c - '0');
  }
  if (c >= 0) characters.back();
  return number;
}

PnmHeader read_pnm_header(const InputFile& file) {
  CharacterReader characters(file, 1);  // after the P
  const int kind = characters.next();
  PnmHeader header;
  if (kind == '7') {
    header.format = "pam";
    read_pam_header(characters, header);
  } else if (kind == 'f' || kind == 'F') {
    header.format = "pfm";
    header.samples = kind == 'F' ? 3 : 1;
    read_size(characters, header);
    header.little_endian = read_word(characters).starts_with('-');
  } else {
    header.format = kind == '1' || kind == '4' ? "pbm" : kind == '2' || kind == '5' ? "pgm" : "ppm";
    header.samples = header.format == "ppm" ? 3 : 1;
    header.text = kind < '4';
    header.packed = kind == '4';
    if (header.format == "pbm") {
      header.width = read_number(characters);
      header.height = read_last_number(characters);
    } else {
      read_size(characters, header);
      header.maximum = read_last_number(characters);
    }
  }
  header.data = characters.position();
  const bool good = header.width >= 0 && header.height >= 0 && header.samples >= 1 &&
                    header.samples <= 4 && header.maximum >= 1 && header.maximum <= 65535;
  if (!good) {
    throw Error(ErrorKind::kContent, file.name(), "its " + header.format + " header is damaged",
                "write or copy it again");
  }
  return header;
}

}  // namespace tristim::detail
