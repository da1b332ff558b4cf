/* The game of life on a torus, typed in as one did before prototypes. */
#include <stdio.h>
#include <libspe2.h>

#define SIDE 16

extern spe_program_handle_t cells;
char board[SIDE][SIDE] __attribute__((aligned(128)));
int generation;

set(rows, at)
	char **rows;
	int at;
{
	int i, j;
	for (i = 0; rows[i]; i++)
		for (j = 0; rows[i][j]; j++)
			board[at + i][at + j] = rows[i][j] == '#';
}

show()
{
	register int i, j, alive = 0;
	printf("generation %d\n", generation);
	for (i = 0; i < SIDE; i++) {
		for (j = 0; j < SIDE; j++) {
			putchar(board[i][j] ? '#' : '.');
			alive += board[i][j];
		}
		putchar('\n');
	}
	printf("%d alive\n", alive);
}

main()
{
	static char *glider[] = { ".#.", "..#", "###", 0 };
	unsigned int entry;
	spe_context_ptr_t spe;
	set(glider, 1);
	spe = spe_context_create(0, 0);
	show();
	for (; generation < 24; generation += 12) {
		entry = SPE_DEFAULT_ENTRY;
		spe_program_load(spe, &cells);
		if (spe_context_run(spe, &entry, 0, board, (void *)12, 0) < 0)
			perror("life");
	}
	show();
	exit(0);
}
