// The job that the DMA benchmark gives its SPU program.
#ifndef SPU_EMU_BENCH_DMA_H
#define SPU_EMU_BENCH_DMA_H

struct alignas(128) DmaJob {
  unsigned long long source;
  unsigned long long bytes;
  unsigned long long transfer;
};

#endif
