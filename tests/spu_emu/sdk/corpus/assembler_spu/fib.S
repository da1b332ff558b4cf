/* main(id, argp): sends Fibonacci numbers to the mailbox, argp of them, and returns the last one's lowest byte. */
#define COUNT $4
#define A $10
#define B $11
#define NEXT $12

	.text
	.align	3
	.global	main
	.type	main, @function
main:
	rotqbyi	COUNT, COUNT, 4	# the low word of a doubleword
	il	A, 0
	il	B, 1
	hbrr	branch, loop
loop:
	brz	COUNT, done
	a	NEXT, A, B
	ori	A, B, 0
	wrch	$ch28, B
	ori	B, NEXT, 0
	ai	COUNT, COUNT, -1
branch:
	br	loop
done:
	andi	$3, A, 0xff
	bi	$lr
	.size	main, .-main
