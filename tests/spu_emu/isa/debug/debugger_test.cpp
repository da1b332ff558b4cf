// The debugger on programs made of instruction words: where it stops, what it shows, what it refuses.
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <thread>

#include "debugged_program.h"
#include "spu_emu/channel_numbers.h"
#include "spu_emu/mfc_opcodes.h"

namespace spu_emu::isa {
namespace {

const std::uint32_t kEnd = stop_with(0x2005);

/// begin calls work, which calls leaf; data is at 0x400.
File calls() {
  const Code begin{encode("il", {0, 0}),       encode("ila", {1, 0x3ffd0}), encode("il", {2, 0}),
                   encode("stqd", {2, 0, 1}),  encode("il", {3, 7}),        encode("brsl", {0, 0x200 - 0x94}),
                   encode("stqa", {3, 0x400}), encode("stqa", {3, 0x400}),  kEnd};
  const Code work{encode("stqd", {0, 16, 1}),         encode("stqd", {1, -32, 1}),
                  encode("ai", {1, 1, -32}),          encode("ai", {3, 3, 1}),
                  encode("brsl", {0, 0x300 - 0x210}), encode("ai", {1, 1, 32}),
                  encode("lqd", {0, 16, 1}),          encode("bi", {0})};
  const Code leaf{encode("a", {3, 3, 3}), encode("bi", {0})};
  return ElfBuilder(0x80, {{0x80, begin}, {0x200, work}, {0x300, leaf}, {0x400, {1, 2, 3, 4}}},
                    {{"begin", 0x80}, {"work", 0x200}, {"leaf", 0x300}, {"data", 0x400}})
      .build();
}

File program(const Code& code) {
  return ElfBuilder(0x80, {{0x80, code}}, {{"begin", 0x80}}).build();
}

std::string output_of(const File& elf, const std::string& commands) {
  DebuggedProgram program(elf, commands);
  const std::string text = program.run();
  EXPECT_EQ(program.result, 0) << last_fault(program.context.spe);
  EXPECT_EQ(program.context.stop.result.spe_exit_code, 5);
  return text;
}

TEST(Debugger, stops_at_the_start_and_runs_on_when_the_commands_end) {
  const std::string text = output_of(calls(), "where\n");
  EXPECT_EQ(text,
            "SPE N's program begins\n"
            "  at pc 0x00080 in begin: il $0,0\n"
            "(spu N) where\n"
            "  at pc 0x00080 in begin: il $0,0\n");
}

TEST(Debugger, stops_at_symbols_and_addresses) {
  const std::string text = output_of(
      calls(), "break leaf\nbreak *0x94\nbreak work+0x14\ncontinue\ncontinue\ncontinue\ncontinue\n");
  expect_in(text, "breakpoint 1 at 0x00300 in leaf\n");
  expect_in(text, "breakpoint 2\n  at pc 0x00094 in begin+0x14: brsl");
  expect_in(text, "breakpoint 1\n  at pc 0x00300 in leaf: a $3,$3,$3\n");
  expect_in(text, "breakpoint 3\n  at pc 0x00214 in work+0x14: ai $1,$1,32");
  expect_in(text, "SPE N's program has ended with exit code 5 after 19 instructions\n");
}

TEST(Debugger, stops_once_at_a_temporary_breakpoint_and_no_more_at_a_deleted_one) {
  // A loop of three rounds.
  const File loop = program({encode("il", {3, 3}), encode("ai", {3, 3, -1}), encode("brnz", {3, -4}), kEnd});
  std::string text = output_of(loop, "tbreak 0x84\ncontinue\ncontinue\n");
  expect_in(text, "breakpoint 1\n");
  expect_in(text, "ended with exit code 5 after 8 instructions");
  text = output_of(loop, "break 0x84\ncontinue\ncontinue\nbreakpoints\ndelete 1\ncontinue\n");
  expect_in(text, "1   0x00084 in begin+0x4, met 2 times\n");
  expect_in(text, "ended");
}

TEST(Debugger, steps_by_instructions_into_calls_and_over_them) {
  const std::string text = output_of(calls(), "stepi 5\nstepi\nwhere\nfinish\nregisters int4 3\nnexti 2\n");
  expect_in(text, "(spu N) stepi 5\n  at pc 0x00094");
  expect_in(text, "(spu N) stepi\n  at pc 0x00200 in work");
  expect_in(text,
            "the function has returned, r3 00000010 00000010 00000010 00000010\n  at pc 0x00098 in "
            "begin+0x18: stqa");
  expect_in(text, "r3            16          16          16          16\n");
  expect_in(text, "(spu N) nexti 2\n  at pc 0x000a0");
  expect_in(output_of(calls(), "stepi 5\nnexti\n"), "(spu N) nexti\n  at pc 0x00098 in begin+0x18");
}

TEST(Debugger, says_why_a_step_by_lines_is_one_by_instructions) {
  expect_in(output_of(calls(), "step\n"), "Source lines are not known");
  expect_in(output_of(calls(), "step\n"), "One step is one instruction here.\n  at pc 0x00084");
}

/// The table of lines of calls(), of which leaf has none, by a command in the place of `spu-run
/// --list-lines`.
class ListedLines {
 public:
  ListedLines()
      : table_(
            "file /no/such/folder/calls.s\n"
            "0x80 10 statement\n0x94 11 statement\n0x98 12 statement\n0xa4 12 end\n"
            "0x200 20 statement\n0x20c 21 statement\n0x214 22 statement\n0x220 22 end\n") {
    setenv("SPU_EMU_LINE_READER", ("cat " + table_.name + " #").c_str(), 1);
  }
  ~ListedLines() { unsetenv("SPU_EMU_LINE_READER"); }

