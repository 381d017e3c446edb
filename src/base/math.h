/* SPDX-License-Identifier: MIT */
/* log, sin and their like: the same bits everywhere.
 *
 * The C library of a system rounds these in its own way, and glibc chooses by the processor. So the Makefile takes them
 * out of musl's libc.a (Debian: musl-dev; MIT licence), under these names and without anything else of musl. wasi-libc
 * has them of the same sources, for WebAssembly. A new function is declared here alone: the Makefile reads this.
 * + - * / sqrt, fabs, floor, rint, fmin, ldexp and the like are exact in every C library, and are taken from there. */
#ifndef TR_MATH_H
#define TR_MATH_H

double tr_log(double x);
double tr_log2(double x);
double tr_log10(double x);
double tr_log1p(double x);
double tr_exp(double x);
double tr_expm1(double x);
double tr_sin(double x);
double tr_cos(double x);
double tr_tan(double x);
double tr_asin(double x);
double tr_atan(double x);
double tr_atan2(double y, double x);
double tr_cbrt(double x);
double tr_hypot(double x, double y);
double tr_pow(double x, double y);

#endif
