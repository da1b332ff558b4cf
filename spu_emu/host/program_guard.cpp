#include "host/program_guard.h"

#include <sys/syscall.h>
#include <time.h>
#include <ucontext.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "mfc/touch.h"

namespace spu_emu {

namespace {
/// The signals by which a program's code fails; the handlers that were there before.
constexpr std::array<int, 5> kSignals{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
std::array<struct sigaction, kSignals.size()> handlers_before;

/// The program that this thread runs. Of a kind that a signal handler may read, whatever library this is part
/// of.
[[gnu::tls_model("initial-exec")]] constinit thread_local ProgramGuard* running = nullptr;

std::chrono::steady_clock::time_point time_now() {
  return std::chrono::steady_clock::now();
}

/// In the place of the program's code, on its emptied stack and no longer in a signal handler.
[[noreturn]] void land(ProgramGuard* guard) {
  asm volatile("fninit\n\tcld");
  guard->ended(guard->program);
  __builtin_unreachable();
}

/// Makes the thread go on in land() when the handler returns.
void leave(ProgramGuard& guard, const Interruption& what, ucontext_t& context) {
  guard.what = what;
  guard.in_program.store(false, std::memory_order_relaxed);
  greg_t* const registers = context.uc_mcontext.gregs;
  const auto top = reinterpret_cast<std::uintptr_t>(guard.stack_top) & ~std::uintptr_t{15};
  registers[REG_RSP] = static_cast<greg_t>(top - sizeof(void*));  // As behind a call.
  registers[REG_RIP] = reinterpret_cast<greg_t>(&land);
  registers[REG_RDI] = reinterpret_cast<greg_t>(&guard);
}

std::uintptr_t instruction_of(const ucontext_t& context) {
  return static_cast<std::uintptr_t>(context.uc_mcontext.gregs[REG_RIP]);
}

/// True for what the program's own code did: an instruction, or its call of abort().
bool is_from_program(int signal, const siginfo_t& info) {
  if (signal == SIGABRT) return info.si_code == SI_TKILL && info.si_pid == getpid();
  return info.si_code > 0;
}

/// As if this file's handler were not there. An instruction that failed fails again when the handler returns.
void hand_on(int signal, siginfo_t* info, void* context) {
  std::size_t i = 0;
  while (kSignals[i] != signal) ++i;
  const struct sigaction& before = handlers_before[i];
  if ((before.sa_flags & SA_SIGINFO) != 0) return before.sa_sigaction(signal, info, context);
  const bool is_sent = info->si_code <= 0;
  if (before.sa_handler == SIG_IGN && is_sent) return;
  if (before.sa_handler != SIG_DFL && before.sa_handler != SIG_IGN) return before.sa_handler(signal);
  struct sigaction plain {};
  plain.sa_handler = SIG_DFL;
  sigaction(signal, &plain, nullptr);
  if (is_sent) raise(signal);
}
}  // namespace

/// The signal handlers.
struct GuardSignals {
  static void on_error(int signal, siginfo_t* info, void* context) {
    const int error = errno;
    auto& machine = *static_cast<ucontext_t*>(context);
    if (const std::uintptr_t next = touch_goes_on_at(instruction_of(machine)); next != 0) {
      machine.uc_mcontext.gregs[REG_RIP] = static_cast<greg_t>(next);
      return;
    }
    ProgramGuard* const guard = running;
    if (guard != nullptr && guard->contains_errors && guard->in_program.load(std::memory_order_relaxed) &&
        is_from_program(signal, *info)) {
      const auto address = reinterpret_cast<std::uintptr_t>(info->si_addr);
      leave(*guard, {signal, info->si_code, address, instruction_of(machine)}, machine);
    } else {
      hand_on(signal, info, context);
    }
    errno = error;
  }

  static void on_time(int, siginfo_t*, void* context) {
    using std::chrono_literals::operator""s;
    const int error = errno;
    auto& machine = *static_cast<ucontext_t*>(context);
    ProgramGuard* const guard = running;
    if (guard != nullptr && guard->in_program.load(std::memory_order_relaxed)) {
      const auto now = time_now();
      const bool is_own_code = guard->code.holds(instruction_of(machine));
      if (now >= guard->deadline_ && (is_own_code || now - guard->deadline_ > 2s)) {
        leave(*guard, {0, 0, 0, instruction_of(machine)}, machine);
      }
    }
    errno = error;
  }