 private:
  CommandFile table_;
};

TEST(Debugger, steps_by_lines_into_calls_that_have_some_and_through_others) {
  const ListedLines lines;
  const std::string text =
      output_of(calls(), "break calls.s:11\ncontinue\nstep\nstep\nstep\nbacktrace\nstep\nstep\n");
  expect_in(text, "breakpoint 1 at 0x00094 in begin+0x14 (calls.s:11)\n");
  expect_in(text,
            "11     (its file is not there to be read)\n(spu N) step\n  at pc 0x00200 in work (calls.s:20)");
  expect_in(text, "(spu N) step\n  at pc 0x0020c in work+0xc (calls.s:21)");
  expect_in(text, "(spu N) step\n  at pc 0x00214 in work+0x14 (calls.s:22)");
  expect_in(text, "#1   0x00094 in begin+0x14 (calls.s:11)\n");
  expect_in(text, "(spu N) step\n  at pc 0x00098 in begin+0x18 (calls.s:12)");
}

TEST(Debugger, steps_over_calls_and_several_lines_at_once) {
  const ListedLines lines;
  const std::string text = output_of(calls(), "next\nnext\nwhere 0x204\n");
  expect_in(text, "(spu N) next\n  at pc 0x00094 in begin+0x14 (calls.s:11)");
  expect_in(text, "(spu N) next\n  at pc 0x00098 in begin+0x18 (calls.s:12)");
  expect_in(text, "(spu N) where 0x204\n0x00204 in work+0x4 (calls.s:20)\n");
  expect_in(output_of(calls(), "step 4\n"), "(spu N) step 4\n  at pc 0x00214 in work+0x14 (calls.s:22)");
  expect_in(output_of(calls(), "next\nbreak work\nnext\n"), "breakpoint 1\n  at pc 0x00200 in work");
}

TEST(Debugger, breaks_at_lines_and_says_which_have_no_code) {
  const ListedLines lines;
  const std::string text =
      output_of(calls(), "break 12\nbreak 13\nbreak calls.s:23\nbreak other.s:1\nbreak s:12\nlist\n");
  expect_in(text, "breakpoint 1 at 0x00098 in begin+0x18 (calls.s:12)\n");
  expect_in(text, "breakpoint 2 at 0x00200 in work (calls.s:20)\n");
  expect_in(text, "calls.s has no code at line 23 or behind it: its last line with code is 22.\n");
  expect_in(text, "No code of the program comes from a file \"other.s\".\n");
  expect_in(text, "No code of the program comes from a file \"s\".\n");
  expect_in(text, "/no/such/folder/calls.s cannot be read here.\n");
}

TEST(Debugger, follows_the_chain_of_calls_wherever_the_innermost_function_stands) {
  // Before and in the prologue of work, in its body, in leaf, behind its call, in the epilogue.
  for (const char* place : {"0x200", "0x204", "0x208", "0x20c", "0x214", "0x218", "0x21c"}) {
    const std::string text = output_of(calls(), std::string("break ") + place + "\ncontinue\nbacktrace\n");
    expect_in(text, std::string("#0   0x00") + (place + 2) + " in work");
    expect_in(text, "\n#1   0x00094 in begin+0x14\n");
    expect_not_in(text, "#2 ");
  }
  const std::string text = output_of(calls(), "break leaf\ncontinue\nbacktrace\n");
  expect_in(text, "#0   0x00300 in leaf\n#1   0x00210 in work+0x10\n#2   0x00094 in begin+0x14\n");
}

TEST(Debugger, ends_a_chain_that_makes_no_sense) {
  const File broken =
      program({encode("ila", {1, 0x3fff8}), encode("ila", {0, 0x3fffc}), encode("nop", {0}), kEnd});
  const std::string text = output_of(broken, "stepi 2\nbacktrace\nfinish\n");
  expect_in(text, "#0   0x00088 in begin+0x8\n(spu N) finish\nNo caller is known");
}

TEST(Debugger, stops_before_a_store_that_changes_watched_bytes) {
  const std::string text = output_of(calls(), "watch data\ncontinue\nmemory data 16\ncontinue\n");
  expect_in(text, "watchpoint 1: LS 0x00400 to 0x00403, 4 bytes\n");
  expect_in(text,
            "watchpoint 1: a store is about to change LS 0x00400: 00000001 -> 00000010\n  at pc 0x00098 in "
            "begin+0x18: stqa");
  expect_in(text, "0x00400  00000001 00000002 00000003 00000004  ................\n");
  expect_in(text, "ended");  // The second store changes nothing.
}

TEST(Debugger, stops_at_every_store_when_asked_always) {
  const std::string text = output_of(calls(), "watch 0x404 4 always\ncontinue\ncontinue\ncontinue\n");
  expect_in(text, "change LS 0x00404: 00000002 -> 00000010\n");
  expect_in(text, "a store is about to write LS 0x00404: 00000010 again\n  at pc 0x0009c");
}

TEST(Debugger, does_not_stop_at_stores_beside_the_watched_bytes) {
  expect_not_in(output_of(calls(), "watch 0x410 16\ncontinue\n"), "about to");
}

TEST(Debugger, tells_of_watched_bytes_that_a_transfer_changes) {
  Code code;
  append_wait(append_dma(code, MFC_GET_CMD, 0x1000, 64));
  code.push_back(kEnd);
  DebuggedProgram debugged(program(code), "watch 0x1010 4\ncontinue\nwhere\n");
  const MainWords memory;
  const std::string text = debugged.run(&memory);
  expect_in(text, "watchpoint 1: this SPE's MFC or library call changed LS 0x01010: 00000000 -> 10111213\n");
}

TEST(Debugger, tells_of_watched_bytes_that_the_host_changes) {
  // Waits for a mailbox, into which the host writes after it has changed the store by DMA.
  DebuggedProgram debugged(program({encode("rdch", {3, SPU_RdInMbox}), encode("nop", {0}), kEnd}),
                           "watch 0x1000 16\ncontinue\nregisters 3\n");
  MainWords memory;
  std::thread host([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(400));
    spe_mfcio_get(debugged.context.spe, 0x1000, &memory, 16, 0, 0, 0);
    unsigned int status = 0;
    spe_mfcio_tag_status_read(debugged.context.spe, 1, SPE_TAG_ALL, &status);
    std::this_thread::sleep_for(std::chrono::milliseconds(400));
    unsigned int message = 3;
    spe_in_mbox_write(debugged.context.spe, &message, 1, SPE_MBOX_ALL_BLOCKING);
  });
  const std::string text = debugged.run();
  host.join();
  expect_in(text, "watchpoint 1: the host or another SPE changed LS 0x01000: ");
  expect_in(text, "SPE N waits: read in mailbox\n");
}

TEST(Debugger, does_not_take_a_store_for_a_change_by_others) {
  // The watch is set while the program stands before the store; then a transfer makes the debugger look.
  Code code{encode("il", {3, 9}), encode("stqa", {3, 0x1000})};
  append_wait(append_dma(code, MFC_GET_CMD, 0x2000, 64));
  code.push_back(kEnd);
  DebuggedProgram debugged(program(code), "stepi\nwatch 0x1000 4\ncontinue\n");
  const MainWords memory;
  const std::string text = debugged.run(&memory);
  expect_not_in(text, "changed");
  expect_in(text, "ended");
}

TEST(Debugger, stops_at_channels_by_name_and_number) {
  const File channels = program(
      {encode("il", {3, 21}), encode("wrch", {SPU_WrOutMbox, 3}), encode("rdch", {4, SPU_RdDec}), kEnd});
  std::string text = output_of(
      channels, "watch SPU_WrOutMbox\nwatch channel 8 read\nwatch spu_wrdec\ncontinue\ncontinue\ncontinue\n");
  expect_in(text,
            "watchpoint 1: 0x00000015 is about to be written to channel 28, SPU_WrOutMbox\n  at pc 0x00084");
  expect_in(text, "watchpoint 2: channel 8, SPU_RdDec, is about to be read\n  at pc 0x00088");
  text = output_of(channels, "watch SPU_WrOutMbox read\ncontinue\n");
  expect_not_in(text, "about to");
}

TEST(Debugger, shows_registers_memory_and_instructions) {
  const std::string text = output_of(calls(),
                                     "stepi 5\nregisters 3\nr float4 $1-2\nregisters x8 r3\nmemory 0x400 8 "
                                     "short8\nm data+4 6\ndisassemble leaf 2\nwhere 0x304\n");
  expect_in(text, "(spu N) registers 3\nr3   00000007 00000007 00000007 00000007\n");
  expect_in(text, "(spu N) registers x8 r3\nr3   0000 0007 0000 0007 0000 0007 0000 0007\n");
  expect_in(text, "0x00400       0      1      0      2\n");
  expect_in(text, "0x00404  00000002 00000003");
  expect_in(text, "   0x00300  leaf                 a $3,$3,$3\n   0x00304  leaf+0x4             bi $0\n");
  expect_in(text, "(spu N) where 0x304\n0x00304 in leaf+0x4\n");
}

TEST(Debugger, refuses_what_is_not_there_with_the_limit) {
  const std::string text =
      output_of(calls(),
                "break 0x40000\nbreak 0x82\nmemory 0x3fff8 16\nwatch 0x3fffe 4\nregisters 128\n"
                "registers 9-3\nregisters floaty 3\nbreak lead\nbreak 12\nwatch channel 200\n"
                "delete 7\nmemory\nstepi 0\ncontinue for ever\nmemory 0xfffffffff\nwatch 0 0\n");
  expect_in(text,
            "0x40000 is beyond the 262144 bytes of the local store: its last instruction is at 0x3fffc.\n");
  expect_in(text, "0x82 is no multiple of 4");
  expect_in(text, "16 bytes at 0x3fff8 end at 0x40008, beyond the 262144 bytes of the local store.\n");
  expect_in(text, "4 bytes at 0x3fffe end at 0x40002, beyond");
  expect_in(text, "There is no register 128: they are 0 to 127.\n");
  expect_in(text, "\"9-3\" goes from high to low");
  expect_in(text, "\"floaty\" is neither a register (0 to 127, or 3-7) nor a format: x4 ");
  expect_in(text, "There is no symbol \"lead\"; the nearest is leaf.\n");
  expect_in(text, "No source lines are known: compile with -g");
  expect_in(text, "There is no channel 200: they are 0 to 127.\n");
  expect_in(text, "There is no breakpoint 7");
  expect_in(text, "Which memory? It is: memory ADDRESS [SIZE] [FORMAT]\n");
  expect_in(text, "0 is no number of steps");
  expect_in(text, "\"ever\" is no number of seconds");
  expect_in(text, "\"0xfffffffff\" is no number");
  expect_in(text, "A range of 0 bytes cannot be watched.\n");
}

TEST(Debugger, suggests_the_nearest_command_and_takes_beginnings_of_names) {
  const std::string text = output_of(calls(), "contineu\nxyzzyplugh\nback\ns\nm\nst\n");
  expect_in(text, "There is no command \"contineu\"; the nearest is continue, and help lists all of them.\n");
  expect_in(text, "There is no command \"xyzzyplugh\"; help lists all of them.\n");
  expect_in(text, "(spu N) back\n#0   0x00080 in begin\n");
  expect_in(text, "\"st\" is the beginning of several commands: step, stepi.\n");
}

TEST(Debugger, teaches_every_command_in_80_columns) {
  std::string commands = "help\nhelp help\n";
  for (const char* name :
       {"continue",  "step",   "next",        "stepi",     "nexti",   "finish",    "quit", "break",
        "tbreak",    "watch",  "breakpoints", "delete",    "where",   "backtrace", "list", "disassemble",
        "registers", "memory", "queue",       "mailboxes", "signals", "events",    "spes"}) {
    commands += std::string("help ") + name + "\n";
  }
  std::istringstream lines(output_of(calls(), commands));
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) EXPECT_LE(line.size(), 80U) << line;
  EXPECT_GT(count, 120);
}

