#include "io/dxf_text.h"

#include <cctype>
#include <cstdint>

namespace toile {

namespace {

void append_utf8(std::string& text, std::uint32_t code) {
  if (code < 0x20 || (code >= 0xD800 && code <= 0xDFFF) || code > 0x10FFFF) code = 0xFFFD;
  if (code < 0x80) {
    text += static_cast<char>(code);
  } else if (code < 0x800) {
    text += static_cast<char>(0xC0 | code >> 6);
    text += static_cast<char>(0x80 | (code & 0x3F));
  } else if (code < 0x10000) {
    text += static_cast<char>(0xE0 | code >> 12);
    text += static_cast<char>(0x80 | (code >> 6 & 0x3F));
    text += static_cast<char>(0x80 | (code & 0x3F));
  } else {
    text += static_cast<char>(0xF0 | code >> 18);
    text += static_cast<char>(0x80 | (code >> 12 & 0x3F));
    text += static_cast<char>(0x80 | (code >> 6 & 0x3F));
    text += static_cast<char>(0x80 | (code & 0x3F));
  }
}

/// The number of `digits` digits of `base` from `at` on; -1 if they are not there.
int digits_at(std::string_view text, std::size_t at, std::size_t digits, int base) {
  if (at + digits > text.size()) return -1;
  int value = 0;
  for (std::size_t i = at; i < at + digits; ++i) {
    const char c = text[i];
    const int digit = std::isdigit(static_cast<unsigned char>(c)) != 0    ? c - '0'
                      : std::isxdigit(static_cast<unsigned char>(c)) != 0 ? (c | 0x20) - 'a' + 10
                                                                          : 99;
    if (digit >= base) return -1;
    value = value * base + digit;
  }
  return value;
}

/// Takes \U+XXXX or a % code at `at`, if there is one, and goes on behind it.
bool take_character(std::string_view text, std::size_t& at, std::string& plain) {
  if (text.substr(at, 3) == "\\U+") {
    const int code = digits_at(text, at + 3, 4, 16);
    if (code < 0) return false;
    append_utf8(plain, static_cast<std::uint32_t>(code));
    at += 7;
    return true;
  }
  if (text.substr(at, 2) != "%%" || at + 2 >= text.size()) return false;
  const int code = digits_at(text, at + 2, 3, 10);
  if (code >= 0) {
    append_utf8(plain, static_cast<std::uint32_t>(code));
    at += 5;
    return true;
  }
  switch (text[at + 2] | 0x20) {
    case 'd':
      plain += "\xC2\xB0";
      break;
    case 'p':
      plain += "\xC2\xB1";
      break;
    case 'c':
      plain += "\xE2\x8C\x80";
      break;
    case 'u':
    case 'o':
    case 'k':
      break;
    default:
      plain += text[at + 2] == '%' ? "%" : "";
      break;
  }
  at += 3;
  return true;
}

}  // namespace

std::string plain_dxf_text(std::string_view text) {
  std::string plain;
  for (std::size_t at = 0; at < text.size();) {
    if (!take_character(text, at, plain)) plain += text[at++];
  }
  return plain;
}

std::string plain_dxf_paragraphs(std::string_view text) {
  constexpr std::string_view with_value = "fFHWQTACcSp";  // up to a semicolon
  std::string plain;
  for (std::size_t at = 0; at < text.size();) {
    if (take_character(text, at, plain)) continue;
    const char c = text[at++];
    if (c == '{' || c == '}') continue;
    if (c == '^' && at < text.size()) {  // ^J is a new line, ^I a tab
      plain += text[at] == 'J' ? '\n' : ' ';
      ++at;
      continue;
    }
    if (c != '\\' || at >= text.size()) {
      plain += c;
      continue;
    }
    const char code = text[at++];
    if (code == 'P' || code == 'N' || code == 'X') {
      plain += '\n';
    } else if (code == '~') {
      plain += ' ';
    } else if (code == '\\' || code == '{' || code == '}') {
      plain += code;
    } else if (with_value.find(code) != std::string_view::npos) {
      const std::size_t end = text.find(';', at);
      if (code == 'S') plain += text.substr(at, end == std::string_view::npos ? end : end - at);
      at = end == std::string_view::npos ? text.size() : end + 1;
    }
  }
  return plain;
}

}  // namespace toile
