#include "differential/programs.h"

#include <ostream>
#include <string_view>

namespace differential {

// Generated from the list of the SDK's names.
Program program_generic_1();
Program program_generic_2();
Program program_specific();
Program program_vmx_1();
Program program_vmx_2();
Program program_vmx_3();

bool Program::is_single_precision(std::size_t row) const {
  const std::string_view call = calls[row];
  constexpr std::string_view kSpecific[] = {"si_f", "si_cflt", "si_csflt", "si_cuflt"};
  for (const std::string_view prefix : kSpecific) {
    if (call.substr(0, prefix.size()) == prefix) return true;
  }
  return call.find("float") != std::string_view::npos;
}

void PrintTo(const Program& program, std::ostream* out) {
  *out << program.name;
}

std::vector<Program> programs() {
  return {program_generic_1(), program_generic_2(), program_specific(),
          program_vmx_1(),     program_vmx_2(),     program_vmx_3()};
}

}  // namespace differential