TEST(Debugger, stops_where_a_rule_is_broken_with_everything_still_there) {
  Code code;
  append_dma(code, MFC_GET_CMD, 0x1000, 100);
  code.push_back(kEnd);
  DebuggedProgram debugged(program(code), "continue\nqueue\nregisters 4\ncontinue\n");
  const std::string text = debugged.run();
  EXPECT_EQ(debugged.result, -1);
  EXPECT_EQ(debugged.context.stop.stop_reason, unsigned{SPE_RUNTIME_EXCEPTION});
  expect_in(text, "rule \"transfer size\": 100 bytes");
  expect_in(text, "written so far LS 0x01000  EA 0x0  size 100  tag 0\n");
  expect_in(text, "The program broke a rule and cannot go on: it ends.\n");
}

TEST(Debugger, shows_the_queue_and_the_tags_of_late_transfers) {
  Code code;
  append_dma(code, MFC_GETF_CMD, 0x1000, 64);
  code.push_back(encode("il", {10, 1}));
  code.push_back(encode("wrch", {MFC_WrTagMask, 10}));
  const auto stop_at = static_cast<unsigned>(0x80 + 4 * code.size());
  code.push_back(kEnd);
  EmulationSettings settings;
  settings.dma_mode = DmaMode::late;
  char commands[64];
  std::snprintf(commands, sizeof commands, "break 0x%x\ncontinue\nqueue\n", stop_at);
  DebuggedProgram debugged(program(code), commands, settings);
  const MainWords memory;
  const std::string text = debugged.run(&memory);
  expect_in(text, "queue          1 of 16 commands\n  getf     tag  0  LS 0x01000  EA 0x");
  expect_in(text, "size 64\nproxy queue    0 of 8 commands\ntags in flight 0\ntag mask       0\n");
  expect_in(text, "DMA mode       late\n");
}

