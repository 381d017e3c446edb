/* SPDX-License-Identifier: MIT */
#include "out/table.h"

#include <math.h>
#include <stdarg.h>
#include <string.h>

void tr_row_add(tr_row *row, double value, const char *name_format, ...) {
    if (row->n++ >= TR_MAX_CELLS) return; /* writing fails */
    tr_cell *cell = &row->cell[row->n - 1];
    char name[TR_BY_SHAPE], part[TR_BY_SHAPE];
    va_list args;
    va_start(args, name_format);
    vsnprintf(name, sizeof name, name_format, args);
    va_end(args);
    snprintf(cell->name, sizeof cell->name, "%s", tr_param_by_shape(name, row->shape, part));
    for (char *p = cell->name; *p; p++) *p = *p == '-' ? '_' : *p; /* an identifier; a hyphen is a minus elsewhere */
    cell->value = value;
}

void tr_row_add_in(tr_row *row, double value, const char *name, const char *unit) {
    char part[TR_BY_SHAPE], text[TR_BY_SHAPE] = "";
    const char *u = tr_param_by_shape(unit, row->shape, part);
    size_t used = 0;
    for (u = strcmp(u, "1") == 0 ? "" : u; *u && used + 6 < sizeof text; u++)
        used += (size_t)sprintf(text + used, *u == '/' ? "_per_" : *u == '*' ? "_" : "%c", *u);
    tr_row_add(row, value, "%s%s%s", name, *text ? "_" : "", text);
}

void tr_cell_put(FILE *file, double value, int digits) {
    if (isfinite(value)) fprintf(file, "%.*g", digits, value);
}

void tr_row_header(const tr_row *row, tr_file *file) {
    if (row->n > TR_MAX_CELLS || ftell(file->stream) != 0) return;
    for (int i = 0; i < row->n; i++) fprintf(file->stream, "%s%c", row->cell[i].name, i + 1 < row->n ? ',' : '\n');
}

static bool write_cells(const tr_row *row, tr_file *file, int digits, tr_status *st) {
    if (row->n > TR_MAX_CELLS)
        return tr_status_fail(st, TR_FILE, "error: a table of %d columns, at most %d are written", row->n,
                              TR_MAX_CELLS);
    tr_row_header(row, file);
    for (int i = 0; i < row->n; i++) {
        tr_cell_put(file->stream, row->cell[i].value, digits);
        putc(i + 1 < row->n ? ',' : '\n', file->stream);
    }
    return true;
}

bool tr_row_write(const tr_row *row, tr_file *file, tr_status *st) {
    return write_cells(row, file, 9, st) && tr_file_check(file, st);
}

bool tr_row_write_exact(const tr_row *row, tr_file *file, tr_status *st) {
    return write_cells(row, file, 17, st) && (!ferror(file->stream) || tr_file_check(file, st));
}

void tr_row_biaxial(tr_row *row, const tr_biaxial_state *s, const tr_measures *m, const tr_energy *e) {
#define STATE(name, unit) tr_row_add_in(row, s->name, #name, unit);
#define MEASURE(name, unit, quoted) tr_row_add_in(row, m->name, #name, unit);
#define ENERGY(name) tr_row_add_in(row, e->name, #name, "J/m|J");
    row->n = 0;
    TR_BIAXIAL_STRESSES(STATE)
    TR_CONTACT_MEASURES(MEASURE)
    tr_row_add(row, tr_biaxial_tan_phi(s->sin_phi), "tan_phi");
    tr_row_add(row, 2 * s->sin_phi, "q_over_p"); /* q = s1 - s2, p = (s1 + s2)/2 */
    TR_FORCE_MEASURES(MEASURE)
    TR_BIAXIAL_BOX(STATE)
    if (!e) return;
    TR_ENERGIES(ENERGY)
    tr_row_add_in(row, e->made[TR_NORMAL], "damped_made", "J/m|J");
    tr_row_add_in(row, e->made[TR_FRICTION], "friction_made", "J/m|J");
    tr_row_add_in(row, e->made[TR_ROLLING], "rolling_made", "J/m|J");
}

