/* SPDX-License-Identifier: MIT */
/* To add a format, add its functions and a row. */
#include "study/convert.h"

#include "base/alloc.h"
#include "out/dir.h"
#include "study/convert_frames.h"
#include "base/math.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* What a format writes of an instant into its files: one file for all, or one for each. */
typedef void write_instant(FILE *out, const tr_frames *f, int k);
typedef struct format {
    const char *name;
    const char *file[2]; /* with %: the number of the instant, a file for each; NULL: no more */
    write_instant *write[2];
} format;

/* ---- LAMMPS: dump custom and dump local [LAMMPS text dumps], as OVITO and LAMMPS' rerun read them */

static void lammps_head(FILE *out, const tr_frames *f, int k, const char *what, int n) {
    const tr_frame_at *at = &f->frame[k];
    const char *edge = f->periodic ? "pp pp pp" : "ff ff pp";
    fprintf(out, "ITEM: TIME\n%.17g\nITEM: TIMESTEP\n%d\nITEM: NUMBER OF %s\n%d\nITEM: BOX BOUNDS %s\n", at->time, k,
            what, n, edge);
    double depth = 0.5 * (at->box[0][1] - at->box[0][0]);
    fprintf(out, "%.17g %.17g\n%.17g %.17g\n%.17g %.17g\n", at->box[0][0], at->box[0][1], at->box[1][0], at->box[1][1],
            -depth, depth);
}

static void lammps_disks(FILE *out, const tr_frames *f, int k) {
    const tr_frame_at *at = &f->frame[k];
    lammps_head(out, f, k, "ATOMS", at->n);
    fputs("ITEM: ATOMS id type x y z radius vx vy vz omegax omegay omegaz\n", out);
    for (int i = 0; i < at->n; i++) {
        const tr_frame_disk *d = &at->disk[i];
        fprintf(out, "%d 1 %.9g %.9g 0 %.9g %.9g %.9g 0 0 0 %.9g\n", i + 1, d->x, d->y, d->radius, d->vx, d->vy,
                d->spin);
    }
}

/* Numbers as in LAMMPS from 1; walls 0, -1, -2, ... */
static void lammps_contacts(FILE *out, const tr_frames *f, int k) {
    const tr_frame_at *at = &f->frame[k];
    lammps_head(out, f, k, "ENTRIES", at->n_contacts);
    fputs("ITEM: ENTRIES index id1 id2 x y nx ny overlap fn ft moment1 moment2 vs vr\n", out);
    for (int i = 0; i < at->n_contacts; i++) {
        const tr_frame_contact *c = &at->contact[i];
        fprintf(out, "%d %d %d %.9g %.9g %.9g %.9g %.9g %.9g %.9g %.9g %.9g %.9g %.9g\n", i + 1, c->a + 1, c->b + 1,
                c->x, c->y, c->nx, c->ny, c->overlap, c->f_n, c->f_t, c->moment_a, c->moment_b, c->v_s, c->v_r);
    }
}

/* ---- extended XYZ, as ASE and OVITO read it: disks alone */

static void extxyz_disks(FILE *out, const tr_frames *f, int k) {
    const tr_frame_at *at = &f->frame[k];
    double width = at->box[0][1] - at->box[0][0], height = at->box[1][1] - at->box[1][0];
    fprintf(out,
            "%d\nLattice=\"%.9g 0 0 0 %.9g 0 0 0 %.9g\" Origin=\"%.9g %.9g 0\" pbc=\"%s\" "
            "Properties=species:S:1:pos:R:3:radius:R:1:velo:R:3:omega:R:3 Time=%.9g\n",
            at->n, width, height, width, at->box[0][0], at->box[1][0], f->periodic ? "T T F" : "F F F", at->time);
    for (int i = 0; i < at->n; i++) {
        const tr_frame_disk *d = &at->disk[i];
        fprintf(out, "D %.9g %.9g 0 %.9g %.9g %.9g 0 0 0 %.9g\n", d->x, d->y, d->radius, d->vx, d->vy, d->spin);
    }
}

/* ---- VTK, legacy, an unstructured grid: a vertex for each disk, a line for each contact, from a to b. Where a is
 * a wall or an image in a periodic cell the line begins at a point of its own, of radius 0. */

static bool needs_point(const tr_frame_at *at, const tr_frame_contact *c, double from[2]) {
    const tr_frame_disk *b = &at->disk[c->b], *a = c->a < 0 ? NULL : &at->disk[c->a];
    double L = b->radius + (a ? a->radius : 0) - c->overlap;
    from[0] = b->x - L * c->nx, from[1] = b->y - L * c->ny;
    return !a || tr_hypot(a->x - from[0], a->y - from[1]) > 1e-3 * b->radius;
}

static void vtk_points(FILE *out, const tr_frame_at *at, int points) {
    double from[2];
    fprintf(out, "POINTS %d double\n", points);
    for (int i = 0; i < at->n; i++) fprintf(out, "%.9g %.9g 0\n", at->disk[i].x, at->disk[i].y);
    for (int i = 0; i < at->n_contacts; i++)
        if (needs_point(at, &at->contact[i], from)) fprintf(out, "%.9g %.9g 0\n", from[0], from[1]);
}