TEST(Debugger, shows_mailboxes_signals_and_events_without_reading_them) {
  DebuggedProgram debugged(
      program({encode("il", {3, 5}), encode("wrch", {SPU_WrOutMbox, 3}), encode("rdch", {4, SPU_RdInMbox}),
               encode("rdch", {5, SPU_RdSigNotify2}), kEnd}),
      "stepi 2\nmailboxes\nsignals\nevents\nspes\n");
  unsigned int messages[] = {0x11, 0x22};
  ASSERT_EQ(spe_in_mbox_write(debugged.context.spe, messages, 2, SPE_MBOX_ALL_BLOCKING), 2);
  ASSERT_EQ(spe_signal_write(debugged.context.spe, SPE_SIG_NOTIFY_REG_2, 0x77), 0);
  const std::string text = debugged.run();
  EXPECT_EQ(debugged.result, 0) << "what was shown could still be read";
  expect_in(
      text,
      "in mailbox             2 of 4: 0x00000011 0x00000022\nout mailbox            1 of 1: 0x00000005\n");
  expect_in(text,
            "signal 1  0x00000000  nothing to read  (later ones overwrite)\nsignal 2  0x00000077  waits to "
            "be read");
  expect_in(text, "pending  signal 2, in mailbox available\nmask     none\n");
  expect_in(text, "SPE N  stands here, in the debugger\n       in mailbox 2 of 4, out mailbox 1 of 1");
}

