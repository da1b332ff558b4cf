#include "cellsweep/engine/engine.h"

namespace cellsweep {

Engine::~Engine() = default;

}  // namespace cellsweep
