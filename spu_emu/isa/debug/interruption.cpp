#include "isa/debug/interruption.h"

namespace spu_emu::isa {

namespace {
std::atomic<Machine*> interrupted_machine{nullptr};
std::atomic<bool> came{false};

void on_ctrl_c(int) {
  Machine* machine = interrupted_machine.load();
  if (machine == nullptr || came.exchange(true)) {
    ::signal(SIGINT, SIG_DFL);
    ::raise(SIGINT);
    return;
  }
  machine->ask_for_attention();
}
}  // namespace

CtrlC::CtrlC(Machine& machine) : machine_(machine) {
  interrupted_machine.store(&machine);
  came.store(false);
  struct sigaction action {};
  action.sa_handler = &on_ctrl_c;
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, &before_);
}

CtrlC::~CtrlC() {
  Machine* mine = &machine_;
  if (interrupted_machine.compare_exchange_strong(mine, nullptr)) sigaction(SIGINT, &before_, nullptr);
}

bool CtrlC::take() {
  return interrupted_machine.load() == &machine_ && came.exchange(false);
}

void Timer::start(std::chrono::milliseconds time) {
  cancel();
  cancelled_ = false;
  thread_ = std::thread([this, time] { run(time); });
}

void Timer::run(std::chrono::milliseconds time) {
  std::unique_lock lock(mutex_);
  if (cancelled_now_.wait_for(lock, time, [this] { return cancelled_; })) return;
  is_up_.store(true);
  machine_.ask_for_attention();
}

void Timer::cancel() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    cancelled_ = true;
  }
  cancelled_now_.notify_all();
  thread_.join();
  is_up_.store(false);
}

}  // namespace spu_emu::isa