TEST(Debugger, says_which_spe_waits_for_what) {
  IsaContext other(Code{encode("rdch", {3, SPU_RdSigNotify1}), kEnd});
  std::thread other_runs([&] { EXPECT_EQ(other.run(), 0); });
  DebuggedProgram debugged(program({encode("rdch", {3, SPU_RdInMbox}), kEnd}),
                           "continue for 0.2\nspes\ncontinue for 0.1\n");
  std::thread host([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(1500));
    unsigned int message = 1;
    spe_in_mbox_write(debugged.context.spe, &message, 1, SPE_MBOX_ALL_BLOCKING);
    spe_signal_write(other.spe, SPE_SIG_NOTIFY_REG_1, 1);
  });
  const std::string text = debugged.run();
  host.join();
  other_runs.join();
  expect_in(text, "the time is up\nSPE N waits: read in mailbox\n  at pc 0x00080 in begin: rdch $3,$ch29\n");
  expect_in(text, " s: read signal 1\n       in mailbox 0 of 4");
  expect_in(text, " s: read in mailbox\n");
}

TEST(Debugger, stops_at_ctrl_c_in_a_loop_and_in_a_wait) {
  const File loop = program(
      {encode("rdch", {3, SPU_RdInMbox}), encode("rchcnt", {4, SPU_RdInMbox}), encode("brz", {4, -4}), kEnd});
  DebuggedProgram debugged(loop, "continue\ncontinue\nregisters 3\n");
  std::thread host([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(400));
    std::raise(SIGINT);
    std::this_thread::sleep_for(std::chrono::milliseconds(400));
    unsigned int message = 8;
    spe_in_mbox_write(debugged.context.spe, &message, 1, SPE_MBOX_ALL_BLOCKING);
    std::this_thread::sleep_for(std::chrono::milliseconds(400));
    std::raise(SIGINT);
    std::this_thread::sleep_for(std::chrono::milliseconds(400));
    spe_in_mbox_write(debugged.context.spe, &message, 1, SPE_MBOX_ALL_BLOCKING);
  });
  const std::string text = debugged.run();
  host.join();
  expect_in(text, "interrupted\nSPE N waits: read in mailbox\n");
  expect_in(text, "interrupted\n  at pc 0x0008");
  expect_in(text, "r3   00000008 ");
}

