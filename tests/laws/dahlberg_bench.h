/* SPDX-License-Identifier: MIT */
/* dahlberg-alfredsson alone on a tile of contacts that the test fills. */
#ifndef TR_TEST_DAHLBERG_BENCH_H
#define TR_TEST_DAHLBERG_BENCH_H

#include "assert_close.h"
#include "laws/law.h"
#include "scene/scene.h"
#include <string.h>

static const tr_law *law;
static tr_tile tile;
static double R1[TR_TILE], R2[TR_TILE], g1[TR_TILE], Q[TR_TILE], P_before[TR_TILE], par[TR_LAW_PAR];

static const double MU = 0.3, K_T = 3e8, E_STAR = 1e9;

static inline double sign(double x) {
    return (x > 0) - (x < 0);
}

static inline void set(const char *key, double value) {
    for (int i = 0; i < law->table.n; i++) {
        const tr_param *p = &law->table.params[i];
        if (strcmp(p->key, key)) continue;
        if (p->type == TR_CHOICE)
            *(int *)(void *)((char *)par + p->offset) = (int)value;
        else
            memcpy((char *)par + p->offset, &value, sizeof value);
        return;
    }
    fail_msg("no parameter %s", key);
}

/* Every lane a pair of radii a, b; a = 0: a wall. */
static inline void set_up(double a, double b) {
    for (int i = 0; i < tr_laws_catalog()->n_friction; i++)
        if (!strcmp(tr_laws_friction[i]->table.name, "dahlberg-alfredsson")) law = tr_laws_friction[i];
    assert_non_null(law);
    memset(&tile, 0, sizeof tile), memset(Q, 0, sizeof Q), memset(P_before, 0, sizeof P_before);
    memset(par, 0, sizeof par);
    set("mu", MU), set("k_t", K_T), set("E_star", E_STAR), set("creep_roll", 0);
    tile.n = TR_TILE, tile.R1 = R1, tile.R2 = R2, tile.g1 = g1;
    for (int i = 0; i < TR_TILE; i++) R1[i] = a, R2[i] = b, g1[i] = a > 0 ? a / (a + b) : 1;
}

static inline void run(void) {
    tr_law_data data = {.par = par, .hist = (double *[]){Q, P_before}};
    law->step(&tile, &data);
}

#endif
