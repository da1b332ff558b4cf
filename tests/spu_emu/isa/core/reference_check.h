// Runs one instruction of the machine on edge values and seeded random operands, against a scalar reference.
#ifndef SPU_EMU_TESTS_ISA_CORE_REFERENCE_CHECK_H
#define SPU_EMU_TESTS_ISA_CORE_REFERENCE_CHECK_H

#include <cstdint>
#include <functional>
#include <string>

#include "../../intrinsics/operations.h"
#include "test_machine.h"

namespace spu_emu::isa {

using reference::Register;

/// What an instruction works on: the registers of fields a, b and t, and the immediate as the assembler takes
/// it.
struct Operands {
  Register a{};
  Register b{};
  Register t{};
  std::int32_t immediate = 0;
};

using Reference = std::function<Register(const Operands&)>;

class ReferenceCheck {
 public:
  /// Every run starts with this FPSCR word 0.
  explicit ReferenceCheck(std::uint32_t rounding = 0) : rounding_(rounding) {}

  /// Reports the first operands on which machine and reference differ. With `compare_fpscr` it is the
  /// FPSCR after the instruction that the reference gives.
  void check(const char* mnemonic, const Reference& expected, bool compare_fpscr = false);

 private:
  std::uint32_t rounding_;
  TestMachine spu_;
};

/// References for fields: of (a), (a, b), (a, b, t) and (a, immediate in all lanes).
template <class F>
Reference of_a(F f) {
  return [f](const Operands& o) { return f(o.a); };
}
template <class F>
Reference of_ab(F f) {
  return [f](const Operands& o) { return f(o.a, o.b); };
}
template <class F>
Reference of_abt(F f) {
  return [f](const Operands& o) { return f(o.a, o.b, o.t); };
}
template <int Width, class F>
Reference of_a_and_immediate(F f) {
  return [f](const Operands& o) {
    return f(o.a, reference::build<Width>([&](int) { return static_cast<reference::u64>(o.immediate); }));
  };
}

}  // namespace spu_emu::isa

#endif