  static struct sigaction action(void (*handler)(int, siginfo_t*, void*)) {
    struct sigaction wanted {};
    wanted.sa_sigaction = handler;
    wanted.sa_flags = SA_SIGINFO | SA_ONSTACK | SA_RESTART;
    sigemptyset(&wanted.sa_mask);
    return wanted;
  }

  GuardSignals() {
    const struct sigaction wanted = action(&on_error);
    for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &wanted, &handlers_before[i]);
    guard_touches(true);
  }

  /// A library that is unloaded must leave no handler behind; one that somebody put over it is his.
  ~GuardSignals() {
    guard_touches(false);
    for (std::size_t i = 0; i < kSignals.size(); ++i) {
      struct sigaction now {};
      const bool is_own = sigaction(kSignals[i], nullptr, &now) == 0 && now.sa_sigaction == &on_error;
      if (is_own) sigaction(kSignals[i], &handlers_before[i], nullptr);
    }
  }
  GuardSignals(const GuardSignals&) = delete;
  GuardSignals& operator=(const GuardSignals&) = delete;

  static void install() { static const GuardSignals installed; }

  /// The highest real-time signal that nobody handles, from now on the timers'; 0 if there is none.
  static int install_timer_signal() {
    for (int signal = SIGRTMAX; signal >= SIGRTMIN; --signal) {
      struct sigaction before {};
      if (sigaction(signal, nullptr, &before) != 0) continue;
      if (before.sa_handler != SIG_DFL && before.sa_handler != SIG_IGN) continue;
      const struct sigaction wanted = action(&on_time);
      if (sigaction(signal, &wanted, nullptr) == 0) return signal;
    }
    return 0;
  }

  static int timer_signal() {
    struct TimerSignal {
      int number = install_timer_signal();
      ~TimerSignal() {
        // Left to itself it would end the process, should a timer of a thread that still runs go off.
        if (number != 0) ::signal(number, SIG_IGN);
      }
    };
    static const TimerSignal timer;
    return timer.number;
  }
};

ProgramGuard::ProgramGuard(std::byte* stack_top_, Ended ended_, void* program_)
    : stack_top(stack_top_),
      ended(ended_),
      program(program_),
      signal_stack_(kGuardsPrograms ? new std::byte[kSignalStack] : nullptr) {}

GuardScope::GuardScope(ProgramGuard& guard, ProgramGuard::Time deadline) : outer_(running) {
  if (!kGuardsPrograms) return;
  GuardSignals::install();
  running = &guard;
  guard.deadline_ = deadline;
  stack_t stack{};
  stack.ss_sp = guard.signal_stack_.get();
  stack.ss_size = ProgramGuard::kSignalStack;
  sigaltstack(&stack, &stack_before_);
  sigset_t own;
  sigemptyset(&own);
  for (const int signal : kSignals) sigaddset(&own, signal);
  if (deadline != ProgramGuard::Time::max()) sigaddset(&own, GuardSignals::timer_signal());
  pthread_sigmask(SIG_UNBLOCK, &own, &mask_before_);
  if (deadline != ProgramGuard::Time::max()) start_timer(deadline);
}

GuardScope::~GuardScope() {
  if (!kGuardsPrograms) return;
  if (timer_) timer_delete(*timer_);
  running = outer_;
  pthread_sigmask(SIG_SETMASK, &mask_before_, nullptr);
  sigaltstack(&stack_before_, nullptr);
}

/// To this thread at the deadline, and again and again: once it may come at a bad time.
void GuardScope::start_timer(ProgramGuard::Time deadline) {
  constexpr long kAgain = 10'000'000;
  using std::chrono::nanoseconds;
  sigevent event{};
  event.sigev_notify = SIGEV_THREAD_ID;
  event.sigev_signo = GuardSignals::timer_signal();
  event._sigev_un._tid = static_cast<pid_t>(syscall(SYS_gettid));
  timer_t timer{};
  if (timer_create(CLOCK_MONOTONIC, &event, &timer) != 0) return;
  timer_ = timer;
  const std::int64_t left =
      std::max<std::int64_t>(std::chrono::duration_cast<nanoseconds>(deadline - time_now()).count(), 1);
  itimerspec when{};
  when.it_value = {static_cast<time_t>(left / 1'000'000'000), static_cast<long>(left % 1'000'000'000)};
  when.it_interval.tv_nsec = kAgain;
  timer_settime(timer, 0, &when, nullptr);
}

}  // namespace spu_emu
