#include "io/encoding.h"

#include <iconv.h>

#include <algorithm>
#include <cerrno>

namespace toile {

bool is_utf8(std::string_view text) {
  // iconv would need a copy; this asks only how long each sequence has to be.
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
    const unsigned first = byte(i);
    std::size_t length = 1;
    if (first >= 0x80) {
      length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
      if (first < 0xC2 || first > 0xF4 || i + length > text.size()) return false;
      for (std::size_t k = 1; k < length; ++k) {
        if ((byte(i + k) & 0xC0U) != 0x80) return false;
      }
      const unsigned second = byte(i + 1);
      if ((first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F) ||
          (first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F)) {
        return false;
      }
    }
    i += length;
  }
  return true;
}

std::string to_utf8(std::string_view text, const std::string& code_page) {
  const auto ascii = [](char c) { return static_cast<unsigned char>(c) < 0x80; };
  if (std::all_of(text.begin(), text.end(), ascii)) return std::string(text);
  iconv_t converter = iconv_open("UTF-8", code_page.c_str());
  if (converter == reinterpret_cast<iconv_t>(-1)) converter = iconv_open("UTF-8", "CP1252");
  const std::string unknown = "\xEF\xBF\xBD";
  std::string result;
  if (converter == reinterpret_cast<iconv_t>(-1)) {
    for (const char c : text) result += ascii(c) ? std::string(1, c) : unknown;
    return result;
  }
  std::string input(text);
  char* from = input.data();
  std::size_t left = input.size();
  while (left > 0) {
    char buffer[256];
    char* to = buffer;
    std::size_t room = sizeof buffer;
    const std::size_t done = iconv(converter, &from, &left, &to, &room);
    result.append(buffer, sizeof buffer - room);
    if (done == static_cast<std::size_t>(-1) && errno != E2BIG) {
      result += unknown;
      ++from;
      --left;
      iconv(converter, nullptr, nullptr, nullptr, nullptr);
    }
  }
  iconv_close(converter);
  return result;
}

}  // namespace toile
