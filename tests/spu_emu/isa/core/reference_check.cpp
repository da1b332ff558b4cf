#include "reference_check.h"

#include <random>
#include <vector>

#include "isa/encoding/opcodes.h"

namespace spu_emu::isa {

namespace {

constexpr int kA = 10;
constexpr int kB = 11;
constexpr int kT = 12;
constexpr int kC = 13;
constexpr int kRounding = 14;
constexpr int kRandomCases = 400;

constexpr std::uint32_t kEdges[] = {0,          1,          0x7fffff,   0x800000,   0x800001,   0x3f800000,
                                    0x3fffffff, 0x40000000, 0x4b000000, 0x4effffff, 0x4f000000, 0x7e800000,
                                    0x7f7fffff, 0x7f800000, 0x7f800001, 0x7fc00000, 0x7fffffff, 0x00100000,
                                    0x000fffff, 0x7ff00000, 0x7ff40000, 0x7ff80000, 0x7fe00000, 0x3ff00000,
                                    0xffff,     0x8000,     0x7effffff, 0x7f000000, 0x3effffff, 0x7fff,
                                    0x80808080, 0x7f7f7f7f, 0x010203ff};

using Random = std::mt19937;

std::uint32_t random_word(Random& random) {
  const auto bits = static_cast<std::uint32_t>(random());
  switch (random() % 4) {
    case 0:
      return kEdges[bits % std::size(kEdges)] | (random() % 2 != 0 ? 0x80000000U : 0U);
    case 1:
      return (kEdges[bits % std::size(kEdges)] + static_cast<std::uint32_t>(random() % 3) - 1);
    case 2:
      return 0x3f000000U + (bits & 0x81ffffffU);  // Floats around 1, of both signs.
    default:
      return bits;
  }
}

Words random_words(Random& random) {
  Words words{};
  for (std::uint32_t& word : words) word = random_word(random);
  if (random() % 4 == 0) words[3] = words[2] = words[1] = words[0];
  if (random() % 4 == 0) words[1] = words[3] = 0;
  return words;
}

Register image_of(const Words& words) {
  return reference::build<4>([&](int i) { return words[static_cast<std::size_t>(i)]; });
}

/// The range of an operand's letter.
std::int32_t random_operand(char letter, Random& random) {
  const auto pick = [&](std::int32_t least, std::int32_t most) {
    return std::uniform_int_distribution<std::int32_t>(least, most)(random);
  };
  switch (letter) {
    case 'a':
      return kA;
    case 'b':
      return kB;
    case 't':
      return kT;
    case 'c':
      return kC;
    case '7':
      return pick(-64, 63);
    case 'i':
      return pick(-512, 511);
    case 'I':
      return pick(-0x8000, 0x7fff);
    case 'u':
      return pick(0, 0xffff);
    case 'U':
      return pick(0, 0x3ffff);
    case 'F':
    case 'G':
      return pick(0, 127);
    default:
      throw std::invalid_argument("no random operands for this instruction");
  }
}

bool is_register(char letter) {
  return letter == 'a' || letter == 'b' || letter == 't' || letter == 'c';
}

std::string text_of(const Operands& o) {
  return "a " + reference::text(o.a) + "  b " + reference::text(o.b) + "  t " + reference::text(o.t) +
         "  immediate " + std::to_string(o.immediate);
}

/// An instruction with random operands for its letters; the immediate goes to `immediate`.
std::uint32_t random_instruction(const Instruction& instruction, Random& random, std::int32_t& immediate) {
  std::vector<std::int32_t> values;
  for (const char letter : std::string_view(instruction.operands)) {
    if (letter == ',' || letter == '(' || letter == ')') continue;
    values.push_back(random_operand(letter, random));
    if (!is_register(letter)) immediate = values.back();
  }
  return encode(instruction.mnemonic, values);
}

}  // namespace

void ReferenceCheck::check(const char* mnemonic, const Reference& expected, bool compare_fpscr) {
  const int number = find_instruction(std::string_view(mnemonic));
  ASSERT_GE(number, 0) << mnemonic;
  const Instruction& instruction = instructions()[static_cast<std::size_t>(number)];
  Random random(static_cast<std::uint32_t>(number) + 1);
  const unsigned target = instruction.format == Format::rrr ? kC : kT;
  for (int k = 0; k < kRandomCases; ++k) {
    Operands o;
    const Words a = random_words(random);
    const Words b = random_words(random);
    const Words t = random_words(random);
    spu_.program({encode("fscrwr", {0, kRounding}), random_instruction(instruction, random, o.immediate),
                  encode("fscrrd", {kRounding}), kStop});
    spu_.set(kA, a);
    spu_.set(kB, b);
    spu_.set(kT, t);
    spu_.set(kRounding, {rounding_, 0, 0, 0});
    spu_.run_to_stop();
    o.a = image_of(a);
    o.b = image_of(b);
    o.t = image_of(t);
    const Register result = image_of(spu_.reg(compare_fpscr ? kRounding : target));
    const Register wanted = expected(o);
    ASSERT_EQ(result, wanted) << mnemonic << ' ' << text_of(o) << "\n  result   " << reference::text(result)
                              << "\n  expected " << reference::text(wanted);
  }
}

}  // namespace spu_emu::isa