static void vtk_cells(FILE *out, const tr_frame_at *at) {
    double from[2];
    int own = at->n;
    fprintf(out, "CELLS %d %d\n", at->n + at->n_contacts, 2 * at->n + 3 * at->n_contacts);
    for (int i = 0; i < at->n; i++) fprintf(out, "1 %d\n", i);
    for (int i = 0; i < at->n_contacts; i++) {
        const tr_frame_contact *c = &at->contact[i];
        int a = needs_point(at, c, from) ? own++ : c->a;
        fprintf(out, "2 %d %d\n", a, c->b);
    }
    fprintf(out, "CELL_TYPES %d\n", at->n + at->n_contacts);
    for (int i = 0; i < at->n + at->n_contacts; i++) fprintf(out, "%d\n", i < at->n ? 1 : 3);
}

/* A scalar of the disks, then 0 of the other points; or of the contacts, after 0 of the disks. */
static void vtk_scalar(FILE *out, const char *name, const tr_frame_at *at, size_t offset, bool contacts, int others) {
    const char *rows = contacts ? (const char *)at->contact : (const char *)at->disk;
    size_t size = contacts ? sizeof *at->contact : sizeof *at->disk;
    fprintf(out, "SCALARS %s double 1\nLOOKUP_TABLE default\n", name);
    for (int i = 0; contacts && i < others; i++) fputs("0\n", out);
    for (int i = 0; i < (contacts ? at->n_contacts : at->n); i++) {
        double v;
        memcpy(&v, rows + (size_t)i * size + offset, sizeof v);
        fprintf(out, "%.9g\n", v);
    }
    for (int i = 0; !contacts && i < others; i++) fputs("0\n", out);
}

static void vtk_all(FILE *out, const tr_frames *f, int k) {
    const tr_frame_at *at = &f->frame[k];
    double from[2];
    int own = 0;
    for (int i = 0; i < at->n_contacts; i++) own += needs_point(at, &at->contact[i], from);
    fprintf(out, "# vtk DataFile Version 3.0\ntrundle, time %.9g s\nASCII\nDATASET UNSTRUCTURED_GRID\n", at->time);
    vtk_points(out, at, at->n + own);
    vtk_cells(out, at);
    fprintf(out, "POINT_DATA %d\n", at->n + own);
    vtk_scalar(out, "radius", at, offsetof(tr_frame_disk, radius), false, own);
    vtk_scalar(out, "angle", at, offsetof(tr_frame_disk, angle), false, own);
    vtk_scalar(out, "vx", at, offsetof(tr_frame_disk, vx), false, own);
    vtk_scalar(out, "vy", at, offsetof(tr_frame_disk, vy), false, own);
    vtk_scalar(out, "spin", at, offsetof(tr_frame_disk, spin), false, own);
    fprintf(out, "CELL_DATA %d\n", at->n + at->n_contacts);
    vtk_scalar(out, "f_n", at, offsetof(tr_frame_contact, f_n), true, at->n);
    vtk_scalar(out, "f_t", at, offsetof(tr_frame_contact, f_t), true, at->n);
    vtk_scalar(out, "moment_a", at, offsetof(tr_frame_contact, moment_a), true, at->n);
    vtk_scalar(out, "moment_b", at, offsetof(tr_frame_contact, moment_b), true, at->n);
    vtk_scalar(out, "v_s", at, offsetof(tr_frame_contact, v_s), true, at->n);
    vtk_scalar(out, "v_r", at, offsetof(tr_frame_contact, v_r), true, at->n);
}

/* ---- the table */

#define FORMATS(X)                                                                                                     \
    X("lammps", "disks.dump and contacts.dump, as of dump custom and dump local", "disks.dump", lammps_disks,          \
      "contacts.dump", lammps_contacts)                                                                                \
    X("extxyz", "disks.xyz, extended XYZ, which has no place for contacts", "disks.xyz", extxyz_disks, NULL, NULL)     \
    X("vtk", "0000.vtk and so on: disks as vertices, contacts as lines with their forces", "%04d.vtk", vtk_all, NULL,  \
      NULL)
#define ROW(name, doc, file, write, file_2, write_2) {name, {file, file_2}, {write, write_2}},
#define TEXT(name, doc, ...) "  " name "\t" doc "\n"
static const format formats[] = {FORMATS(ROW)};
const char tr_convert_formats[] = FORMATS(TEXT);

static bool write_file(const format *m, int which, const tr_frames *f, const char *to, int *files, tr_status *st) {
    bool each = strchr(m->file[which], '%');
    for (int k = 0; k < (each ? f->n : 1); k++) {
        char name[32];
        tr_file file;
        if (each)
            snprintf(name, sizeof name, "%04d.vtk", k);
        else
            snprintf(name, sizeof name, "%s", m->file[which]);
        if (!tr_file_open(&file, to, name, st)) return false;
        for (int i = each ? k : 0; i < (each ? k + 1 : f->n); i++) m->write[which](file.stream, f, i);
        if (!tr_file_commit(&file, st)) return false;
        (*files)++;
    }
    return true;
}

bool tr_convert(const char *run, const char *name, const char *to, int *files, tr_status *st) {
    const format *m = NULL;
    int lock = -1;
    for (int k = 0; k < (int)(sizeof formats / sizeof *formats); k++)
        if (!strcmp(formats[k].name, name)) m = &formats[k];
    if (!m)
        return tr_status_fail(st, TR_BAD_CASE, "error: no format is called %s; there are\n%s", name,
                              tr_convert_formats);
    tr_frames f;
    bool ok = tr_frames_read(&f, run, st) && tr_dir_lock(to, &lock, st);
    *files = 0;
    for (int k = 0; ok && k < 2 && m->file[k]; k++) ok = write_file(m, k, &f, to, files, st);
    tr_frames_free(&f);
    if (lock >= 0) close(lock);
    return ok;
}
