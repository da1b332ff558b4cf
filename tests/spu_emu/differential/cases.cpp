#include "differential/cases.h"

#include <array>

namespace differential {
namespace {

using Quadword = std::array<std::uint32_t, 4>;

constexpr std::array<std::uint32_t, 37> kEdges = {
    0x00000000, 0x80000000, 0xffffffff, 0x7fffffff, 0x00000001, 0x3f800000, 0xbf800000, 0x00400000,
    0x80400000, 0x00800000, 0x80800000, 0x007fffff, 0x7f7fffff, 0xff7fffff, 0x7f800000, 0xff800000,
    0x7fc00000, 0x7f000000, 0x3fffffff, 0x4b000000, 0x4effffff, 0x4f000000, 0xcf000000, 0x4f7fffff,
    0x4f800000, 0x00010020, 0x001f000f, 0x7fff8001, 0x00000020, 0xffffffe0, 0x80808080, 0x7ff00000,
    0xfff80000, 0x000fffff, 0x80008000, 0x3f000001, 0xbf000001};

class Source {
 public:
  explicit Source(std::uint64_t seed) : random_(seed) {}

  Quadword next() {
    switch (below(7)) {
      case 0:
        return each([&] { return bits(); });
      case 1:
        return each([&] { return kEdges[below(kEdges.size())]; });
      case 2:
        return each([&] { return below(64); });
      case 3:
        return each([&] { return float_near(127, 4); });
      case 4:
        return each([&] { return float_near(127, 100); });
      case 5:
        return doubles();
      default: {
        const std::uint32_t word = below(2) == 0 ? kEdges[below(kEdges.size())] : bits();
        return {word, word, word, word};
      }
    }
  }

 private:
  std::uint32_t bits() { return static_cast<std::uint32_t>(random_()); }
  std::uint32_t below(std::size_t n) { return static_cast<std::uint32_t>(random_() % n); }

  template <class Make>
  static Quadword each(Make make) {
    return {make(), make(), make(), make()};
  }
  std::uint32_t float_near(std::uint32_t exponent, std::uint32_t spread) {
    return (bits() & 0x807fffffU) | ((exponent - spread + below(2 * spread + 1)) << 23U);
  }
  Quadword doubles() {
    const auto high = [&] { return (bits() & 0x800fffffU) | ((1023 - 40 + below(80)) << 20U); };
    return {high(), bits(), high(), below(2) == 0 ? 0 : bits()};
  }

  std::mt19937_64 random_;
};

}  // namespace

std::vector<std::uint32_t> make_words(std::size_t quadwords, std::uint64_t seed) {
  Source source(seed);
  std::vector<std::uint32_t> words;
  words.reserve(quadwords * 4);
  for (std::size_t i = 0; i < quadwords; ++i) {
    for (const std::uint32_t word : source.next()) words.push_back(word);
  }
  return words;
}

}  // namespace differential
