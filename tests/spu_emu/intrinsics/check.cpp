#include "check.h"

#include <random>
#include <string>
#include <vector>

namespace reference {

namespace {

template <int Width>
Register repeated(std::uint64_t value) {
  return build<Width>([&](int) { return value; });
}

const std::vector<std::uint32_t>& edge_words() {
  static const std::vector<std::uint32_t> words = {
      0x00000000, 0x80000000, 0xffffffff, 0x7fffffff, 0x00000001, 0x3f800000, 0xbf800000,
      0x00400000, 0x80400000, 0x00800000, 0x80800000, 0x007fffff, 0x00c00000, 0x7f7fffff,
      0xff7fffff, 0x7f800000, 0xff800000, 0x7f800001, 0x7fc00000, 0x7f600000, 0x3fffffff,
      0x3f7fffff, 0x4b000000, 0x4effffff, 0x4f000000, 0xcf000000, 0x4f7fffff, 0x4f800000,
      0x34000000, 0x00010020, 0x001f000f, 0x00ff8000, 0x7fff8001, 0x00000020, 0xffffffe0,
      0x80808080, 0x7f807f80, 0x01234567, 0x89abcdef, 0x00000100, 0x0000ffff, 0xffff0000};
  return words;
}

const std::vector<std::uint64_t>& edge_doublewords() {
  static const std::vector<std::uint64_t> values = {
      0x0000000000000000, 0x8000000000000000, 0x3ff0000000000000, 0xbff0000000000000, 0x7ff0000000000000,
      0xfff0000000000000, 0x7ff8000000000000, 0x7ff4000000000000, 0xfff8000000000001, 0x0008000000000000,
      0x8000000000000001, 0x0010000000000000, 0x8010000000000000, 0x001fffffffffffff, 0x7fefffffffffffff,
      0xffefffffffffffff, 0x3810000000000000, 0x3800000000000000, 0x47efffffe0000000, 0x47effffff0000000,
      0x3ff0000010000000, 0x3ff0000030000000, 0x7fffffffffffffff, 0x3cb0000000000000};
  return values;
}

template <typename T>
T pick(const std::vector<T>& from, std::mt19937_64& random) {
  return from[random() % from.size()];
}

// Registers at the limits of some lane width, some float class or some count.
const std::vector<Register>& edge_registers() {
  static const std::vector<Register> registers = [] {
    std::vector<Register> all;
    for (const std::uint32_t word : edge_words()) all.push_back(repeated<4>(word));
    for (const std::uint64_t value : edge_doublewords()) all.push_back(repeated<8>(value));
    all.push_back(build<1>([](int i) { return i; }));
    all.push_back(build<1>([](int i) { return 0xf8 + i; }));
    all.push_back(build<1>([](int i) { return i * 0x11; }));
    return all;
  }();
  return registers;
}

// Values at the limits of counts and of integer types; narrower types take their low bits.
const std::vector<std::uint64_t>& edge_scalars() {
  static const std::vector<std::uint64_t> values = [] {
    std::vector<std::uint64_t> all;
    for (std::uint64_t n = 0; n <= 33; ++n) {
      all.push_back(n);
      all.push_back(0 - n);
    }
    for (const std::uint64_t n : {63, 64, 65, 95, 127, 128, 129, 255, 256}) {
      all.push_back(n);
      all.push_back(0 - n);
    }
    for (const std::uint64_t n :
         {0x7fffULL, 0x8000ULL, 0xffffULL, 0x7fffffffULL, 0x80000000ULL, 0xffffffffULL})
      all.push_back(n);
    return all;
  }();
  return values;
}

// Half of them uniform bits, the others made of lanes picked from the edges.
Register random_register(std::mt19937_64& random) {
  const auto word = [&](int) { return pick(edge_words(), random); };
  const auto doubleword = [&](int) { return pick(edge_doublewords(), random); };
  switch (random() % 8) {
    case 0:
      return build<4>(word);
    case 1:
      return build<8>(doubleword);
    case 2:
      return build<4>([&](int) { return pick(edge_words(), random) + random() % 3 - 1; });
    case 3:
      return build<1>([&](int) { return random() % 64; });
    default:
      return build<8>([&](int) { return random(); });
  }
}

#ifdef SPU_EMU_RANDOM_INPUTS
constexpr int random_inputs = SPU_EMU_RANDOM_INPUTS;
#else
constexpr int random_inputs = 10000;
#endif

std::string text(const Value& v) {
  return v.is_scalar ? std::to_string(static_cast<std::int64_t>(v.scalar)) : reference::text(v.image);
}

Value edge_value(bool scalar, std::size_t index) {
  if (scalar) return {true, edge_scalars()[index], {}};
  return {false, 0, edge_registers()[index]};
}

// Small numbers half of the time: most counts and element numbers are.
Value random_value(bool scalar, std::mt19937_64& random) {
  if (!scalar) return {false, 0, random_register(random)};
  const std::uint64_t b = random();
  return {true, (b & 1) != 0 ? random() : (b >> 8) % 300, {}};
}

bool agrees(const char* name, const std::vector<Value>& arguments, Function intrinsic, Function ref,
            Agreement agree) {
  const Value result = intrinsic(arguments.data());
  const Value expected = ref(arguments.data());
  if (agree(result, expected, arguments.data())) return true;
  std::string inputs;
  for (const Value& v : arguments) inputs += "\n  input    " + text(v);
  ADD_FAILURE() << name << inputs << "\n  result   " << text(result) << "\n  expected " << text(expected);
  return false;
}

}  // namespace

bool operator==(const Value& a, const Value& b) {
  return a.is_scalar == b.is_scalar && a.scalar == b.scalar && a.image == b.image;
}

bool same_bits(const Value& result, const Value& expected, const Value*) {
  return result == expected;
}

void run_check(const char* name, std::initializer_list<bool> scalar_list, Function intrinsic, Function ref,
               Agreement agree) {
  const std::vector<bool> scalar_arguments(scalar_list);
  std::vector<Value> arguments(scalar_arguments.size());
  const auto size = [](bool scalar) { return scalar ? edge_scalars().size() : edge_registers().size(); };
  std::size_t combinations = 1;
  for (const bool scalar : scalar_arguments) combinations *= size(scalar);
  // Three operands have too many combinations: every 17th of them, which still meets every pair.
  const std::size_t step = combinations > 10000 ? 17 : 1;
  for (std::size_t n = 0; n < combinations; n += step) {
    std::size_t rest = n;
    for (std::size_t k = 0; k < arguments.size(); ++k) {
      arguments[k] = edge_value(scalar_arguments[k], rest % size(scalar_arguments[k]));
      rest /= size(scalar_arguments[k]);
    }
    if (!agrees(name, arguments, intrinsic, ref, agree)) return;
  }
  std::mt19937_64 random(20080514);
  for (int n = 0; n < random_inputs; ++n) {
    for (std::size_t k = 0; k < arguments.size(); ++k)
      arguments[k] = random_value(scalar_arguments[k], random);
    if (!agrees(name, arguments, intrinsic, ref, agree)) return;
  }
}

}  // namespace reference
