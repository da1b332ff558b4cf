#include "app/process.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <initializer_list>
#include <memory>
#include <new>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "app/exit_code.h"

namespace cellsweep::app {
namespace {

constexpr std::string_view kOutOfMemory =
    "cellsweep: The system gives no more memory or threads. Fewer bodies, frames, threads or engines at a "
    "time "
    "take less.\n";

// Read or written, it fails as the closed stream would.
void keep_place_of(int stream) {
  if (::fcntl(stream, F_GETFD) >= 0 || errno != EBADF) return;
  const int flags = stream == STDIN_FILENO ? O_WRONLY : O_RDONLY;
  static_cast<void>(::open("/dev/null", flags));  // takes the lowest number that is free
}

// Whether it is for want of memory that an exception found nobody to catch it. Without memory for the
// exception itself there is none.
bool is_without_memory() {
  try {
    if (const std::exception_ptr exception = std::current_exception()) std::rethrow_exception(exception);
    const std::unique_ptr<char, void (*)(void*)> some(static_cast<char*>(std::malloc(1024)), std::free);
    return some == nullptr;
  } catch (const std::exception& error) {
    return is_want_of_memory(error);
  } catch (...) {
    return false;
  }
}

[[noreturn]] void end_of_an_exception() {
  if (is_without_memory()) end_without_memory();
  std::abort();
}

// Libraries ask for memory before main() begins: what is in this section is called before the first of them.
// Not sanitized, for the sanitizers begin no earlier.
__attribute__((no_sanitize("address", "thread", "undefined"))) void prepare_for_want_of_memory() {
  std::set_new_handler(end_without_memory);
  std::set_terminate(end_of_an_exception);
}
[[gnu::section(".preinit_array"), gnu::used]] void (*const kFirstCall)() = prepare_for_want_of_memory;

}  // namespace

void prepare_process() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) keep_place_of(stream);
  for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_IGN);
}

void end_without_memory() {
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, kOutOfMemory.data(), kOutOfMemory.size());
  ::_exit(kNoMemory);
}

bool is_want_of_memory(const std::exception& error) {
  const auto* system = dynamic_cast<const std::system_error*>(&error);
  if (system != nullptr) {
    return system->code() == std::errc::resource_unavailable_try_again ||
           system->code() == std::errc::not_enough_memory;
  }
  // A length above all that there may be is more than any memory has.
  return dynamic_cast<const std::bad_alloc*>(&error) != nullptr ||
         dynamic_cast<const std::length_error*>(&error) != nullptr;
}

}  // namespace cellsweep::app
