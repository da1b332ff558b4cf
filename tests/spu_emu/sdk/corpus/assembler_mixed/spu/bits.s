# unsigned int bits(const vector unsigned char *from, unsigned int quadwords): how many bits are set.
	.text
	.align	3
	.global	bits
	.type	bits, @function
bits:
	il	$5, 0
	brz	$4, done
next:
	lqd	$6, 0($3)
	cntb	$6, $6
	sumb	$6, $6, $6
	a	$5, $5, $6
	ai	$3, $3, 16
	ai	$4, $4, -1
	brnz	$4, next
done:
	shlqbyi	$7, $5, 4
	a	$5, $5, $7
	shlqbyi	$7, $5, 8
	a	$5, $5, $7
	andi	$6, $5, -1
	ila	$7, 0xffff
	and	$6, $6, $7
	ori	$3, $6, 0
	bi	$0
	.size	bits, .-bits
