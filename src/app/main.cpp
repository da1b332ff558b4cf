/// @file
/// The `cellsweep` command.
#include "app/process.h"
#include "app/program.h"
#include "report/all_engines.h"

int main(int argc, char** argv) {
  cellsweep::app::prepare_process();
  cellsweep::report::add_all_engines();
  return cellsweep::app::run_program(argc, argv);
}
