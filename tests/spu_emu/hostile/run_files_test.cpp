// The command spu-run and spe_image_open on files whose headers lie: an end with a sentence, never with a
// signal.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <libspe2.h>
#include <spawn.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <iterator>

#include "../isa/elf/elf_builder.h"
#include "lies.h"

extern char** environ;

namespace spu_emu {
namespace {

constexpr int kFirstOwnCode = 124;

struct Outcome {
  int status = -1;
  std::string errors;
};

std::string text_of(const std::string& name) {
  std::ifstream file(name);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A file of its own name, and a place for what a run of it says.
class Workplace {
 public:
  Workplace() { EXPECT_NE(mkdtemp(folder_.data()), nullptr); }
  ~Workplace() {
    unlink(program().c_str());
    unlink(errors().c_str());
    rmdir(folder_.c_str());
  }
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;

  std::string program() const { return folder_ + "/program.elf"; }

  void write_program(const FileBytes& file) const {
    std::ofstream stream(program(), std::ios::binary);
    stream.write(reinterpret_cast<const char*>(file.data()), static_cast<std::streamsize>(file.size()));
    stream.close();
    ASSERT_EQ(chmod(program().c_str(), 0755), 0);
  }

  Outcome run(const char* program_name) const { return run("--max-instructions", "100", program_name); }

  Outcome run(const char* option, const char* value, const char* program_name) const {
    std::array<const char*, 6> arguments{SPU_EMU_RUN, "--no-files", option, value, program_name, nullptr};
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, errors().c_str(), O_CREAT | O_WRONLY | O_TRUNC,
                                     0600);
    pid_t child = 0;
    Outcome outcome;
    if (posix_spawn(&child, SPU_EMU_RUN, &actions, nullptr, const_cast<char**>(arguments.data()), environ) ==
        0) {
      waitpid(child, &outcome.status, 0);
    }
    posix_spawn_file_actions_destroy(&actions);
    outcome.errors = text_of(errors());
    return outcome;
  }

 private:
  std::string errors() const { return folder_ + "/errors.txt"; }
  std::string folder_ = testing::TempDir() + "spu_emu_hostile_XXXXXX";
};

void expect_sentence(const Outcome& outcome) {
  ASSERT_TRUE(WIFEXITED(outcome.status)) << "signal " << WTERMSIG(outcome.status) << "\n" << outcome.errors;
  if (WEXITSTATUS(outcome.status) < kFirstOwnCode) return;
  EXPECT_EQ(outcome.errors.substr(0, 9), "spu-run: ") << outcome.errors;
  EXPECT_GT(outcome.errors.find('\n'), 20U) << outcome.errors;
}

/// Opens a file of the workplace as a program that uses libspe2 does; what opens is closed.
void expect_opened_or_refused(const Workplace& place) {
  spe_program_handle_t* image = spe_image_open(place.program().c_str());
  if (image == nullptr) {
    EXPECT_EQ(errno, EINVAL);
    return;
  }
  EXPECT_EQ(spe_image_close(image), 0);
}

TEST(LyingFileCommand, ends_with_a_sentence_for_every_lie_about_a_size_or_an_offset) {
  const Workplace place;
  int files = 0;
  for (const FileBytes& file : small_spu_programs()) {
    const auto try_some = [&](const FileBytes& lying, const std::string& what) {
      place.write_program(lying);
      expect_opened_or_refused(place);
      // A process takes its time; every 17th file still meets each field.
      if (files++ % 17 != 0) return;
      SCOPED_TRACE(what);
      expect_sentence(place.run(place.program().c_str()));
    };
    for_each_lie(file, fields_of_spu_elf(file), true, try_some);
    for_each_cut(file, 16, try_some);
  }
  EXPECT_GT(files, 1000);
}

TEST(LyingFileCommand, runs_a_file_as_it_should_be) {
  const Workplace place;
  place.write_program(small_spu_programs().front());
  const Outcome outcome = place.run(place.program().c_str());
  ASSERT_TRUE(WIFEXITED(outcome.status));
  EXPECT_EQ(WEXITSTATUS(outcome.status), 0x17) << outcome.errors;
}

TEST(LyingFileCommand, ends_a_loop_at_the_timeout_with_a_sentence) {
  constexpr std::uint32_t kBranchToItself = 0x32000000;
  const Workplace place;
  place.write_program(isa::ElfBuilder(0, {{0, {kBranchToItself}}}).build());
  const Outcome outcome = place.run("--timeout", "0.05", place.program().c_str());
  expect_sentence(outcome);
  EXPECT_EQ(WEXITSTATUS(outcome.status), 125);
  EXPECT_NE(outcome.errors.find("has run for 50 ms and has not ended"), std::string::npos) << outcome.errors;
  const Outcome refused = place.run("--timeout", "-1", place.program().c_str());
  EXPECT_EQ(WEXITSTATUS(refused.status), 124) << refused.errors;
}

TEST(LyingFileCommand, reads_a_device_without_an_end_no_further_than_a_program_can_be_long) {
  const Workplace place;
  const Outcome outcome = place.run("/dev/zero");
  expect_sentence(outcome);
  EXPECT_NE(outcome.errors.find("at most"), std::string::npos) << outcome.errors;
}

TEST(LyingFileCommand, an_image_is_closed_once_and_only_if_it_was_opened) {
  const Workplace place;
  place.write_program(small_spu_programs().front());
  spe_program_handle_t* image = spe_image_open(place.program().c_str());
  ASSERT_NE(image, nullptr);
  spe_program_handle_t other = *image;
  EXPECT_EQ(spe_image_close(&other), -1);
  EXPECT_EQ(errno, EINVAL);
  EXPECT_EQ(spe_image_close(image), 0);
  EXPECT_EQ(spe_image_close(image), -1);
}

TEST(LyingFileCommand, a_file_that_is_cut_while_it_is_open_loads_as_it_was) {
  const Workplace place;
  place.write_program(small_spu_programs().front());
  spe_program_handle_t* image = spe_image_open(place.program().c_str());
  ASSERT_NE(image, nullptr);
  ASSERT_EQ(truncate(place.program().c_str(), 0), 0);
  const spe_context_ptr_t spe = spe_context_create(SPE_EVENTS_ENABLE, nullptr);
  EXPECT_EQ(spe_program_load(spe, image), 0);
  EXPECT_EQ(spe_context_destroy(spe), 0);
  EXPECT_EQ(spe_image_close(image), 0);
}

}  // namespace
}  // namespace spu_emu
