#include <cstdint>

int main(std::uint64_t speid, std::uint64_t argp) {
  return speid != 0 ? static_cast<int>(argp) : 1;
}
