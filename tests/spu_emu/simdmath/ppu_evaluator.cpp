#include "simdmath/ppu_evaluator.h"

#include <unistd.h>

#include <bit>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <stdexcept>

namespace simdmath_test {

namespace {

std::uint32_t big_endian(std::uint32_t word) {
  return std::endian::native == std::endian::big ? word : __builtin_bswap32(word);
}

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

/// A file in the folder for temporary ones, gone with this object.
class TemporaryFile {
 public:
  TemporaryFile() {
    const int file = mkstemp(name_.data());
    if (file < 0) throw std::runtime_error("no temporary file can be made: " + name_);
    close(file);
  }
  ~TemporaryFile() { std::remove(name_.c_str()); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  std::string name_ = testing_folder() + "/simdmath.XXXXXX";

  static std::string testing_folder() {
    const char* folder = std::getenv("TMPDIR");
    return folder != nullptr ? folder : "/tmp";
  }
};

void write_request(const std::string& name, unsigned function, const std::vector<Call>& calls) {
  const File file(std::fopen(name.c_str(), "wb"));
  std::vector<std::uint32_t> words = {function, static_cast<std::uint32_t>(calls.size())};
  for (const Call& call : calls) {
    for (const Words& argument : call) words.insert(words.end(), argument.begin(), argument.end());
  }
  for (std::uint32_t& word : words) word = big_endian(word);
  if (!file || std::fwrite(words.data(), 4, words.size(), file.get()) != words.size()) {
    throw std::runtime_error("cannot write " + name);
  }
}

std::vector<Result> read_results(const std::string& name, std::size_t count) {
  const File file(std::fopen(name.c_str(), "rb"));
  std::vector<Result> results(count);
  if (!file || std::fread(results.data(), sizeof(Result), count, file.get()) != count) {
    throw std::runtime_error("the program for the PPU gave fewer results than it was asked for");
  }
  for (Result& result : results) {
    for (Words& words : result) {
      for (std::uint32_t& word : words) word = big_endian(word);
    }
  }
  return results;
}

}  // namespace

std::vector<Result> evaluate_on_ppu(const std::string& command, unsigned function, const std::vector<Call>& calls) {
  const TemporaryFile request;
  const TemporaryFile answer;
  write_request(request.name(), function, calls);
  const std::string line = command + " < " + request.name() + " > " + answer.name();
  if (std::system(line.c_str()) != 0) throw std::runtime_error("failed: " + line);
  return read_results(answer.name(), calls.size());
}

}  // namespace simdmath_test
