// Programs of random instructions: whatever they do, in steps and at once they do the same.
#include <random>
#include <vector>

#include "isa/encoding/opcodes.h"
#include "machine_properties.h"
#include "test_machine.h"

namespace spu_emu::isa {
namespace {

using Random = std::mt19937;

/// Any instruction with few registers; branches stay near, and stops are rare.
std::uint32_t random_instruction(Random& random) {
  const Instruction& instruction = instructions()[random() % instructions().size()];
  std::uint32_t word = std::uint32_t{instruction.opcode} << 21U;
  word |= static_cast<std::uint32_t>(random()) & (0xffffffffU >> opcode_bits(instruction.format));
  if (instruction.format == Format::ri16 && instruction.unit == Unit::br) {
    const auto distance = static_cast<std::int32_t>(random() % 64) - 32;
    word = (word & 0xff80007fU) | ((static_cast<std::uint32_t>(distance) & 0xffffU) << 7U);
  }
  return instruction.unit == Unit::br && instruction.format == Format::rr && random() % 8 != 0
             ? encode("ai", {static_cast<std::int32_t>(random() % 128), 3, 1})
             : word;
}

std::vector<std::byte> random_program(Random& random) {
  std::vector<std::byte> bytes;
  for (int k = 0; k < 100; ++k) {
    const std::uint32_t word =
        random() % 50 == 0 ? static_cast<std::uint32_t>(random()) : random_instruction(random);
    for (const unsigned shift : {24U, 16U, 8U, 0U}) bytes.push_back(static_cast<std::byte>(word >> shift));
  }
  return bytes;
}

TEST(RandomPrograms, DoTheSameInStepsAndAtOnce) {
  Random random(1);
  for (std::uint32_t seed = 0; seed < 500; ++seed) {
    const std::vector<std::byte> program = random_program(random);
    ASSERT_EQ(check_program(program, seed), "") << "seed " << seed;
  }
}

TEST(RandomPrograms, OfAnyBytesEnd) {
  Random random(2);
  std::vector<std::byte> bytes(400);
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    for (std::byte& byte : bytes) byte = static_cast<std::byte>(random());
    ASSERT_EQ(check_program(bytes, seed), "") << "seed " << seed;
  }
}

}  // namespace
}  // namespace spu_emu::isa