TEST(Debugger, goes_along_through_stops_for_the_host) {
  DebuggedProgram debugged(program({stop_with(0x123), encode("il", {3, 1}), kEnd}), "stepi\nwhere\n");
  std::string text = debugged.run();
  EXPECT_EQ(debugged.result, 0x123);
  text = debugged.resume();
  EXPECT_EQ(debugged.result, 0);
  expect_in(text, "  at pc 0x00084 in begin+0x4: il $3,1\n(spu N) where\n");
}

TEST(Debugger, does_not_count_its_own_time_as_the_programs) {
  EmulationSettings settings;
  settings.time_limit = std::chrono::milliseconds(1000);
  DebuggedProgram debugged(program({encode("rdch", {3, SPU_RdInMbox}), kEnd}),
                           "continue for 0.1\ncontinue\nspes\n", settings);
  const std::string text = debugged.run();
  EXPECT_EQ(debugged.result, -1);
  expect_in(text, "the time is up");
  expect_in(text, "still waits when its time is over: read in mailbox");
}

TEST(Debugger, sets_registers_and_memory_as_elements_of_any_width) {
  const std::string text = output_of(
      calls(),
      "set $3 float4 1.5 -2\nregisters float4 3\nset $3 9\nregisters int4 3\nset $4 data+8\nregisters 4\n"
      "set data short8 -1 2 3\nset data+12 0xffffffff\nmemory data 16\nset $5 double2 0.5 -4\nregisters "
      "double2 5\n");
  expect_in(text, "r3               1.5              -2 ");
  expect_in(text, "r3             9 -1073741824 ");
  expect_in(text, "r4   00000408 ");
  expect_in(text, "0x00400  ffff0002 00030002 00000003 ffffffff");
  expect_in(text, "0.5                       -4\n");
}

