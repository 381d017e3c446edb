/* SPDX-License-Identifier: MIT */
/* TR_VECTOR marks a loop over arrays that is compiled for several vector widths; the program chooses the best at its
 * start. The results are the same bits in each: no reduction is reordered and -ffp-contract=off forbids fused
 * multiply-add. */
#ifndef TR_VECTOR_H
#define TR_VECTOR_H

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define TR_VECTOR __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define TR_VECTOR
#endif

/* Four doubles that move as one: the state of a disk (core/world.h). Lanes are read like an array: q[0]. A GNU C
 * vector: gcc and clang split it on machines without such registers. */
typedef double tr_quad __attribute__((vector_size(32), may_alias));

#endif
