#include "tests/fuzz/fuzz.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <random>

#include "geometry/error.h"
#include "io/output_file.h"

namespace toile::fuzz {

namespace {

/// Seconds that one input may take: the reader is to refuse what takes longer.
constexpr double max_seconds = 20;

using Random = std::mt19937_64;

std::size_t below(Random& random, std::size_t count) { return count == 0 ? 0 : random() % count; }

/// Where the line around `at` begins and where the next one does.
std::pair<std::size_t, std::size_t> line_at(const std::string& text, std::size_t at) {
  const std::size_t before = text.rfind('\n', at == 0 ? 0 : at - 1);
  const std::size_t after = text.find('\n', at);
  return {before == std::string::npos ? 0 : before + 1,
          after == std::string::npos ? text.size() : after + 1};
}

/// Where the number, name or quoted text around `at` begins, and where it ends.
std::pair<std::size_t, std::size_t> token_at(const std::string& text, std::size_t at) {
  const char* const borders = " \t\r\n,:;=<>(){}[]";
  const std::size_t before = at == 0 ? std::string::npos : text.find_last_of(borders, at - 1);
  const std::size_t after = text.find_first_of(borders, at);
  return {before == std::string::npos ? 0 : before + 1,
          after == std::string::npos ? text.size() : after};
}

/// Puts a word, or another token of the text, in a token's place: the form of the file stays.
void exchange_token(std::string& text, const std::vector<std::string>& words, Random& random) {
  const auto [from, to] = token_at(text, below(random, text.size()));
  std::string instead = words[below(random, words.size())];
  if (below(random, 2) == 0) {
    const auto [first, last] = token_at(text, below(random, text.size()));
    instead = text.substr(first, last - first);
  }
  text.replace(from, to - from, instead);
}

void damage(std::string& text, const std::string& other, const std::vector<std::string>& words,
            Random& random) {
  const std::size_t at = below(random, text.size());
  switch (below(random, 9)) {
    case 0:
      text.resize(at);
      break;
    case 1:
      if (!text.empty()) text[at] = static_cast<char>(text[at] ^ (1 << below(random, 8)));
      break;
    case 2:
      text.erase(at, below(random, 60));
      break;
    case 3: {
      const auto [from, to] = line_at(text, at);
      text.replace(from, to - from, words[below(random, words.size())] + "\n");
      break;
    }
    case 4:
      text.insert(at, words[below(random, words.size())]);
      break;
    case 5: {  // a part once more, somewhere else
      const std::size_t length = below(random, 400);
      text.insert(below(random, text.size()), text.substr(at, length));
      break;
    }
    case 6:
      text.insert(at, other.substr(below(random, other.size()), below(random, 600)));
      break;
    case 7: {  // two lines change places
      const auto [from, to] = line_at(text, at);
      const std::string line = text.substr(from, to - from);
      text.erase(from, to - from);
      text.insert(line_at(text, below(random, text.size())).first, line);
      break;
    }
    default: {  // two lines at once: formats in pairs of lines stay in step
      const std::size_t from = line_at(text, at).first;
      const std::size_t to = line_at(text, line_at(text, at).second).second;
      text.erase(from, to - from);
    }
  }
}

}  // namespace

ScratchFile::ScratchFile(std::filesystem::path where, const std::string& text)
    : path(std::move(where)) {
  std::ofstream(path, std::ios::binary) << text;
}

ScratchFile::~ScratchFile() {
  std::error_code ignored;
  std::filesystem::remove(path, ignored);
}

int run(int argc, char** argv, const std::vector<std::filesystem::path>& seeds,
        const std::vector<std::string>& words, const Target& target) {
  using Clock = std::chrono::steady_clock;
  const double seconds = argc > 1 ? std::atof(argv[1]) : 5;
  Random random(argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1);
  std::vector<std::string> texts;
  for (const auto& seed : seeds) texts.push_back(read_file(seed));
  const std::string kept = std::string(argv[0]) + ".input";
  const auto since = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  const auto start = Clock::now();
  long long inputs = 0;
  long long refused = 0;
  double slowest = 0;
  while (since(start) < seconds) {
    std::string text = texts[below(random, texts.size())];
    const std::string& other = texts[below(random, texts.size())];
    const bool keeps_form = below(random, 2) == 0;
    for (std::size_t k = 0; k <= below(random, 6); ++k) {
      if (keeps_form) {
        exchange_token(text, words, random);
      } else {
        damage(text, other, words, random);
      }
    }
    std::ofstream(kept, std::ios::binary) << text;
    const auto begun = Clock::now();
    try {
      target(text);
    } catch (const Error&) {
      ++refused;
    }
    slowest = std::max(slowest, since(begun));
    if (slowest > max_seconds) {
      std::printf("an input took %.1f s; it is in %s\n", slowest, kept.c_str());
      return 1;
    }
    ++inputs;
  }
  std::filesystem::remove(kept);
  std::printf("%lld inputs, %lld refused, the slowest took %.2f s\n", inputs, refused, slowest);
  // Damage that never matters would test nothing.
  return refused > 0 && refused < inputs ? 0 : 1;
}

}  // namespace toile::fuzz
