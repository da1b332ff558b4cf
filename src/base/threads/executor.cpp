#include "cellsweep/executor.h"

namespace cellsweep {

Executor::~Executor() = default;

}  // namespace cellsweep