TEST(Debugger, changes_nothing_where_a_value_cannot_be_set) {
  const std::string text = output_of(
      calls(),
      "set\nset $90\nset $90 int4\nset $90 short8 1 32768 65536\nset $90 char16 -129\nset $90 float4 x\nset "
      "$128 "
      "1\n"
      "set $90 1 2 3 4 5\nset 0x3fffc 1 2\nset pc 0x80\nset $90 nothing\nregisters 90\nmemory 0x3fff0 16\n");
  expect_in(text, "Set what to what? It is: set WHAT [FORMAT] VALUE...\n");
  expect_in(text, "There is no value");
  expect_in(text, "\"65536\" does not fit into 16 bits.");
  expect_in(text, "\"-129\" does not fit into 8 bits.");
  expect_in(text, "\"x\" is no number.");
  expect_in(text, "There is no register 128");
  expect_in(text, "A register has 16 bytes");
  expect_in(text, "8 bytes at 0x3fffc end at 0x40004");
  expect_in(text, "is not set by a command");
  expect_in(text, "There is no symbol \"nothing\"");
  expect_in(text, "r90  00000000 00000000 00000000 00000000\n");
  expect_in(text, "0x3fff0  00000000 00000000 00000000 00000000");
}

TEST(Debugger, what_it_sets_is_no_change_that_a_watchpoint_tells_and_is_executed_as_code) {
  const std::string text = output_of(
      calls(),
      "watch data 4\nset data 77\nset begin+4 0x40800383\nstepi 2\nregisters int4 3\nmemory data 4 int4\n"
      "set begin+4 0x4200007f\ncontinue\ndelete\ncontinue\n");
  expect_not_in(text, "changed");
  expect_in(text, "r3             7           7");
  expect_in(text, "0x00400           77\n");
}

TEST(Debugger, without_debug_information_variables_are_not_known_and_it_is_said_why) {
  expect_in(output_of(calls(), "print data\nprint\n"), "Variables are not known: ");
}

TEST(Debugger, says_what_commands_were_left_when_the_program_ended) {
  expect_in(output_of(calls(), "continue\nwhere\n# a comment\n\nqueue\n"), "2 commands were not used\n");
}

