/* SPDX-License-Identifier: MIT */
/* The time step: random networks (stability_network.h) at 0.1 to 2 times their exact limit. */
#include "base/alloc.h"
#include "base/quantile.h"
#include "core/timestep.h"
#include "verify/stability.h"
#include "verify/stability_network.h"
#include <stdio.h>
#include <stdlib.h>

enum { NETWORKS = 1000, STEPS = 400 };

typedef struct tally {
    double factor[NETWORKS],
        worst_share; /* limit/bound; of it in sqrt(z), which is the most it can be without damping */
    int unstable_below, wrong;
} tally;

static bool one(tr_verify *v, tr_network *net, tally *t, int i, tr_status *st) {
    double bound = tr_timestep_contacts(&net->w).dt, limit = tr_network_limit(net), a_step;
    double f = 0.1 + 1.9 * (i + 0.5) / NETWORKS;
    int z = 1;
    for (int k = 0; k < net->w.disks.n; k++)
        if (net->w.disks.coordination[k] > z) z = net->w.disks.coordination[k];
    t->factor[i] = limit / bound;
    if (net->zeta == 0) t->worst_share = fmax(t->worst_share, t->factor[i] / sqrt(z));
    t->unstable_below += !(tr_network_growth(net, 0.99 * bound, STEPS, &a_step, st) < TR_NETWORK_GROWN);
    bool grows = !(tr_network_growth(net, f * limit, STEPS, &a_step, st) < TR_NETWORK_GROWN);
    t->wrong += fabs(f - 1) > 0.02 && grows != (f > 1);
    const char *series = net->zeta > 0 ? "damped" : "undamped";
    const tr_verify_point grown = {series, f, "dt/limit", a_step, NAN, NAN, NAN, false},
                          told = {"bound", bound / limit, "dt/limit", NAN, NAN, NAN, NAN, false};
    return st->code == TR_OK && tr_verify_point_add(v, &grown, st) && tr_verify_point_add(v, &told, st);
}

bool tr_stability_networks(tr_verify *v, tr_status *st) {
    tr_network *net = tr_alloc(1, sizeof *net, st);
    tally *t = tr_alloc(1, sizeof *t, st);
    bool ok = net && t;
    for (int i = 0; ok && i < NETWORKS; i++) {
        ok = tr_verify_go_on(v, st) && tr_network_throw(net, i + 1, NULL, false, st) && one(v, net, t, i, st);
        tr_network_free(net);
    }
    if (ok) {
        tr_sort(t->factor, NETWORKS);
        double median = tr_quantile(t->factor, NETWORKS, 0.5);
        const tr_verify_row rows[] = {
            {"networks unstable at 0.99 of the bound", "1", 0, t->unstable_below, 0, "a bound is a bound", NAN, NULL},
            {"networks where leapfrog and Cholesky differ", "1", 0, t->wrong, 0, "dt beyond 2 % of the limit", NAN,
             NULL},
            {"least limit/bound, below 1", "1", 0, fmax(0, 1 - t->factor[0]), 1e-4,
             "contacts turn, LAP P/L, and overlaps round", NAN, NULL},
            {"median limit/bound, above 1", "1", 0, median - 1, 0.5, "wanted: at most 1.5", NAN, NULL},
            {"worst limit/(bound sqrt(contacts of a disk)), above 1", "1", 0, fmax(0, t->worst_share - 1), 1e-4,
             "a share m/z of a mass is m at most", NAN, NULL},
        };
        for (size_t k = 0; ok && k < sizeof rows / sizeof *rows; k++) ok = tr_verify_add(v, &rows[k], st);
        char text[80];
        snprintf(text, sizeof text, "limit/bound: median %.3f, worst %.2f", median, t->factor[NETWORKS - 1]);
        ok = ok && tr_verify_outcome(v, "what the bound gives away", text, true, st);
    }
    free(net), free(t);
    return ok;
}

/* Velocities that are not conjugate to the moments make K unsymmetric: then a mode may grow at any step, because the
 * law itself makes energy in closed cycles. Only for wang's velocity growth is excluded; for the others the rows count
 * it. */
bool tr_stability_not_conjugate(tr_verify *v, tr_status *st) {
    tr_network *net = tr_alloc(1, sizeof *net, st);
    bool ok = net != NULL;
    for (int k = 0; ok && k < tr_n_rolling_velocities; k++) {
        const char *velocity = tr_rolling_velocities[k].name; /* the first is wang */
        int grow = 0;
        for (int i = 0; ok && i < NETWORKS / 10; i++) {
            double a_step;
            ok = tr_verify_go_on(v, st) && tr_network_throw(net, i + 1, velocity, false, st);
            if (ok)
                grow += tr_network_growth(net, 0.1 * tr_timestep_contacts(&net->w).dt, 20 * STEPS, &a_step, st) >
                        TR_NETWORK_GROWN;
            tr_network_free(net);
            ok = ok && st->code == TR_OK;
        }
        char what[60], said[80];
        snprintf(what, sizeof what, "wang-spring, rolling_velocity: %s", velocity);
        snprintf(said, sizeof said, "%d of %d networks grow at 0.1 of the bound", grow, NETWORKS / 10);
        ok = ok && tr_verify_outcome(v, what, said, k > 0 || grow == 0, st);
    }
    free(net);
    return ok;
}
