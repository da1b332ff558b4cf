// What the headers that all tests of spu_emu share are compiled with.