TEST(Debugger, of_a_number_in_the_environment_is_that_spes_alone) {
  const CommandFile commands("registers 3\n");
  IsaContext first(Code{kEnd});
  testing::internal::CaptureStderr();
  EXPECT_EQ(first.run(), 0);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  // The number of the context that is made next is one more than that of this one.
  DebuggedProgram probe(program({kEnd}), "spes\n");
  testing::internal::CaptureStderr();
  EXPECT_EQ(probe.context.run(), 0);
  const std::string spes = testing::internal::GetCapturedStderr();
  const unsigned number = static_cast<unsigned>(std::stoul(spes.substr(spes.find("(spu ") + 5)));
  setenv("SPU_EMU_DEBUG", std::to_string(number + 2).c_str(), 1);
  setenv("SPU_EMU_DEBUG_COMMANDS", commands.name.c_str(), 1);
  IsaContext other(Code{kEnd});
  IsaContext chosen(Code{kEnd});
  unsetenv("SPU_EMU_DEBUG");
  unsetenv("SPU_EMU_DEBUG_COMMANDS");
  testing::internal::CaptureStderr();
  EXPECT_EQ(other.run(), 0);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  testing::internal::CaptureStderr();
  EXPECT_EQ(chosen.run(), 0);
  expect_in(testing::internal::GetCapturedStderr(), "registers 3\nr3 ");
}

TEST(Debugger, of_several_spes_has_a_prompt_and_a_file_for_each) {
  const CommandFile commands("registers 3\n");
  setenv("SPU_EMU_DEBUG", "all", 1);
  setenv("SPU_EMU_DEBUG_COMMANDS", commands.name.c_str(), 1);
  IsaContext probe(Code{kEnd});
  testing::internal::CaptureStderr();
  EXPECT_EQ(probe.run(), 0);
  const std::string spoken = testing::internal::GetCapturedStderr();
  const unsigned number = static_cast<unsigned>(std::stoul(spoken.substr(spoken.find("(spu ") + 5)));
  const std::string folder = testing::TempDir() + "spu_emu_stops_" + std::to_string(getpid()) + ".";
  for (const unsigned each : {number + 1, number + 3})
    std::ofstream(folder + std::to_string(each)) << "registers " << each % 100 << "\n";
  setenv("SPU_EMU_DEBUG", (std::to_string(number + 1) + "," + std::to_string(number + 3)).c_str(), 1);
  setenv("SPU_EMU_DEBUG_COMMANDS", (folder + "%").c_str(), 1);
  for (unsigned each = number + 1; each <= number + 3; ++each) {
    IsaContext context(Code{kEnd});
    testing::internal::CaptureStderr();
    EXPECT_EQ(context.run(), 0);
    const std::string said = testing::internal::GetCapturedStderr();
    const std::string prompt =
        "(spu " + std::to_string(each) + ") registers " + std::to_string(each % 100) + "\n";
    EXPECT_EQ(said.find(prompt) != std::string::npos, each != number + 2) << said;
    std::remove((folder + std::to_string(each)).c_str());
  }
  unsetenv("SPU_EMU_DEBUG");
  unsetenv("SPU_EMU_DEBUG_COMMANDS");
}

TEST(Debugger, is_refused_in_words_where_its_settings_are_wrong) {
  EmulationSettings settings;
  settings.debugger = {"/no/such/file"};
  IsaContext no_file(Code{kEnd}, settings);
  EXPECT_EQ(no_file.load_result, -1);
  EXPECT_EQ(errno, ENOENT);
  no_file.expect_fault("the debugger's commands, /no/such/file: No such file or directory");
  setenv("SPU_EMU_DEBUG", "first", 1);
  IsaContext no_number(Code{kEnd});
  unsetenv("SPU_EMU_DEBUG");
  EXPECT_EQ(no_number.load_result, -1);
  no_number.expect_fault(
      "SPU_EMU_DEBUG=\"first\" is no number of an SPE; the first that a program makes is 0");
}

}  // namespace
}  // namespace spu_emu::isa
