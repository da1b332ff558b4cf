#include <spu_mfcio.h>

#define SIDE 16

char board[2][SIDE][SIDE] __attribute__((aligned(128)));

neighbours(b, i, j)
	char b[SIDE][SIDE];
	int i, j;
{
	int di, dj, n = 0;
	for (di = SIDE - 1; di <= SIDE + 1; di++)
		for (dj = SIDE - 1; dj <= SIDE + 1; dj++)
			n += b[(i + di) % SIDE][(j + dj) % SIDE];
	return n - b[i][j];
}

int main(id, ea, generations)
	unsigned long long id, ea, generations;
{
	int g, i, j, n;
	mfc_get(board[0], ea, sizeof board[0], 0, 0, 0);
	mfc_write_tag_mask(1);
	mfc_read_tag_status_all();
	for (g = 0; g < (int)generations; g++)
		for (i = 0; i < SIDE; i++)
			for (j = 0; j < SIDE; j++) {
				n = neighbours(board[g & 1], i, j);
				board[!(g & 1)][i][j] = n == 3 || (n == 2 && board[g & 1][i][j]);
			}
	mfc_put(board[g & 1], ea, sizeof board[0], 0, 0, 0);
	mfc_read_tag_status_all();
	return 0;
}
