// The functions that a program module calls: each turns a broken rule into the end of the program.
#include "host/host_program.h"
#include "spu_emu/channel_numbers.h"

namespace spu_emu {

namespace {
HostProgram& program_of(void* spe) {
  return *static_cast<HostProgram*>(spe);
}

/// Calls `use`; a Fault, or want of memory, leaves the program, after the exception has been dealt with and
/// nothing is left to destroy.
template <class Use>
auto guarded(void* spe, Use&& use) {
  const OutsideProgram outside(program_of(spe).guard());
  try {
    program_of(spe).check_stack(__builtin_frame_address(0));
    return use(program_of(spe));
  } catch (...) {
    program_of(spe).note_end({HostProgram::End::in_service, std::current_exception()});
  }
  program_of(spe).stop_for_end();
}

unsigned int read_channel(void* spe, unsigned int channel, SourceLine where) {
  return guarded(spe, [&](HostProgram& self) { return self.channels().read(channel, where); });
}

void write_channel(void* spe, unsigned int channel, unsigned int value, SourceLine where) {
  guarded(spe, [&](HostProgram& self) {
    if (channel == MFC_LSA) value = self.store().address_of_number(value);
    self.channels().write(channel, value, where);
  });
}

unsigned int channel_count(void* spe, unsigned int channel, SourceLine where) {
  return guarded(spe, [&](HostProgram& self) { return self.channels().count(channel, where); });
}

/// True for commands whose LS side is a pointer; the others leave it null.
bool uses_local_store(std::uint32_t opcode) {
  return is_store(opcode) || is_get(opcode) || opcode == MFC_PUTQLLUC_CMD || AtomicUnit::handles(opcode);
}

void dma(void* spe, const volatile void* ls, unsigned long long ea, unsigned int size, unsigned int tag,
         unsigned int command_word, const char* file, int line) {
  guarded(spe, [&](HostProgram& self) {
    Command command{command_word & 0xffU, tag, size, 0, ea, {file, line}};
    if (uses_local_store(command.opcode)) command.ls = self.ls_of(ls, command);
    if (is_list(command.opcode)) {
      command.ea = (ea & ~0xffffffffULL) | self.store().address_of_number(static_cast<std::uint32_t>(ea));
    }
    self.channels().dma(command);
  });
}

/// The program stops: what it issued lands first, as on the hardware, where the MFC goes on.
void stop(void* spe, unsigned int code, SourceLine) {
  guarded(spe, [&](HostProgram& self) {
    self.channels().finish();
    if ((code & 0xff00U) == 0x2000U) self.stop_for_exit(code);
    const bool call = (code & 0xff00U) == 0x2100U;
    const std::uint32_t word = call ? self.make_call_word(0, nullptr) : 0;
    self.stop_here({call ? Stop::Kind::library_call : Stop::Kind::signal, code, word, {}});
    if (call) self.free_call_word(word);
  });
}

int call_host(void* spe, unsigned int code, unsigned int opcode, void* data, SourceLine) {
  return guarded(spe, [&](HostProgram& self) {
    self.channels().finish();
    const std::uint32_t word = self.make_call_word(opcode, data);
    self.stop_here({Stop::Kind::library_call, code, word, {}});
    self.free_call_word(word);
    return 0;
  });
}

void halt(void* spe, SourceLine where) {
  guarded(spe, [&](HostProgram&) {
    std::string detail = "a halt instruction's condition held";
    if (where.file != nullptr) detail += std::string(" at ") + where.file + ":" + std::to_string(where.line);
    throw Fault(Rule::halt, detail);
  });
}

void* allocate(void* spe, std::size_t size, std::size_t alignment) {
  return guarded(spe, [&](HostProgram& self) { return self.allocate(size, alignment); });
}

void* reallocate(void* spe, void* block, std::size_t size) {
  return guarded(spe, [&](HostProgram& self) { return self.reallocate(block, size); });
}

void release(void* spe, void* block) {
  guarded(spe, [&](HostProgram& self) { self.release(block); });
}

unsigned int reserve_tags(void* spe, unsigned int count) {
  return program_of(spe).channels().tags().reserve(count);
}

unsigned int release_tags(void* spe, unsigned int tag, unsigned int count) {
  return program_of(spe).channels().tags().release(tag, count);
}
}  // namespace

HostServices make_services(HostProgram& program) {
  return {&program, &read_channel, &write_channel, &channel_count, &dma,          &stop,        &call_host,
          &halt,    &allocate,     &reallocate,    &release,       &reserve_tags, &release_tags};
}

}  // namespace spu_emu
