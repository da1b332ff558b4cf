/// @file
/// The `cellsweep` command.
#include "app/program.h"
#include "report/all_engines.h"

int main(int argc, char** argv) {
  cellsweep::report::add_all_engines();
  return cellsweep::app::run_program(argc, argv);
}
