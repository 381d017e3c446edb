/* SPDX-License-Identifier: MIT */
#include "cli/bench_case.h"

#include "laws/law.h"

/* The biaxial test of cases/biaxial.yaml: keys that are missing here have their defaults. E_star and k_r are for the
 * laws that --features adds. */
static const char default_case[] = "kind: biaxial\n"
                                   "sample: {r_min: 0.76 mm, r_max: 1.52 mm}\n"
                                   "contact: {k_n: 160 MPa, mu: 0.5, mu_r: 0.5, k_r: 0.5*k_n, E_star: 2.5*k_n}\n"
                                   "compaction: {pressure: 160 kPa}\n";

bool tr_cli_bench_case(const tr_bench_arguments *a, const char *const *more, int n, tr_scene *scene, tr_status *st) {
    const char *set[TR_BENCH_SETS + 4];
    int n_set = a->n_set;
    for (int i = 0; i < n_set; i++) set[i] = a->set[i];
    for (int i = 0; i < n; i++) set[n_set++] = more[i];
    bool ok =
        a->file ? tr_scene_read_file(scene, a->file, set, n_set, tr_laws_catalog(), st)
                : tr_scene_read(scene,
                                &(tr_scene_source){"(default case)", default_case, sizeof default_case - 1, set, n_set},
                                tr_laws_catalog(), st);
    if (ok && scene->kind != TR_KIND_BIAXIAL)
        ok = tr_status_fail(st, TR_BAD_CASE, "error: bench needs a case of kind: biaxial");
    if (ok && *scene->sample.file)
        ok = tr_status_fail(st, TR_BAD_CASE, "error: bench throws its samples; sample.file is for trundle run");
    return ok;
}
