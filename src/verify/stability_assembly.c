/* SPDX-License-Identifier: MIT */
/* Assemblies: the biaxial test of 40 disks from soft to hard, and with laws of friction whose slope is infinite at Q =
 * mu P.
 *
 * The right answer is a test that ends with 0 < sin(phi) < 1 and closes its ledger to 2 % of the work of the walls. k_n
 * = 10 p presses the contacts of force chains deeper than the allowed 0.3 R: the run must stop, name one, and say which
 * k_n would hold. In between, up to some 300 p, the depth depends on the sample. */
#include "base/alloc.h"
#include "core/biaxial.h"
#include "core/ledger.h"
#include "core/step.h"
#include "verify/stability.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char sample[] = "kind: biaxial\nseed: 3\nsample: {disks: 40, r_min: 0.76 mm, r_max: 1.52 mm}\n"
                             "contact: {k_n: 160 MPa, mu: 0.5, mu_r: 0.1, k_r: 80 MPa}\n"
                             "compaction: {pressure: 160 kPa, inertial_number: 0.02, unbalanced: 1e-2}\n"
                             "shear: {inertial_number: 5e-3, strain_end: 0.03, walls: rough}\n";

typedef struct test_end {
    tr_status st;
    double sin_phi, residual; /* its mean; of the energy ledger, as a share of the work */
    bool finite;
} test_end;

static bool play(tr_verify *v, tr_biaxial *b, test_end *end) {
    tr_status *st = &end->st;
    double unbalanced;
    for (bool done = false; !done;)
        if (!tr_biaxial_compact(b, 200, &unbalanced, &done, st) || !tr_verify_go_on(v, st)) return false;
    if (!tr_biaxial_begin_shear(b, st)) return false;
    for (int64_t k = 0; k < b->shear_steps; k++) {
        if (!tr_biaxial_forces(b, st)) return false;
        if (k % 1000 == 0 && !tr_verify_go_on(v, st)) return false;
        if (k == b->shear_steps - 1) {
            tr_energy e = tr_ledger_read(&b->world);
            end->sin_phi = tr_biaxial_read(b).sin_phi;
            end->residual = e.residual / fabs(e.work);
        }
        tr_step_advance(&b->world);
    }
    return true;
}

static bool run(tr_verify *v, const char *const *sets, int n_sets, test_end *end, tr_status *st) {
    tr_scene scene;
    tr_biaxial *b = tr_alloc(1, sizeof *b, st);
    *end = (test_end){.residual = NAN};
    if (!b || !tr_scene_read(&scene, &(tr_scene_source){v->now->name, sample, strlen(sample), sets, n_sets}, tr_laws_catalog(), st))
        return free(b), false;
    if (tr_biaxial_init(b, &scene, &end->st)) {
        play(v, b, end);
        end->finite = tr_stability_readable(&b->world);
        tr_biaxial_free(b);
    }
    tr_scene_free(&scene);
    free(b);
    return end->st.code != TR_INTERRUPTED || tr_status_fail(st, TR_INTERRUPTED, "%s", end->st.text);
}

static bool add(tr_verify *v, const char *what, const test_end *end, bool may_run, tr_status *st) {
    char said[160];
    bool where = end->st.code == TR_NUMERICAL && strstr(end->st.text, "step") && strstr(end->st.text, "contact of") &&
                 strstr(end->st.text, "too soft for these stresses") && strstr(end->st.text, "it would hold");
    bool right = !end->st.code && end->sin_phi > 0.1 && end->sin_phi < 0.95 && fabs(end->residual) < 0.02;
    if (end->st.code)
        snprintf(said, sizeof said, "%.150s", end->st.text);
    else
        snprintf(said, sizeof said, "sin phi %.3f, energy residual %.1e of the work", end->sin_phi, end->residual);
    return tr_verify_outcome(v, what, said, end->finite && (may_run ? right : where), st);
}

bool tr_stability_biaxial(tr_verify *v, tr_status *st) {
    static const struct {
        double kappa;
        const char *strain, *seed; /* strain: the hardest is a hundred times slower than the one of 1000 */
        bool holds;
    } tests[] = {{10, "0.2", "3", false}, {500, "0.2", "1", true}, {500, "0.2", "2", true}, {500, "0.2", "3", true},
                 {1e3, "0.2", "3", true}, {1e5, "0.2", "3", true}, {1e7, "0.005", "3", true}};
    for (size_t i = 0; i < sizeof tests / sizeof *tests; i++) {
        char what[80], k_n[60], strain[60], seed[20];
        snprintf(what, sizeof what, "biaxial test, k_n/pressure %.0e, to strain %s, seed %s", tests[i].kappa,
                 tests[i].strain, tests[i].seed);
        snprintf(k_n, sizeof k_n, "contact.k_n=%g", tests[i].kappa * 160e3);
        snprintf(strain, sizeof strain, "shear.strain_end=%s", tests[i].strain);
        snprintf(seed, sizeof seed, "seed=%s", tests[i].seed);
        test_end end;
        if (!run(v, (const char *[]){k_n, strain, seed}, 3, &end, st) || !add(v, what, &end, tests[i].holds, st))
            return false;
    }
    return true;
}

bool tr_stability_full_slip(tr_verify *v, tr_status *st) {
    static const char *const friction[] = {"coulomb-spring", "dahlberg-alfredsson", "cattaneo-mindlin", "kuhn-creep",
                                           "vu-quoc-zhang"};
    for (int i = 0; i < 5; i++) {
        char law[60], what[60];
        snprintf(law, sizeof law, "contact.friction=%s", friction[i]),
            snprintf(what, sizeof what, "biaxial test, %s", friction[i]);
        const char *sets[] = {law, "contact.mu=0.1", "contact.E_star=400 MPa"};
        test_end end;
        if (!run(v, sets, i == 0 ? 2 : 3, &end, st) || !add(v, what, &end, true, st)) return false;
    }
    return true;
}
