/// @file
/// The host's floating-point mode for as long as code of the host runs in the middle of a run.
#ifndef SPU_EMU_ISA_CORE_HOST_FLOAT_MODE_H
#define SPU_EMU_ISA_CORE_HOST_FLOAT_MODE_H

#include "isa/core/state.h"

namespace spu_emu::isa {

class HostFloatMode {
 public:
  explicit HostFloatMode(const State& state) : spu_(float_control()) {
    set_float_control(state.host_float_control);
  }
  ~HostFloatMode() { set_float_control(spu_); }
  HostFloatMode(const HostFloatMode&) = delete;
  HostFloatMode& operator=(const HostFloatMode&) = delete;

 private:
  FloatControl spu_;
};

}  // namespace spu_emu::isa

#endif
