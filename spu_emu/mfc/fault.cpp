#include "mfc/fault.h"

#include <libspe2-types.h>

#include <cerrno>
#include <cstdarg>
#include <cstdio>

#include "mfc/format.h"

namespace spu_emu {

const char* rule_name(Rule rule) {
  switch (rule) {
    case Rule::transfer_size:
      return "transfer size";
    case Rule::natural_alignment:
      return "natural alignment";
    case Rule::quadword_alignment:
      return "16-byte alignment";
    case Rule::quadword_offset:
      return "equal low 4 address bits";
    case Rule::tag:
      return "tag";
    case Rule::opcode:
      return "command code";
    case Rule::local_store_range:
      return "local store range";
    case Rule::effective_address:
      return "effective address";
    case Rule::list_size:
      return "list size";
    case Rule::list_address:
      return "list address";
    case Rule::list_crosses_4_gb:
      return "list element within 4 GB";
    case Rule::list_acknowledge:
      return "stall acknowledge";
    case Rule::proxy_command:
      return "proxy command";
    case Rule::word_transfer:
      return "whole words";
    case Rule::in_flight_overlap:
      return "unordered commands on one buffer";
    case Rule::in_flight_write:
      return "write into a get in flight";
    case Rule::in_flight_source:
      return "write into a put in flight";
    case Rule::in_flight_list:
      return "write into a list in flight";
    case Rule::deadlock:
      return "wait that can never end";
    case Rule::tag_update:
      return "tag update kind";
    case Rule::channel:
      return "channel";
    case Rule::halt:
      return "halt";
    case Rule::illegal_instruction:
      return "illegal instruction";
    case Rule::instruction_limit:
      return "instruction limit";
    case Rule::local_store_full:
      return "local store full";
    case Rule::stack_reserve:
      return "stack reserve";
    case Rule::register_access:
      return "problem state access";
    case Rule::memory_access:
      return "memory access";
    case Rule::stack_overflow:
      return "stack";
    case Rule::heap_overrun:
      return "heap overrun";
    case Rule::arithmetic:
      return "arithmetic";
    case Rule::abort:
      return "abort";
    case Rule::exception:
      return "exceptions stay in the program";
    case Rule::time_limit:
      return "time limit";
  }
  return "unknown";
}

StopReport stop_report(Rule rule) {
  switch (rule) {
    case Rule::transfer_size:
    case Rule::natural_alignment:
    case Rule::quadword_alignment:
    case Rule::quadword_offset:
    case Rule::list_address:
      return {SPE_RUNTIME_EXCEPTION, SPE_DMA_ALIGNMENT};
    case Rule::effective_address:
    case Rule::register_access:
      return {SPE_RUNTIME_EXCEPTION, SPE_DMA_STORAGE};
    case Rule::channel:
      return {SPE_RUNTIME_ERROR, SPE_SPU_INVALID_CHANNEL};
    case Rule::halt:
      return {SPE_RUNTIME_ERROR, SPE_SPU_HALT};
    case Rule::illegal_instruction:
      return {SPE_RUNTIME_ERROR, SPE_SPU_INVALID_INSTR};
    case Rule::instruction_limit:
    case Rule::time_limit:
      return {SPE_RUNTIME_FATAL, ETIMEDOUT};
    case Rule::memory_access:
    case Rule::heap_overrun:
      return {SPE_RUNTIME_FATAL, EFAULT};
    case Rule::arithmetic:
      return {SPE_RUNTIME_FATAL, EDOM};
    case Rule::abort:
    case Rule::exception:
      return {SPE_RUNTIME_FATAL, ECANCELED};
    case Rule::deadlock:
      return {SPE_RUNTIME_ERROR, SPE_SPU_WAITING_ON_CHANNEL};
    case Rule::local_store_full:
    case Rule::stack_reserve:
    case Rule::stack_overflow:
      return {SPE_RUNTIME_FATAL, ENOMEM};
    default:
      return {SPE_RUNTIME_EXCEPTION, SPE_INVALID_DMA};
  }
}

namespace {
std::string fault_text(Rule rule, const std::string& detail, const std::optional<Command>& command) {
  std::string text = format("rule \"%s\": %s", rule_name(rule), detail.c_str());
  if (!command) return text;
  text += format(" [%s LS 0x%05x EA 0x%llx size %u tag %u", command_name(command->opcode), command->ls,
                 static_cast<unsigned long long>(command->ea), command->size, command->tag);
  if (command->where.file != nullptr) text += format(" at %s:%d", command->where.file, command->where.line);
  return text + "]";
}
}  // namespace

Fault::Fault(Rule rule, std::string detail, std::optional<Command> command)
    : rule_(rule), command_(command), text_(fault_text(rule, detail, command)) {}

}  // namespace spu_emu
