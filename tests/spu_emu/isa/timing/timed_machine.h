// A machine whose cycles are counted.
#ifndef SPU_EMU_TESTS_ISA_TIMED_MACHINE_H
#define SPU_EMU_TESTS_ISA_TIMED_MACHINE_H

#include <initializer_list>

#include "../core/test_machine.h"
#include "isa/timing/cycle_model.h"

namespace spu_emu::isa {

class TimedMachine : public TestMachine {
 public:
  explicit TimedMachine(const CycleParameters& parameters = {}) : model(parameters, local->bytes.data()) {
    machine.set_observer(model);
  }

  /// Runs a program from address 0 to its stop, and counts its cycles, the stop's among them.
  CycleCounts count(std::initializer_list<std::uint32_t> words) {
    program(words);
    run_to_stop();
    return model.profile().total;
  }

  CycleModel model;
};

/// The counts of a program on a machine of its own.
inline CycleCounts count_cycles(std::initializer_list<std::uint32_t> words,
                                const CycleParameters& parameters = {}) {
  TimedMachine spu(parameters);
  return spu.count(words);
}

}  // namespace spu_emu::isa

#endif
