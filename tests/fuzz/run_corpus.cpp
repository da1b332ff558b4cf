/// @file
/// Runs a fuzz target without a fuzzer: every file of a folder, every truncation and every flipped bit of the
/// small ones.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t kSmall = 2048;

/// Inputs are copied to memory of their exact size, so that a sanitizer sees a read past the end.
void run(const std::uint8_t* data, std::size_t size) {
  const Bytes exact(data, data + size);
  LLVMFuzzerTestOneInput(exact.data(), exact.size());
}

void run_truncations(const Bytes& file) {
  for (std::size_t size = 0; size < file.size(); ++size) run(file.data(), size);
}

void run_bit_flips(Bytes file) {
  for (std::size_t bit = 0; bit < 8 * file.size(); ++bit) {
    const auto mask = static_cast<std::uint8_t>(1U << (bit % 8));
    file[bit / 8] ^= mask;
    run(file.data(), file.size());
    file[bit / 8] ^= mask;
  }
}

Bytes read(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s CORPUS_FOLDER\n", argv[0]);
    return 2;
  }
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(argv[1])) paths.push_back(entry.path());
  std::ranges::sort(paths);
  for (const auto& path : paths) {
    // The last name on the screen is the file that broke a property.
    std::printf("%s\n", path.filename().string().c_str());
    std::fflush(stdout);
    const Bytes file = read(path);
    run(file.data(), file.size());
    if (file.size() > kSmall) continue;
    run_truncations(file);
    run_bit_flips(file);
  }
  std::printf("%zu files\n", paths.size());
  return paths.empty() ? 1 : 0;
}
