// Compiles a source of an SPU program for this machine: a launcher before the compiler's own command line.
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>

#include "compile/align_data.h"
#include "compile/command_line.h"

namespace {

using spu_emu::compile::CommandLine;
using spu_emu::compile::Words;

constexpr const char* kHelp =
    "usage: spu-emu-compile COMPILER OPTION... -o OBJECT -c SOURCE\n"
    "\n"
    "Compiles one C or C++ source of an SPU program for this machine, as the SPU's\n"
    "compiler would understand it: `vector` is a keyword before built-in types only,\n"
    "casts between vectors move bytes as on the SPU, main may have any parameters,\n"
    "and every variable in memory lies at a multiple of 16 bytes.\n"
    "add_spu_program of the CMake package puts this before each compiler command.\n"
    "\n"
    "  spu-emu-compile g++ -O2 -msse4.1 -D__SPU__=1 -o kernel.o -c kernel.cpp\n"
    "  spu-emu-compile gcc -O2 -msse4.1 -std=gnu89 -o old.o -c old.c\n";

/// A file that goes with the object that is made.
class Scratch {
 public:
  explicit Scratch(std::string path) : path_(std::move(path)) {}
  ~Scratch() { unlink(path_.c_str()); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// The command's exit code; 127 with a message if it cannot be run.
int run(const Words& words) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  pid_t child = 0;
  const int error = posix_spawnp(&child, arguments[0], nullptr, nullptr, arguments.data(), environ);
  if (error != 0) {
    std::fprintf(stderr, "spu-emu-compile: cannot run %s: %s\n", arguments[0], std::strerror(error));
    return 127;
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

/// Changes the file's text in its place.
template <class Change>
bool rewrite(const std::string& path, Change change) {
  std::ifstream in(path, std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  std::ofstream out(path, std::ios::binary | std::ios::trunc);
  out << change(text);
  out.close();
  if (in && out) return true;
  std::fprintf(stderr, "spu-emu-compile: cannot write %s: is there room?\n", path.c_str());
  return false;
}

int compile(const CommandLine& line) {
  const bool is_c = line.language() == spu_emu::compile::Language::c;
  const Scratch text(line.object() + (is_c ? ".spu.i" : ".spu.ii"));
  const Scratch assembly(line.object() + ".spu.s");
  if (const int code = run(line.preprocess(text.path())); code != 0) return code;
  bool has_macros = false;
  const auto translated = [&](const std::string& source) {
    has_macros = is_c && source.find("spu_emu_c_intrinsics_are_declared") != std::string::npos;
    return spu_emu::compile::translate(source, line.language());
  };
  if (!rewrite(text.path(), translated)) return 1;
  if (const int code = run(line.to_assembly(text.path(), assembly.path(), has_macros)); code != 0)
    return code;
  if (!rewrite(assembly.path(), spu_emu::compile::align_data)) return 1;
  return run(line.assemble(assembly.path()));
}

}  // namespace

int main(int argc, char** argv) {
  const Words words(argv + 1, argv + argc);
  if (words.empty() || words[0] == "--help" || words[0] == "-h") {
    std::fputs(kHelp, words.empty() ? stderr : stdout);
    return words.empty() ? 2 : 0;
  }
  const auto line = CommandLine::of(words);
  // What compiles nothing, a question of CMake about the compiler for one, is the compiler's own affair.
  return line ? compile(*line) : run(words);
}
