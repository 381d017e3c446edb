/* SPDX-License-Identifier: MIT */
/* Geometry of the arcs: see arc.h. */
#include "draw/arc.h"

#include <math.h>

void tr_arc_angles(const tr_record *r, tr_arc *a, tr_arc *b) {
    double n = atan2(r->ny, r->nx);
    *a = (tr_arc){r->R1 < 0 ? n + M_PI : n, r->R1 != 0 ? r->da / r->R1 : 0}; /* of a ring n points to its centre */
    *b = (tr_arc){n + M_PI, r->R2 > 0 ? r->db / r->R2 : 0};
}

void tr_arc_wall(const tr_record *r, double *x, double *y) {
    *x = r->x - r->da * r->ny;
    *y = r->y + r->da * r->nx;
}
