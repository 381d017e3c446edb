/* SPDX-License-Identifier: MIT */
/* summary.json: the results of a run. It is written last and marks the run as finished. */
#ifndef TR_SUMMARY_H
#define TR_SUMMARY_H

#include "core/biaxial.h"
#include "core/bodies.h"
#include "core/ledger.h"
#include "core/measures.h"

typedef struct tr_timing {
    double wall_s,
        contact_updates_per_s; /* of the shear (biaxial) or the whole run (bodies, contact), outputs left out of
                                * bodies */
} tr_timing;

/* The rows of the shear, for the summary. */
typedef struct tr_series {
    int n;
    double *strain, *sin_phi, *void_ratio;
    tr_measures *measures;
} tr_series;

/* The main results of a biaxial test. */
typedef struct tr_strength {
    double sin_phi_peak;     /* largest running mean over 0.5 % strain */
    double strain_peak;      /* strain at the middle of that window */
    double sin_phi_residual; /* mean over the last quarter of the strain: 15-20 % of 20 % */
    double e_residual;       /* void ratio, the same mean */
    tr_measures residual;    /* the same mean of each */
    double residual_from;    /* strain at which the last quarter starts */
} tr_strength;

/* What a law, or the solver of kind: patch, did on the path of a contact. */
typedef struct tr_path_result {
    char label[160];                                   /* in the legend of the curves */
    const char *solver;                                /* kind: patch; NULL: a law */
    const char *friction, *rolling, *rolling_velocity; /* of a law; rolling_velocity NULL: it does not use it */
    double Q_end, q_end, Q_max;                    /* at the end: friction, and over mu P; its greatest size [N/m] */
    double moment_1_end, moment_2_end, moment_max; /* rolling moments [N] */
    double u_slide_end, dissipated;                /* [m]; kind: patch: along the path [N] (J per metre) */
    int64_t merged;                                /* what did not fit into the friction law's history; see tr_law */
} tr_path_result;

/* One of the checks of a scene. */
typedef struct tr_check_result {
    const char *lane; /* label of its document; "" */
    tr_shape shape;
    const tr_scene_check *check;
    const char *what, *unit; /* unit: for tr_param_by_shape */
    char of[TR_CONTACT_NAME];   /* "wall0-3", "disk 2", "laws.0, path.2" */
    double measured;       /* NaN: it did not happen */
    bool ok;
} tr_check_result;

/* How good the two strengths of one sample are, with 95 %: study/spread.h. */
typedef struct tr_accuracy {
    char row[160];          /* the measured spread that it uses; "": none fits this case, so there are no numbers */
    char not_examined[120]; /* then: why */
    struct tr_strength_accuracy {
        double half;            /* the mean of all samples differs by at most this [1] */
        double aim;             /* a smaller half-width, */
        int seeds;              /* number of seeds for that */
        double step, step_half; /* change by half the step, and half of its interval [1] */
    } strength[2];              /* peak, residual */
} tr_accuracy;
typedef struct tr_strength_accuracy tr_strength_accuracy;

tr_strength tr_summary_strength(const tr_series *series);

/* What summary.json says of a biaxial test. */
typedef struct tr_biaxial_result {
    double e0, unbalanced; /* after the compaction [1] */
    tr_strength strength;
    double mean_stress_2;    /* [Pa] */
    const tr_energy *energy; /* NULL: no ledger was kept */
    int64_t paths_bytes;     /* size of paths.csv, which a replay checks; 0: no such file */
    tr_accuracy accuracy;
    tr_timing timing;
} tr_biaxial_result;

/* Text of summary.json (free()); NULL: out of memory. Runs of the same case give the same text, except "timing". */
char *tr_summary_biaxial(const tr_scene *scene, const tr_biaxial *b, const tr_biaxial_result *result, tr_status *st);
/* b: of the scene, and of scene->more; result: n of them. */
char *tr_summary_bodies(const tr_scene *scene, const tr_bodies *const *b, const tr_check_result *result, int n,
                        const tr_timing *timing, tr_status *st);
/* kind: contact, patch. result: one of each law, or that of the solver; check: of scene->checks. */
char *tr_summary_path(const tr_scene *scene, int64_t steps, const tr_path_result *result, const tr_check_result *check,
                      const tr_timing *timing, tr_status *st);

#endif
