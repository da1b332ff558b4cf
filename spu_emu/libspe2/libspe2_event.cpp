// libspe2: event handlers.
#include <algorithm>
#include <bit>
#include <cerrno>
#include <memory>
#include <new>
#include <set>
#include <vector>

#include "libspe2/context.h"
#include "spe/host_waits.h"

namespace {

using spu_emu::fail;

/// The events registered with a handler, one unit for each event of a context.
struct EventHandler {
  const std::uint64_t made_after_forks = spu_emu::forks_before();
  std::mutex mutex;
  std::vector<spe_event_unit_t> units;
};

struct HandlerList {
  std::mutex mutex;
  std::set<EventHandler*> handlers;
};

HandlerList& handler_list() {
  static HandlerList list;
  return list;
}

EventHandler* handler_of(spe_event_handler_ptr_t pointer) {
  return static_cast<EventHandler*>(pointer);
}

bool is_here(const EventHandler* handler) {
  return handler != nullptr && handler->made_after_forks == spu_emu::forks_before();
}

/// In late mode a proxy command lands when somebody waits for its tag group.
bool tag_group_done(spe_context_ptr_t spe) {
  const std::lock_guard lock(spe->spe.proxy_mutex());
  if (spe->used_tags == 0) return false;
  try {
    spe->spe.proxy().land_all();
  } catch (const spu_emu::Fault& fault) {
    spe->spe.set_last_fault(fault.text());
  }
  return (spe->used_tags & ~spe->spe.proxy().pending_tags()) != 0;
}

bool has_happened(const spe_event_unit_t& unit) {
  switch (unit.events) {
    case SPE_EVENT_OUT_INTR_MBOX:
      return unit.spe->spe.channels().out_interrupt_mailbox().count() != 0;
    case SPE_EVENT_IN_MBOX:
      return unit.spe->spe.channels().in_mailbox().space() != 0;
    case SPE_EVENT_TAG_GROUP:
      return tag_group_done(unit.spe);
    default: {
      const std::lock_guard lock(unit.spe->stop_mutex);
      return !unit.spe->stops.empty();
    }
  }
}

int collect(EventHandler& handler, spe_event_unit_t* events, int max_events) {
  const std::lock_guard lock(handler.mutex);
  int found = 0;
  for (const spe_event_unit_t& unit : handler.units) {
    if (found < max_events && has_happened(unit)) events[found++] = unit;
  }
  return found;
}

int check_unit(const EventHandler* handler, const spe_event_unit_t* event) {
  if (!is_here(handler)) return fail(ESRCH);
  if (event == nullptr || !spu_emu::is_here(event->spe)) return fail(EINVAL);
  if (!event->spe->events_enabled() || (event->events & ~unsigned{SPE_EVENT_ALL_EVENTS}) != 0)
    return fail(ENOTSUP);
  return 0;
}

/// Calls `use` with each single event bit.
template <class Use>
void for_each_event(unsigned events, Use&& use) {
  for (unsigned bit = 1; bit <= SPE_EVENT_SPE_STOPPED; bit <<= 1U) {
    if ((events & bit) != 0) use(bit);
  }
}

bool registered(const EventHandler& handler, spe_context_ptr_t spe, unsigned events) {
  return std::any_of(handler.units.begin(), handler.units.end(), [&](const spe_event_unit_t& unit) {
    return unit.spe == spe && (unit.events & events) != 0;
  });
}

}  // namespace

void spu_emu::forget_in_event_handlers(spe_context_ptr_t spe) {
  const std::lock_guard lock(handler_list().mutex);
  for (EventHandler* handler : handler_list().handlers) {
    const std::lock_guard handler_lock(handler->mutex);
    std::erase_if(handler->units, [&](const spe_event_unit_t& unit) { return unit.spe == spe; });
  }
}

spe_event_handler_ptr_t spe_event_handler_create(void) {
  try {
    auto handler = std::make_unique<EventHandler>();
    const std::lock_guard lock(handler_list().mutex);
    handler_list().handlers.insert(handler.get());
    return handler.release();
  } catch (const std::bad_alloc&) {
    errno = ENOMEM;
    return nullptr;
  }
}

int spe_event_handler_destroy(spe_event_handler_ptr_t evhandler) {
  if (evhandler == nullptr) return fail(ESRCH);
  EventHandler* handler = handler_of(evhandler);
  if (!is_here(handler)) return 0;  // Left to the end of this process, a child: see spe_context_destroy.
  {
    const std::lock_guard lock(handler_list().mutex);
    handler_list().handlers.erase(handler);
  }
  delete handler;
  return 0;
}

int spe_event_handler_register(spe_event_handler_ptr_t evhandler, spe_event_unit_t* event) {
  EventHandler* handler = handler_of(evhandler);
  if (check_unit(handler, event) != 0) return -1;
  {
    const std::lock_guard lock(handler->mutex);
    if (registered(*handler, event->spe, event->events)) return fail(EEXIST);
    try {
      handler->units.reserve(handler->units.size() + static_cast<std::size_t>(std::popcount(event->events)));
    } catch (const std::bad_alloc&) {
      return fail(ENOMEM);
    }
    for_each_event(event->events, [&](unsigned bit) {
      handler->units.push_back({bit, event->spe, event->data});
    });
  }
  event->spe->spe.channels().changed().notify();
  return 0;
}

int spe_event_handler_deregister(spe_event_handler_ptr_t evhandler, spe_event_unit_t* event) {
  EventHandler* handler = handler_of(evhandler);
  if (check_unit(handler, event) != 0) return -1;
  const std::lock_guard lock(handler->mutex);
  bool all = true;
  for_each_event(event->events, [&](unsigned bit) { all = all && registered(*handler, event->spe, bit); });
  if (!all) return fail(ENOENT);
  std::erase_if(handler->units, [&](const spe_event_unit_t& unit) {
    return unit.spe == event->spe && (unit.events & event->events) != 0;
  });
  return 0;
}

int spe_event_wait(spe_event_handler_ptr_t evhandler, spe_event_unit_t* events, int max_events, int timeout) {
  if (!is_here(handler_of(evhandler))) return fail(ESRCH);
  if (events == nullptr || max_events <= 0) return fail(EINVAL);
  EventHandler& handler = *handler_of(evhandler);
  auto deadline = spu_emu::WaitPoint::Time::max();
  if (timeout >= 0) deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds(timeout);
  int found = collect(handler, events, max_events);
  if (found == 0 && timeout != 0) {
    const spu_emu::HostWait wait(__func__);
    spu_emu::event_point().wait_until(
        [&] {
          found = collect(handler, events, max_events);
          return found != 0;
        },
        deadline);
  }
  return found;
}
