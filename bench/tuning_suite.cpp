#include "bench/tuning_suite.h"

#include "bench/tuning/rows.h"

namespace cellsweep::bench {

void register_tuning_suite() {
  register_cost_rows();
  register_sweep_rows();
  register_candidate_rows();
  register_fat_box_rows();
  register_grid_rows();
}

}  // namespace cellsweep::bench
