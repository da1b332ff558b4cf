#define COUNT 256

extern unsigned int values[COUNT];

void read_values(unsigned long long ea);
void sort_values(void);
unsigned int report_values(unsigned long long ea);
