int verbose, calls;
char *program_name;
