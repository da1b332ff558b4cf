#include "libspe2/word_access.h"

#include <ucontext.h>

#include <array>
#include <cstring>
#include <type_traits>

namespace spu_emu {

#if defined(__x86_64__)

namespace {
constexpr std::array<int, 16> kRegisters = {REG_RAX, REG_RCX, REG_RDX, REG_RBX, REG_RSP, REG_RBP,
                                            REG_RSI, REG_RDI, REG_R8,  REG_R9,  REG_R10, REG_R11,
                                            REG_R12, REG_R13, REG_R14, REG_R15};

/// Bytes of the operand that follows an opcode: ModRM, SIB and displacement.
unsigned operand_size(const unsigned char* modrm) {
  const unsigned mode = *modrm >> 6U;
  const unsigned base = *modrm & 7U;
  const bool has_sib = base == 4;
  const bool has_no_base = mode == 0 && (base == 5 || (has_sib && (modrm[1] & 7U) == 5));
  const unsigned displacement = mode == 1 ? 1 : mode == 2 || has_no_base ? 4 : 0;
  return 1 + (has_sib ? 1 : 0) + displacement;
}
}  // namespace

/// mov between memory and a register of 32 bits, and mov of a constant to memory.
std::optional<WordAccess> word_access_of(const void* context) {
  const auto& registers = static_cast<const ucontext_t*>(context)->uc_mcontext.gregs;
  const auto* code = reinterpret_cast<const unsigned char*>(registers[REG_RIP]);
  const unsigned prefix = (*code & 0xf8U) == 0x40 ? *code & 7U : 0;
  const unsigned prefix_size = (*code & 0xf8U) == 0x40 ? 1 : 0;
  code += prefix_size;
  WordAccess access;
  access.target = (code[1] >> 3U & 7U) | (prefix & 4U) << 1U;
  access.size = prefix_size + 1 + operand_size(code + 1);
  if (*code == 0x8b) return access;
  access.is_store = true;
  if (*code == 0x89) {
    access.value = static_cast<std::uint32_t>(registers[kRegisters[access.target]]);
    return access;
  }
  if (*code != 0xc7 || (code[1] >> 3U & 7U) != 0) return std::nullopt;
  std::memcpy(&access.value, code + access.size - prefix_size, sizeof access.value);
  access.size += sizeof access.value;
  return access;
}

void finish_access(void* context, const WordAccess& access, std::uint32_t value) {
  auto& registers = static_cast<ucontext_t*>(context)->uc_mcontext.gregs;
  if (!access.is_store) registers[kRegisters[access.target]] = value;
  registers[REG_RIP] += access.size;
}

#elif defined(__powerpc__)

namespace {
constexpr unsigned kNextInstruction = 32;

auto* registers_of(const void* context) {
  auto* all = const_cast<ucontext_t*>(static_cast<const ucontext_t*>(context));
#ifdef __powerpc64__
  return all->uc_mcontext.gp_regs;
#else
  return all->uc_mcontext.uc_regs->gregs;
#endif
}

struct Instruction {
  std::uint32_t code;
  std::uint32_t mask;
  bool is_store;
  bool is_signed;
};

/// lwz, stw, lwzx, stwx, lwa and lwax.
constexpr std::array<Instruction, 6> kInstructions = {{{32U << 26U, 63U << 26U, false, false},
                                                       {36U << 26U, 63U << 26U, true, false},
                                                       {31U << 26U | 23U << 1U, 0xfc0007feU, false, false},
                                                       {31U << 26U | 151U << 1U, 0xfc0007feU, true, false},
                                                       {58U << 26U | 2U, 0xfc000003U, false, true},
                                                       {31U << 26U | 341U << 1U, 0xfc0007feU, false, true}}};
}  // namespace

std::optional<WordAccess> word_access_of(const void* context) {
  const auto* registers = registers_of(context);
  const std::uint32_t word = *reinterpret_cast<const std::uint32_t*>(registers[kNextInstruction]);
  for (const Instruction& known : kInstructions) {
    if ((word & known.mask) != known.code) continue;
    WordAccess access;
    access.target = word >> 21U & 31U;
    access.is_store = known.is_store;
    access.is_signed = known.is_signed;
    access.value = static_cast<std::uint32_t>(registers[access.target]);
    return access;
  }
  return std::nullopt;
}

void finish_access(void* context, const WordAccess& access, std::uint32_t value) {
  auto* registers = registers_of(context);
  using Register = std::remove_reference_t<decltype(registers[0])>;
  const auto sign = static_cast<std::int32_t>(value);
  if (!access.is_store) {
    registers[access.target] = access.is_signed ? static_cast<Register>(sign) : static_cast<Register>(value);
  }
  registers[kNextInstruction] += access.size;
}

#else

std::optional<WordAccess> word_access_of(const void*) {
  return std::nullopt;
}

void finish_access(void*, const WordAccess&, std::uint32_t) {}

#endif

}  // namespace spu_emu
