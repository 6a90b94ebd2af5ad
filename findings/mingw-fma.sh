#!/usr/bin/env bash
# mingw-w64 10.0.0 (Debian 12): fma() of double is not the rounded value of a*b + c.
#
# Guessed: fma(a, b, -a*b) is the rounding error of a product, as ISO C says of fma ("rounded as one ternary operation") and as glibc and Microsoft's
#   own C library have it; so that double-double arithmetic may build on it.
# Seen: fma(a, b, -a*b), whose true value is a double, is wrong for 5.5 of 100 pairs of random doubles (0x1.7662c69cc388p-61 for
#   0x1.7662ce9cc388p-61), of numbers with 48 bits for none; fma(a, b, c) with c of the product's size for 31 of 100.
# Who carries rounding errors along splits products by hand (Dekker 1971), or asks for -mfma.
#
# Exit status: 0 as described, 1 something has changed. Needs amd64, gcc and binutils; runs the library's object file here, by Windows' calling convention.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download --quiet=2 mingw-w64-x86-64-dev=10.0.0-3
dpkg -x mingw-w64-x86-64-dev_*.deb .
ar x usr/x86_64-w64-mingw32/lib/libmingwex.a lib64_libmingwex_a-fma.o
objcopy -O elf64-x86-64 --remove-section=.pdata --remove-section=.xdata --remove-section=.comment --redefine-sym fma=mingw_fma lib64_libmingwex_a-fma.o fma.o
cat >try.c <<'C'
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
__attribute__((ms_abi)) double mingw_fma(double, double, double);
/* Of 53 random bits. */
static double number(int spread) {
    const long long bits = (long long)(rand() & 0x3ffffff) << 27 | (rand() & 0x7ffffff);
    return ldexp(bits * (rand() & 1 ? 0x1p-53 : -0x1p-53), spread ? rand() % (2 * spread) - spread : 0);
}
int main(void) {
    enum { kTries = 100000 };
    int products = 0, sums = 0;
    for (int i = 0; i < kTries; ++i) {
        const double a = number(100), b = number(100), ab = a * b, c = ab * number(0);
        products += mingw_fma(a, b, -ab) != fma(a, b, -ab);   /* fma: glibc's, which is exact */
        sums += mingw_fma(a, b, c) != fma(a, b, c);
    }
    printf("wrong: %.1f %% of the products' errors, %.1f %% of sums\n", 100.0 * products / kTries, 100.0 * sums / kTries);
    return !(products > 0.03 * kTries && products < 0.08 * kTries && sums > 0.25 * kTries && sums < 0.37 * kTries);
}
C
gcc -O1 -ffp-contract=off try.c fma.o -no-pie -z noexecstack -lm -o try
./try || { echo "changed"; exit 1; }