static void add_spread(tr_row *row, tr_spread s, const char *name) {
    tr_row_add(row, s.q1, "%s_q1", name);
    tr_row_add(row, s.median, "%s_median", name);
    tr_row_add(row, s.q3, "%s_q3", name);
    tr_row_add(row, s.mean, "%s_mean", name);
}

void tr_row_increments(tr_row *row, const tr_increments_state *s, double R) {
#define INCREMENT(field, name, over) tr_row_add(row, s->field / (over), name);
#define SPREAD(field, name) add_spread(row, s->field, name);
    TR_INCREMENTS(INCREMENT, SPREAD)
}

void tr_row_contact(tr_row *row, double time, double strain, const tr_record *c) {
    tr_row_add(row, time, "time_s");
    if (strain >= 0) tr_row_add(row, strain, "strain");
    tr_row_add(row, c->a, "a");
    tr_row_add(row, c->b, "b");
    tr_row_add(row, c->x, "x_m");
    tr_row_add(row, c->y, "y_m");
    tr_row_add(row, c->nx, "nx");
    tr_row_add(row, c->ny, "ny");
    tr_row_add(row, c->delta, "overlap_m");
    tr_row_add(row, c->f_n, "f_n_N_per_m|f_n_N");
    tr_row_add(row, c->f_t, "f_t_N_per_m|f_t_N");
    tr_row_add(row, c->f_r, "f_r_N_per_m|f_r_N"); /* along t, of a rolling law */
    tr_row_add(row, c->m1, "moment_a_N|moment_a_N_m");
    tr_row_add(row, c->m2, "moment_b_N|moment_b_N_m");
    tr_row_add(row, c->v_s, "v_s_m_per_s");
    tr_row_add(row, c->v_r, "v_r_m_per_s");
    tr_row_add(row, c->mobilisation, "mobilisation");
    tr_row_add(row, c->rolling_mobilisation, "rolling_mobilisation");
    tr_row_add(row, c->s1, "s1_m_per_s");
    tr_row_add(row, c->s2, "s2_m_per_s");
    for (int v = 0; v < tr_n_rolling_velocities; v++)
        tr_row_add(row, c->v_r_by[v], "v_r_%s_m_per_s", tr_rolling_velocities[v].name);
    for (int v = 0; v < tr_n_sliding_velocities; v++)
        tr_row_add(row, c->v_s_by[v], "v_s_%s_m_per_s", tr_sliding_velocities[v].name);
    if (strain >= 0) return;
    tr_row_add(row, c->da, "da_m");
    tr_row_add(row, c->db, "db_m");
}

void tr_row_increment(tr_row *row, const tr_increment *s) {
    tr_row_add(row, s->followed, "followed");
    tr_row_add(row, s->slide + 0.0, "u_slide_m"); /* a zero has no sign in a table */
    tr_row_add(row, s->roll + 0.0, "u_roll_m");
    tr_row_add(row, s->creep + 0.0, "u_creep_m");
}

void tr_row_disk(tr_row *row, double time, const tr_world *world, int i) {
    const double *pos = world->disks.pos + tr_body(i);
    double velocity[3];
    tr_bodies_velocity(world, i, velocity);
    tr_row_add(row, time, "time_s");
    tr_row_add(row, i, "disk");
    tr_row_add(row, pos[0], "x_m");
    tr_row_add(row, pos[1], "y_m");
    tr_row_add(row, pos[2], "angle_rad");
    tr_row_add(row, velocity[0], "vx_m_per_s");
    tr_row_add(row, velocity[1], "vy_m_per_s");
    tr_row_add(row, velocity[2], "spin_rad_per_s");
}

void tr_row_sample(tr_row *row, double time, double strain, const tr_world *world, int i, double v_r, int ends) {
    tr_row_disk(row, time, world, i);
    tr_row_add(row, strain, "strain");
    tr_row_add(row, world->disks.pos[tr_body(i) + TR_RADIUS], "radius_m");
    tr_row_add(row, v_r, "mean_v_r_m_per_s");
    tr_row_add(row, ends, "contacts");
}
