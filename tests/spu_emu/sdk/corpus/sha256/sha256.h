void sha256_block(unsigned int state[8], const unsigned int words[16]);
