#include "report/build_context.h"

#include <sys/utsname.h>

#include <fstream>
#include <thread>

#include "commit.h"

namespace cellsweep::report {
namespace {

std::string cpu_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (!line.starts_with("model name") && !line.starts_with("cpu\t")) continue;
    return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

std::string system_name() {
  utsname name{};
  if (uname(&name) != 0) return "unknown";
  return std::string(name.sysname) + " " + name.release + " " + name.machine;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> build_context() {
  return {{"cpu", cpu_name()},        {"cores", std::to_string(std::thread::hardware_concurrency())},
          {"system", system_name()},  {"compiler", CELLSWEEP_COMPILER},
          {"flags", CELLSWEEP_FLAGS}, {"commit", CELLSWEEP_COMMIT}};
}

std::string version_text() {
  return "cellsweep " CELLSWEEP_VERSION ", commit " CELLSWEEP_COMMIT;
}

}  // namespace cellsweep::report
