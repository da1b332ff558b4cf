#include "simdmath/accuracy.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <random>

namespace simdmath_test {

namespace {

using Bits = std::uint64_t;
using Arguments = std::array<Bits, 3>;

class Sampler {
 public:
  Sampler(const Reference& reference, const Format& format) : reference_(reference), format_(format) {}

  std::vector<Arguments> sample(int density) {
    const auto exponents = static_cast<int>(format_.largest_exponent()) + 1;
    for (int exponent = 0; exponent < exponents; ++exponent) {
      for (int i = 0; i < density; ++i) add(exponent);
    }
    // Where most functions do what they do.
    const int near = format_.bias() - 30;
    for (int i = 0; i < density * 256; ++i) add(near + static_cast<int>(random_() % 40));
    return std::move(samples_);
  }

 private:
  Bits with_exponent(int exponent) {
    const auto shift = static_cast<unsigned>(format_.fraction_bits);
    const Bits mask = (Bits{1} << shift) - 1;
    Bits fraction = random_() & mask;
    switch (random_() % 8) {
      case 0:
        fraction = 0;
        break;
      case 1:
        fraction = mask;
        break;
      case 2:
        fraction &= random_() % 16;
        break;
      case 3:
        fraction |= mask & ~(random_() % 16);
        break;
      case 4:
        fraction &= ~Bits{0} << (random_() % shift);
        break;
      default:
        break;
    }
    const Bits sign = random_() % 2;
    return sign << (shift + static_cast<unsigned>(format_.exponent_bits)) |
           static_cast<Bits>(exponent) << shift | fraction;
  }

  /// An exponent whose power of the first argument is within the range, more often than not.
  int exponent_of_power(int first) {
    const int distance = std::abs(first - format_.bias()) + 1;
    int reach = 0;
    while ((distance << reach) < format_.bias()) ++reach;
    return format_.bias() + reach - static_cast<int>(random_() % 12);
  }

  void add(int exponent) {
    const int largest = static_cast<int>(format_.largest_exponent());
    Arguments arguments{};
    arguments[0] = with_exponent(exponent);
    for (int i = 1; i < reference_.arguments; ++i) {
      int other = static_cast<int>(random_() % static_cast<unsigned>(largest + 1));
      if (random_() % 2 == 0)
        other = std::clamp(exponent + static_cast<int>(random_() % 40) - 20, 0, largest);
      if (reference_.name == "pow" && random_() % 4 != 0)
        other = std::clamp(exponent_of_power(exponent), 0, largest);
      arguments[static_cast<std::size_t>(i)] = with_exponent(other);
    }
    if (reference_.name == "pow" && random_() % 2 == 0) arguments[0] &= ~(Bits{1} << sign_bit());
    samples_.push_back(arguments);
  }

  [[nodiscard]] unsigned sign_bit() const {
    return static_cast<unsigned>(format_.fraction_bits + format_.exponent_bits);
  }

  const Reference& reference_;
  const Format& format_;
  std::mt19937_64 random_{20};
  std::vector<Arguments> samples_;
};

std::vector<Call> as_calls(const std::vector<Arguments>& samples, std::size_t lanes) {
  std::vector<Call> calls((samples.size() + lanes - 1) / lanes);
  for (std::size_t i = 0; i < calls.size() * lanes; ++i) {
    const Arguments& arguments = samples[std::min(i, samples.size() - 1)];
    for (std::size_t a = 0; a < arguments.size(); ++a) {
      Words& words = calls[i / lanes][a];
      if (lanes == 4) {
        words[i % 4] = static_cast<std::uint32_t>(arguments[a]);
      } else {
        words[i % 2 * 2] = static_cast<std::uint32_t>(arguments[a] >> 32U);
        words[i % 2 * 2 + 1] = static_cast<std::uint32_t>(arguments[a]);
      }
    }
  }
  return calls;
}

Bits element(const Words& words, std::size_t lane, std::size_t lanes) {
  return lanes == 4 ? words[lane] : Bits{words[lane * 2]} << 32U | words[lane * 2 + 1];
}

std::string describe(const Arguments& arguments, Bits result) {
  char text[120];
  std::snprintf(text, sizeof text, "%llx %llx %llx -> %llx", static_cast<unsigned long long>(arguments[0]),
                static_cast<unsigned long long>(arguments[1]), static_cast<unsigned long long>(arguments[2]),
                static_cast<unsigned long long>(result));
  return text;
}

}  // namespace

Accuracy measure(const Reference& reference, const std::string& function, const Format& format,
                 const Evaluate& evaluate, int density) {
  const std::size_t lanes = format.fraction_bits == 23 ? 4 : 2;
  const std::vector<Arguments> samples = Sampler(reference, format).sample(density);
  const std::vector<Result> results = evaluate(number_of(function), as_calls(samples, lanes));
  Accuracy accuracy;
  Number x;
  Number y;
  Number z;
  Number exact;
  Number size;
  mpfr_set_zero(size, 1);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    set_to(x, format, as_operand(format, samples[i][0]));
    set_to(y, format, as_operand(format, samples[i][1]));
    set_to(z, format, as_operand(format, samples[i][2]));
    reference.exact(exact, x, y, z);
    if (reference.size != nullptr && lanes == 2) reference.size(size, x);
    const Bits result = element(results[i / lanes][reference.second ? 1 : 0], i % lanes, lanes);
    const double error = error_of(format, result, exact, size);
    ++accuracy.samples;
    if (error <= accuracy.error) continue;
    accuracy.error = error;
    accuracy.worst = describe(samples[i], result);
  }
  return accuracy;
}

}  // namespace simdmath_test
